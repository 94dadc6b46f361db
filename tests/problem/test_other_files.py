"""A file of another kind than a command reads is named once, with the command that reads it."""

import pytest

from solver.classroom.reading.answer_file import root_of_answers
from solver.papers.exam.reading import read_exam
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

EXAM = "exam: Midterm\nquestions:\n  - {problem: a.yaml}\n"
ANSWERS = "exam: exam.yaml\nvariant: 2\nanswers:\n  1: {a: {K: [1, 2]}}\n"
CHANGES = "changes:\n  A-17: {a: {K: {marks: 1}}}\n"
PROBLEM = "title: A pair\nsystem: {A: [[1]]}\nfind: {a: stability}\n"


def told_of_a_problem(text):
    with pytest.raises(InputError) as caught:
        read_problem(Source("folder/file.yaml", text), catalogue())
    return caught.value.render()


def told_of_an_exam(text):
    with pytest.raises(InputError) as caught:
        read_exam(Source("folder/file.yaml", text))
    return caught.value.render()


@pytest.mark.parametrize(
    ("text", "message", "way"),
    [
        (EXAM, "2:1: error: this is an exam, not a problem", "`solve exam file.yaml -o build/`"),
        (ANSWERS, "3:1: error: this is an answer file, not a problem", "`solve check EXAM file.yaml`"),
        (CHANGES, "1:1: error: this is a file of changes, not a problem", "--override file.yaml"),
    ],
)
def test_other_files_are_no_problems(text, message, way):
    told = told_of_a_problem(text)
    assert message in told
    assert way in told
    assert told.count("error") == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (PROBLEM, "3:1: error: this is a problem, not an exam"),
        (ANSWERS, "3:1: error: this is an answer file, not an exam"),
    ],
)
def test_other_files_are_no_exams(text, message):
    told = told_of_an_exam(text)
    assert message in told
    assert told.count("error") == 1


@pytest.mark.parametrize("text", ["system: {A: [[1]]}\nanswers: {}\n", "title: x\nfound: {a: stability}\n"])
def test_a_problem_with_a_key_wrong_stays_a_problem(text):
    told = told_of_a_problem(text)
    assert "this is" not in told
    assert "'find' is missing" in told or "did you mean 'find'?" in told


def test_an_exam_without_questions_is_told_so():
    assert "'questions' is missing" in told_of_an_exam("exam: Midterm\n")


@pytest.mark.parametrize(
    ("text", "message", "way"),
    [
        (EXAM, "2:1: error: this is an exam, not an answer file", "`solve check file.yaml answers/`"),
        (PROBLEM, "3:1: error: this is a problem, not an answer file", "`solve file.yaml`"),
    ],
)
def test_other_files_are_no_answers(text, message, way):
    with pytest.raises(InputError) as caught:
        root_of_answers(Source("folder/file.yaml", text))
    told = caught.value.render()
    assert message in told
    assert way in told
