"""Orders of numbers, values that differ and values that nearly agree."""

import operator

import pytest
import sympy as sp

from solver.derivation import CheckStatus
from solver.numeric.evaluation.environment import Environments
from solver.numeric.evaluation.relations import check_relation

ORDERS = {"<": operator.lt, "≤": operator.le, ">": operator.gt, "≥": operator.ge}
x = sp.Symbol("x")
NEAR = sp.sqrt(2) + sp.Rational(1, 10**40)
"""Not √2, as doubles do not show."""


def status(left, relation, right, **named):
    return check_relation(left, relation, right, "", environments=Environments(), **named).status


@pytest.mark.parametrize("relation", ORDERS)
@pytest.mark.parametrize(
    ("left", "right"),
    [(1, 2), (2, 1), (2, 2), (-1, 1), (sp.sqrt(2), NEAR), (NEAR, sp.sqrt(2)), (sp.sqrt(8), 2 * sp.sqrt(2)), (0, 0)],
)
def test_an_order_of_numbers(left, relation, right):
    holds = ORDERS[relation](sp.sympify(left), sp.sympify(right))
    assert (status(left, relation, right) is CheckStatus.PASSED) == bool(holds)


@pytest.mark.parametrize("relation", ORDERS)
def test_what_has_no_order_fails(relation):
    assert status(sp.I, relation, 2) is CheckStatus.FAILED
    assert status(2, relation, 2 + sp.I) is CheckStatus.FAILED
    assert status(sp.eye(2), relation, sp.zeros(2)) is CheckStatus.FAILED
    assert status(1, relation, sp.eye(2)) is CheckStatus.FAILED


def test_numbers_beyond_doubles_are_not_judged():
    assert status(sp.exp(1000), ">", 10**6) is CheckStatus.SKIPPED


def test_decimals_that_cannot_tell_are_not_judged():
    cancelled = sp.Add(sp.Float("1e20"), sp.Float("1e-3"), sp.Float("-1e20"), evaluate=False)
    assert status(cancelled, ">", 0) is CheckStatus.SKIPPED


@pytest.mark.parametrize(
    ("left", "right", "differ"), [(x, x + 1, True), (x, 2 * x - x, False), (3, 3, False), (3, 3.001, True)]
)
def test_values_that_differ(left, right, differ):
    assert (status(left, "≠", right) is CheckStatus.PASSED) == differ


def test_values_nearly_agree_within_what_is_allowed():
    assert status(3.142, "≈", sp.pi, near=1e-3) is CheckStatus.PASSED
    assert status(3.142, "≈", sp.pi, near=1e-5) is CheckStatus.FAILED
    assert status(3.142, "≈", sp.pi) is CheckStatus.FAILED
