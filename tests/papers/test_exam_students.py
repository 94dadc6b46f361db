"""Whose an answer file is: names as the class writes them, those that differ in capitals or accents only among them."""

from dataclasses import replace

import pytest

from solver.papers.exam.reading import read_exam
from solver.papers.exam.submitted import NotPlacedError, read_exam_submission
from solver.papers.exam.whose import may_be_of, spelt_alike
from solver.problem.source import Source

EXAM = """\
exam: Test
questions:
  - {marks: 10, problem: {system: {matrix: [[1, 2], [3, 4]]}, find: {a: eigenstructure}}}
"""
STUDENTS = ("Anna", "anna", "Ben Ito", "José", "Jose\u0301 B", "ŁUCJA", "علی\u200cرضا")


@pytest.fixture(scope="module")
def exam():
    return replace(read_exam(Source("exam.yaml", EXAM)), students=STUDENTS)


def whose(exam, head):
    text = f"{head}\nanswers: {{1: {{a: {{eigenvalues: [1, 2]}}}}}}\n"
    paper = read_exam_submission(Source("a.yaml", text), exam)
    return paper.student, paper.variant


@pytest.mark.parametrize(
    ("said", "student"),
    [
        ("Anna", "Anna"),
        ("anna", "anna"),
        (" anna ", "anna"),
        ("ben  ITO", "Ben Ito"),
        ("Jose\u0301", "José"),
        ("JOSÉ", "José"),
        ("José B", "Jose\u0301 B"),
        ("łucja", "ŁUCJA"),
        ("علیرضا", "علی\u200cرضا"),
    ],
)
def test_an_exact_name_wins_and_capitals_do_not_count_where_one_is_left(exam, said, student):
    assert whose(exam, f"student: '{said}'") == (student, STUDENTS.index(student) + 1)


@pytest.mark.parametrize(
    ("head", "status", "said"),
    [
        ("student: ANNA", "unclear student", "a.yaml:1:10: error: 'ANNA' may be Anna or anna"),
        ("student: ANNA\nvariant: 2", "unclear student", "'ANNA' may be Anna or anna"),
        ("student: Jose", "unknown student", "did you mean 'José'?"),
        ("student: Bne Ito", "unknown student", "did you mean 'Ben Ito'?"),
        ("student: ben ito\nvariant: 4", "variant does not fit", "Ben Ito has variant 3, not 4\n"),
        ("student: Anna\nvariant: 9", "variant does not fit", "a.yaml:2:10: error: variant must be"),
        ("student:", "no variant", "the key 'variant' is missing"),
    ],
)
def test_what_is_not_sure_is_told_at_its_place_and_in_two_words(exam, head, status, said):
    with pytest.raises(NotPlacedError) as error:
        whose(exam, head)
    assert error.value.status == status
    assert said in error.value.render()


def test_who_has_the_variant_of_another_spelling_is_not_told_to_take_it_out(exam):
    with pytest.raises(NotPlacedError) as error:
        whose(exam, "student: Anna\nvariant: 2")
    told = error.value.render()
    assert "a.yaml:2:10: error: Anna has variant 1, not 2, which is that of anna" in told
    assert "take out" not in told


def test_a_name_of_nobody_is_like_nobody():
    assert spelt_alike("", ["Anna"]) == spelt_alike(" ", ["Anna"]) == spelt_alike("Zoe", ["Anna"]) == ()


def test_a_file_that_cannot_be_read_is_of_whom_it_was_written_for(exam):
    assert may_be_of("in/answers-Ben-Ito.yaml", None, exam) == "Ben Ito"
    assert may_be_of("in/answers-anna-2.yaml", None, exam) == "anna"
    assert may_be_of("in/ben.yaml", None, exam) == ""
