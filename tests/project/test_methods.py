"""The order of steps in docs/methods.md is that of the derivations, as the steps of the problems show."""

from pathlib import Path

import pytest

from solver.derivation import Unsolved
from solver.engine import given_of, yield_into
from solver.lazy import exact
from solver.tasks import catalogue
from tests.helpers.solved import PROBLEMS, by_problem, solution_of
from tools import methods_page
from tools.methods import Either, Named, Repeated, Then, follows, methods, order_of_method, walked

ROOT = Path(__file__).parents[2]
COURSE = [path for path in PROBLEMS if "course" in path.parts]
A, B, C = (Named("lemmas/x", kind) for kind in "abc")


def yielded(part, method, known):
    """The steps that a method itself yields, up to where it stops."""
    steps = []
    try:
        given = given_of(part, method, known)
        yield_into(steps, catalogue()[part.task].methods[method].derive(given))
    except (Unsolved, exact.NotExact):
        pass
    return [Named(step.wording, step.kind) for step in steps]


@pytest.mark.parametrize(**by_problem(COURSE[::9], COURSE[::18]))
def test_the_steps_of_problems_come_in_the_order_of_the_table(path):
    solution, known = solution_of(path), {}
    for part in solution.problem.parts:
        for method in part.methods:
            steps = yielded(part, method, known)
            assert follows(order_of_method(part.task, method), steps), (part.id, method, steps)
        known[part.id] = next(result for result in solution.parts if result.id == part.id)


@pytest.mark.parametrize(
    ("steps", "right"),
    [
        ([A, B, C], True),
        ([A, C], True),
        ([A, B, B, C], True),
        ([A], True),
        ([], True),
        ([B, C], False),
        ([A, C, B], False),
    ],
)
def test_an_order_is_followed_or_not(steps, right):
    order = Then((A, Either((Then(()), Repeated(B))), C))
    assert follows(order, steps) is right


def test_every_method_has_an_order():
    assert not [each.method for each in methods() if not list(walked(each.order))]


def test_the_page_is_up_to_date():
    assert (ROOT / "docs" / "methods.md").read_text(encoding="utf-8") == methods_page.page()


def test_titles_are_those_of_the_pages():
    said = methods_page.title_of
    assert said(Named("lemmas/response_transform", "partial_fractions")) == "Partial fractions"
    assert said(Named("lemmas/determinant", "pencil")) == "Form the matrix $… I - A$"
    assert said(Named("lemmas/response", "sum")) == "Complete response of the states / The parts together"
