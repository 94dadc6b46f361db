"""Judges accept right answers in whatever form, and reject wrong ones however near."""

from contextlib import suppress
from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest
import sympy as sp

from solver.numeric import TOLERANCE, NotEvaluable, ShapeMismatch
from solver.numeric.judges import design, stability
from tests.numeric.judges import cases

TOPICS = [each.name for each in iter_modules(cases.__path__)]
CASES = [
    pytest.param(topic, case, id=f"{case.judge}-{i}")
    for topic in TOPICS
    for i, case in enumerate(import_module(f"{cases.__name__}.{topic}").CASES)
]


def verdict(topic, case, answer, form=lambda value: value):
    """Whether the judge accepts an answer, in a form of question and answer. Raises NotEvaluable where it refuses."""
    arguments = form(case.ask(answer))
    named = arguments[-1] if isinstance(arguments[-1], dict) and set(arguments[-1]) & KEYWORDS else {}
    positional = arguments[:-1] if named else arguments
    judge = getattr(import_module(f"solver.numeric.judges.{topic}"), case.judge)
    try:
        found = judge(*positional, **named)
    except ShapeMismatch:  # a check of it fails
        return False
    if isinstance(found, str):  # what is wrong, in words
        return not found
    return bool(found) if isinstance(found, bool | np.bool_) else found <= TOLERANCE


KEYWORDS = {"discrete", "transposed", "above"}


@pytest.mark.parametrize(("topic", "case"), CASES)
def test_right_answers_are_accepted(topic, case):
    for answer in case.accepted:
        assert verdict(topic, case, answer), answer


@pytest.mark.parametrize(("topic", "case"), CASES)
def test_wrong_answers_are_rejected(topic, case):
    for answer in case.rejected:
        assert not verdict(topic, case, answer), answer


def in_decimals(value):
    """A question and its answer with every number in decimals of 15 digits."""
    if isinstance(value, sp.MatrixBase):
        return sp.ImmutableMatrix(value.applyfunc(in_decimals))
    if isinstance(value, sp.Expr):
        fractions = {number: number.evalf(15) for number in value.atoms(sp.Rational) if number.q > 1}
        return value.xreplace(fractions) if value.free_symbols else value.evalf(15)
    if isinstance(value, list | tuple):
        parts = map(in_decimals, value)
        return type(value)(*parts) if hasattr(value, "_fields") else type(value)(parts)
    return value


@pytest.mark.parametrize(("topic", "case"), CASES)
def test_in_decimals_right_is_right_and_wrong_is_not(topic, case):
    if case.judge != "is_jordan_form":  # decimals know no multiple eigenvalue
        for answer in case.accepted:
            assert verdict(topic, case, answer, in_decimals), answer
    for answer in case.rejected:
        with suppress(NotEvaluable):  # decimals that carry too few digits to judge it
            assert not verdict(topic, case, answer, in_decimals), answer


OF_ANY_SHAPE = {"row_space_residual", "is_unit_vector", "diagonalizable"}
"""Judges of rows, however many, of a vector of any size, and of the question itself."""


@pytest.mark.parametrize(("topic", "case"), [each for each in CASES if each.values[1].judge not in OF_ANY_SHAPE])
def test_a_matrix_with_a_row_or_column_more_or_less_is_not_accepted(topic, case):
    for right in (answer for answer in case.accepted[:2] if isinstance(answer, sp.MatrixBase)):
        wider = sp.Matrix.hstack(right, sp.zeros(right.rows, 1)), sp.Matrix.vstack(right, sp.zeros(1, right.cols))
        smaller = [right[:-1, :]] * (right.rows > 1) + [right[:, :-1]] * (right.cols > 1)
        for answer in (*wider, *smaller):
            assert not verdict(topic, case, sp.ImmutableMatrix(answer))


def test_a_set_point_beside_the_right_one_is_measured_against_the_size_of_its_terms():
    """x₁ is 1 by one row and 1 + d by another: at best both are off by d/2, where the terms are of size 2."""
    d = sp.Rational(1, 1000)
    M, L, V = sp.ImmutableMatrix([[0, 1], [1, 0]]), sp.ImmutableMatrix([[1, 0]]), sp.ImmutableMatrix([[1 + sp.N(d)]])
    assert design.set_point_residual(M, 1, [(L, V)]) == pytest.approx(float(d) / 4, rel=1e-2)


@pytest.mark.parametrize(
    ("rows", "kind"),
    [
        ([[-1, 0], [0, -2]], "stable node"),
        ([[1, 0], [0, 2]], "unstable node"),
        ([[-1, 0], [0, 2]], "saddle"),
        ([[-1, 2], [-2, -1]], "stable focus"),
        ([[1, 2], [-2, 1]], "unstable focus"),
        ([[0, 2], [-2, 0]], "center"),
        ([[-1, 1], [0, -1]], "stable degenerate node"),
        ([[2, 0], [0, 2]], "unstable star"),
        ([[0, 1], [0, 0]], "shear"),
        ([[0, 0], [0, -1]], "line of equilibria"),
    ],
)
def test_phase_portraits_have_the_kind_of_the_textbooks(rows, kind):
    assert stability.kinds_and_exceptions(sp.ImmutableMatrix(rows)) == ({kind}, set())
