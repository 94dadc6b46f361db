"""The schemas of answer files and of changes: they take what is read, and refuse what is not."""

import pytest
from jsonschema import Draft202012Validator
from yaml import safe_load

from solver.classroom.blank import blank_answers
from solver.classroom.reading.change_file import read_changes
from solver.classroom.schema import answers_schema, changes_schema
from solver.problem.source import InputError, Source
from tests.helpers.marked import solved

PROBLEM = """\
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find: {a: eigenstructure, b: characteristic_polynomial}
"""
ANSWERS = """\
student: A-17
answers:
  a: {eigenvalues: [1, "-3 ± 2j"], right_eigenvectors: [[1, s], [0.5, 1]], diagonalizable: true}
  b: lambda^2
"""


def fits(schema, text):
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema).is_valid(safe_load(text))


def test_answers_fit_the_schema_of_all_and_that_of_their_problem():
    problem = solved(PROBLEM).problem
    for schema in (answers_schema(), answers_schema(problem)):
        assert fits(schema, ANSWERS)
        assert fits(schema, blank_answers(solved(PROBLEM), "problem.yaml"))
        assert not fits(schema, "student: A-17")
        assert not fits(schema, ANSWERS + "marks: 10\n")


@pytest.mark.parametrize("answers", ["{c: {K: 1}}", "{a: {K: 1}}", "[1]"])
def test_other_parts_and_names_do_not_fit_the_problem(answers):
    assert not fits(answers_schema(solved(PROBLEM).problem), f"answers: {answers}")


@pytest.mark.parametrize(
    ("text", "right"),
    [
        ("changes: {A-17: {comment: x, a: {comment: y, K: {verdict: correct, marks: 2.5, comment: z}}}}", True),
        ("changes: {A-17: {a: {K: {marks: 1/3}}}}", True),
        ("changes: {A-17: {a: {K: {verdict: right}}}}", False),
        ("changes: {A-17: {a: {K: {mark: 1}}}}", False),
        ("changes: {A-17: {a: 3}}", False),
        ("change: {}", False),
    ],
)
def test_changes_fit_their_schema_where_they_are_read(text, right):
    assert fits(changes_schema(), text) == right
    if right:
        assert read_changes(Source("changes.yaml", text)).students
    else:
        with pytest.raises(InputError):
            read_changes(Source("changes.yaml", text))
