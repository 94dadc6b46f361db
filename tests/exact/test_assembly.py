"""Sums put together without sympy's rewriting are those of its own arithmetic, down to the order of their terms."""

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact import factored, resolvent
from solver.exact.linear_algebra.assembly import linear_combination, product_of_powers
from tests.helpers.tried import tried

t, a = sp.symbols("t a")
FUNCTIONS = [sp.S.One, t, t**2, sp.exp(-t), t * sp.exp(-t), sp.exp(-t) * sp.cos(2 * t), 2 * t**3, sp.Integer(3)]
NUMBERS = [sp.S.One, sp.S.NegativeOne, sp.Rational(-2, 3), sp.Integer(4), sp.sqrt(2), 1 - sp.sqrt(2), 3 * a, a + 1]
FACTORS = [t, a**2, sp.exp(-t), sp.cos(t), sp.sqrt(t + 1)]


def parts_of(number, function):
    """A sum with a parameter is multiplied out, one of roots is one coefficient, with its sign before it."""
    if number == 1 - sp.sqrt(2) and not function.is_number:
        return [sp.Mul(-1, sp.sqrt(2) - 1, function)]
    return [part * function for part in sp.Add.make_args(number)]


@tried(100)
@given(st.lists(st.tuples(st.sampled_from(NUMBERS), st.sampled_from(FUNCTIONS)), max_size=5, unique_by=lambda e: e[1]))
def test_sums_of_numbers_times_functions(terms):
    expected = sp.Add(*(part for number, function in terms for part in parts_of(number, function)))
    found = linear_combination(iter(terms))
    assert (found, found.args) == (expected, expected.args)


@tried(40)
@given(st.sampled_from(NUMBERS[:4]), st.lists(st.sampled_from(FACTORS), min_size=1, unique=True))
def test_products_of_powers(number, factors):
    expected = sp.Mul(number, *factors)
    found = product_of_powers(number, factors)
    assert (found, found.args) == (expected, expected.args)


@pytest.mark.parametrize(
    "rows",
    [
        [[0, 1, 0], [0, 0, 1], [-6, -11, -6]],
        [[2, 0, 1], [0, 2, 0], [0, 0, 0]],
        [[sp.Rational(1, 2), 1], [0, sp.Rational(-1, 3)]],
        [[0, 1], [-2, -2]],
        [[0, 1, 0, 0], [0, 0, 0, 0], [0, 0, -1, 3], [0, 0, 0, -1]],
    ],
)
def test_fractions_of_the_resolvent_and_its_denominator(rows):
    A, x = sp.ImmutableMatrix(rows), sp.Symbol("s")
    _, listed = sp.Poly(A.charpoly(x).as_expr(), x, domain=sp.QQ).factor_list()
    whole = sp.Mul(*(p.monic().as_expr() ** m for p, m in listed))
    assert (factored(A, x), factored(A, x).args) == (whole, whole.args)
    inverse = (x * sp.eye(A.rows) - A).inv()
    for found, expected in zip(resolvent(A, x), inverse, strict=True):
        anew = found.func(*found.args) if found.args else found
        assert (found, found.args) == (anew, anew.args)
        assert sp.cancel(found - expected) == 0
