"""Numbers with roots, over rational denominators."""

from __future__ import annotations

import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.exact.linear_algebra.radicals import over_rational

rationals = st.fractions(min_value=-9, max_value=9, max_denominator=5).map(sp.Rational)


@st.composite
def numbers(draw):
    roots = draw(st.lists(st.sampled_from([2, 3, 5, 6, 7, 30]), min_size=0, max_size=4, unique=True))
    return sum((draw(rationals) * sp.sqrt(d) for d in roots), draw(rationals))


@given(numbers(), numbers())
def test_the_quotient_has_its_value_and_a_rational_denominator(above, below):
    assume(abs(sp.N(below)) > 1e-6)
    found = over_rational(above / below)
    assert abs(sp.N(found - above / below, 40)) < sp.Float(10) ** -25
    assert all(term.as_coeff_Mul()[0].is_Rational for term in sp.Add.make_args(found))
    assert not any(power.exp.is_negative for power in found.atoms(sp.Pow))


@pytest.mark.parametrize(
    ("number", "written"),
    [
        (1 / (1 + sp.I * sp.sqrt(3)), sp.Rational(1, 4) - sp.I * sp.sqrt(3) / 4),
        (1 / (2 + sp.cbrt(2)), 1 / (2 + sp.cbrt(2))),
        (sp.sqrt(2) / sp.sqrt(3), sp.sqrt(6) / 3),
    ],
)
def test_what_else_stands_below_is_left_to_sympy(number, written):
    assert over_rational(number) == written


def test_nested_roots_are_turned_too():
    nested = sp.sqrt(2 + sp.sqrt(2))
    found = over_rational(1 / (nested + 1))
    assert abs(sp.N(found - 1 / (nested + 1), 40)) < sp.Float(10) ** -30
    assert sp.fraction(sp.together(found))[1].is_Rational
