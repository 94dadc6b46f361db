"""The sheet: the question, what was typed, marks of each answer, wrong entries framed, what is missing, comments."""

import re
from dataclasses import replace

import pytest

from solver.classroom import mark, read_submission
from solver.classroom.report.sheet import render_sheet
from solver.problem.source import Source
from tests.helpers.marked import solved

PROBLEM = """\
title: A plant
statement: A motor drives a load.
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find:
  a: {task: pole_placement, poles: ["-3 ± 2j"], marks: 10, answers: [K, polynomial, closed_loop_A]}
  b: {task: eigenstructure, marks: 4, prompt: Find the modes of the **motor**.}
"""
FRAME = re.compile(r'<mrow style="border:[^"]*">(.*?)</mrow>')


def sheet(answers, problem=PROBLEM, *, comment="", **how):
    solution = solved(problem)
    marking = mark(solution, read_submission(Source("answers.yaml", answers), solution.problem))
    return render_sheet(solution, replace(marking, comment=comment), **how)


def results(page):
    """The parts of the sheet that tell of one answer, by its name, as text without markup."""
    pieces = re.findall(r'(?s)<div class="result verdict [a-z]+">(.*?)</div>', page)
    return {
        re.search(r"<code>(\w+)</code>", each)[1]: " ".join(re.sub(r"<[^>]*>", " ", each).split()) for each in pieces
    }


def test_the_question_and_the_plant_are_those_of_the_worked_page():
    page = sheet("answers: {a: {K: [13, 8]}}")
    assert "A motor drives a load." in page
    assert "Find the modes of the <strong>motor</strong>." in page
    assert "places the closed-loop poles at" in page
    assert page.count('alttext="A = \\begin{bmatrix}1 &amp; 2') == 1


def test_each_answer_has_what_was_typed_and_its_marks():
    found = results(sheet("answers: {a: {K: [13, 7.0], polynomial: <b>}, b: {eigenvalues: [1], diagonalizable: yes}}"))
    assert "✗ wrong K 1.67 of 3.34 Typed: [13, 7.0]" in found["K"]
    assert "? not judged polynomial 0 of 3.33 Typed: &lt;b&gt;" in found["polynomial"]
    assert "closed_loop_A" in found
    assert "not submitted closed_loop_A 0 of 3.33" in found["closed_loop_A"]
    assert "not submitted right_eigenvectors 0 of 1" in found["right_eigenvectors"]
    assert "diagonalizable carries no marks" in found["diagonalizable"]


@pytest.mark.parametrize(
    ("answers", "framed"),
    [
        ("{a: {K: [13, 7]}}", ["<mn>7</mn>"]),
        ("{a: {closed_loop_A: [[1, 2], [-10, 7]]}}", ["<mn>7</mn>"]),
        ("{b: {eigenvalues: [1 + sqrt(6), 5]}}", ["<mn>5</mn>"]),
        ("{a: {K: [13, 8]}}", []),
        ("{a: {K: [1, 7]}}", []),
    ],
)
def test_wrong_entries_are_framed_where_others_are_right(answers, framed):
    assert FRAME.findall(sheet(f"answers: {answers}")) == framed


def test_the_right_value_is_shown_only_if_the_instructor_says_so():
    answers = "answers: {a: {K: [13, 7], closed_loop_A: [[1, 2], [-10, -7]]}}"
    assert "right value" not in sheet(answers)
    found = results(sheet(answers, key=True))
    assert "The right value:" in found["K"]
    assert "A right value:" in found["right_eigenvectors"]
    assert "The right value:" in found["polynomial"]  # which is not submitted
    assert "right value" not in found["closed_loop_A"]


def test_there_is_room_for_a_comment_or_the_comment():
    empty = sheet("answers: {a: {K: [13, 8]}}")
    assert '<div class="lines" aria-hidden="true">' in empty
    said = sheet("answers: {a: {K: [13, 8]}}", comment="Well done, **Ada**: $K$ is right. <b>")
    assert '<div class="lines"' not in said
    assert "Well done, <strong>Ada</strong>" in said
    assert "&lt;b&gt;" in said


def test_what_needs_review_is_said_on_top():
    assert "needs review: a.polynomial (not judged)" in sheet("answers: {a: {polynomial: s +}}")
    assert "needs review" not in sheet("answers: {a: {K: [13, 8]}}")
