"""Answer files are as hostile as problem files: every fault has a place, and words."""

import pytest

from solver.classroom import read_submission
from solver.classroom.reading.answer_file import meant_answer
from solver.problem.source import InputError, Source
from tests.helpers.marked import marked, solved

pytestmark = pytest.mark.xdist_group("answer_file")  # its problem is solved once

PLANT = "system: {A: [[0, 1], [-2, -3]], B: [0, 1]}\nfind: {a: eigenstructure, b: controllability}\n"


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("answers: {c: {rank: 1}}", ":1:11:", "the problem has no part 'c'"),
        ("answer: {a: {rank: 1}}", ":1:1:", "did you mean 'answers'"),
        ("answers: [1, 2]", ":1:10:", "'answers:' must list"),
        ("- 1", ":1:1:", "an answer file is a mapping"),
        ("answers: {b: {rank: 1, rank: 2}}", ":1:", "twice"),
    ],
)
def test_a_file_that_is_no_yaml_or_names_no_part_is_at_fault(text, place, words):
    with pytest.raises(InputError) as caught:
        marked(PLANT, text)
    message = caught.value.render()
    assert place in message
    assert words in message


@pytest.mark.parametrize(
    ("values", "name", "column", "words"),
    [
        ("a: {eigenvalues: [1, 2+]}", "eigenvalues", 34, "expected"),
        ("a: {eigenvalues: [1, 1/2x/]}", "eigenvalues", 37, "expected"),
        ("b: {controllability_matrix: [[1, 2], [3]]}", "controllability_matrix", 39, "same length"),
        ("b: {controllable: maybe}", "controllable", 29, "yes or no"),
        ("b: {rank: '1 ± 2'}", "rank", 21, "stands for two values"),
        ("b: {rank: __import__('os')}", "rank", 21, ""),
        ("b: {controllability_matrix: [[1, [2, 3]]]}", "controllability_matrix", 44, "a value is expected"),
    ],
)
def test_a_value_that_cannot_be_read_is_not_judged_and_costs_nothing_but_itself(values, name, column, words):
    part = values[0]
    other = "b: {rank: 2}" if part == "a" else "a: {diagonalizable: yes}"
    found = marked(PLANT, f"student: Ada\nanswers: {{{values}, {other}}}")
    verdict = found[part].answers[name]
    assert verdict.verdict == "not judged"
    assert f"line 2, column {column}" in verdict.reason
    assert words in verdict.reason
    (right,) = found[other[0]].answers.values()
    assert right.verdict == "correct"


@pytest.mark.parametrize("blank", ["", "null", '""', '"  "'])
def test_what_is_left_blank_is_not_answered(blank):
    found = marked(PLANT, f"answers:\n  a: {{eigenvalues: {blank}}}\n  b: {{rank: 2, controllable: {blank}}}\n")
    assert (found["a"].answers, found["a"].note) == ({}, "not answered")
    assert list(found["b"].answers) == ["rank"]


def test_what_nobody_asked_for_is_remarked_and_the_rest_is_judged():
    text = "sheet: 3\nstudent: Ada\nanswers: {a: {eigenvalue: [1], diagonalizable: yes}, c: {rank: 1}, b: 2, d: }\n"
    submission = read_submission(Source("answers.yaml", text), solved(PLANT).problem)
    assert (submission.student, list(submission.answers)) == ("Ada", ["a", "b"])
    assert [(each.line, each.column, each.suggestion) for each in submission.strange] == [
        (1, 1, ""), (3, 15, "eigenvalues"), (3, 54, ""), (3, 71, ""), (3, 74, ""),
    ]  # fmt: skip
    found = marked(PLANT, text)
    assert found["a"].answers["diagonalizable"].verdict == "correct"
    assert found["b"].note == "not answered"


def test_a_matrix_of_the_wrong_shape_is_wrong_and_not_a_fault():
    found = marked(PLANT, "answers: {b: {controllability_matrix: [[0, 1, 2], [1, -3, 4]]}}")
    answer = found["b"].answers["controllability_matrix"]
    assert (answer.verdict, answer.reason) == ("wrong", "it must be 2×2; this one is 2×3")


@pytest.mark.parametrize("rank", ["|2|", "%2", "{{2}}/1", "[2]*[1]", "`2`", "2 'of 2"])
def test_a_value_that_keeps_the_file_from_being_yaml_costs_nothing_but_itself(rank):
    found = marked(PLANT, f"answers:\n  b:\n    rank: {rank}\n    controllable: yes\n")["b"].answers
    assert found["controllable"].verdict == "correct"
    assert found["rank"].verdict in ("correct", "not judged")


def test_lists_over_several_lines_are_left_as_they_are():
    text = "answers:\n  b:\n    controllability_matrix: [[0, 1],\n      [1, -3]]\n    rank: %2\n"
    assert marked(PLANT, text)["b"].answers["controllability_matrix"].verdict == "correct"


@pytest.mark.parametrize(
    ("name", "answers", "meant"),
    [
        ("K_f", ["K", "P"], "K"),
        ("K", ["K_f", "P"], "K_f"),
        ("K", ["K_f", "K_e"], ""),
        ("_f", ["K"], ""),
        ("eigenvaluse", ["eigenvalues", "multiplicities"], "eigenvalues"),
    ],
)
def test_an_answer_called_by_other_indices_is_meant_where_there_is_one(name, answers, meant):
    assert meant_answer(name, answers) == meant
