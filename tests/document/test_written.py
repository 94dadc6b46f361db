"""What a teacher would not write is on no page: headings over nothing, numbers in brackets, what is given once more."""

import re

import pytest

from solver.document.model import Presentation
from solver.document.once import told_once
from solver.messages import Messages
from solver.render.markdown import markdown_of
from tests.helpers.sample_pages import part, worded
from tests.helpers.solved import EXAMPLES, PROBLEMS, by_problem, document_of_problem, solution_of, told_of_problem

LEVELS = ("tutor", "full", "brief", "key")
DISPLAY = re.compile(r"\$\$\n(.+?)\n\$\$", re.DOTALL)
NUMBER = re.compile(r"\\begin\{bmatrix\}(?:[^&\\]|\\(?!\\|end\{bmatrix\}))*\\end\{bmatrix\}")
"""A matrix of one entry."""

WORTH = 25
"""Characters of a formula that is worth being told once only."""


def formulas(text):
    return {each for each in DISPLAY.findall(text) if len(each) >= WORTH}


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=EXAMPLES[:3], of=8))
def test_no_heading_stands_over_nothing(path, level):
    for each in document_of_problem(path).told(detail=level).shown:
        for step in (step for top in each.steps for step in top.walk()):
            assert step.markdown or step.figures or step.steps or step.refers or step.pictured, (each.id, step.title)


@pytest.mark.parametrize(**by_problem(EXAMPLES[:12]))
def test_what_is_given_is_not_told_again(path):
    document = document_of_problem(path).told(detail="full")
    for each in document.shown:
        given = formulas(f"{each.given}\n\n{document.given}")
        for step in (step for top in each.steps for step in top.walk()):
            shown = formulas(step.markdown)
            assert not shown or not shown <= given, (each.id, step.title)
        assert not {answer.equation for answer in each.boxed} & given, each.id


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=EXAMPLES[:3], of=8))
def test_a_number_is_not_put_in_brackets(path):
    document = document_of_problem(path).told(detail="full")
    for each in document.shown:
        texts = [each.question, each.given, *(f"$$\n{answer.shown}\n$$" for answer in each.boxed)]
        assert not [found for text in texts for found in NUMBER.findall(text)], each.id


@pytest.mark.parametrize(**by_problem(PROBLEMS, quick=EXAMPLES[:1], of=8))
def test_checks_cite_steps_that_are_numbered_so_at_every_level(path):
    for level in LEVELS[:3]:
        document = told_of_problem(path, Presentation(level, checks="table"))
        text = markdown_of(document)
        assert len(solution_of(path).parts) <= len(document.parts)
        for each in document.shown:
            cited = {int(number) for row in each.rows for number in re.findall(r"step (\d+)", row.claim)}
            assert cited <= set(range(1, len(each.steps) + 1)), (level, each.id)
            assert all(f"### {number}. {each.steps[number - 1].title}" in text for number in cited), (level, each.id)


def test_a_step_that_shows_what_is_given_and_nothing_else_is_left_out():
    given = "$$\nG(s) = \\frac{1}{s + 1}\n$$"
    steps = worded("As given", f"Start from what is given:\n\n{given}"), worded("On", f"{given}\n\nIt is proper.")
    (shown,) = told_once((part("a", "verified", steps=steps),), Messages().say, given)
    assert [step.title for step in shown.steps] == ["On"]
    (shown,) = told_once((part("a", "verified", steps=steps),), Messages().say)
    assert [step.title for step in shown.steps] == ["As given", "On"]
