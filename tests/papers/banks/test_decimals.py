"""Exact numbers as decimals, and the tolerance that marking grants."""

from decimal import Decimal
from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.papers.export.decimals import complex_parts, exactly, tolerance_of, typed, unit_of, value_of, written

NUMBERS = st.fractions(min_value=-(10**6), max_value=10**6, max_denominator=10**6)


@pytest.mark.parametrize(
    ("number", "digits", "told", "tolerance", "value"),
    [
        (Fraction(13), 2, "13", "0", "13"),
        (Fraction(-1304), 2, "-1304", "0", "-1304"),
        (Fraction(2, 3), 2, "0.67", "0.005", "0.666666666667"),
        (Fraction(2, 3), 4, "0.6667", "0.00005", "0.666666666667"),
        (Fraction(-37, 3), 2, "-12.3", "0.05", "-12.3333333333"),
        (Fraction(704, 100), 2, "7.0", "0.05", "7.04"),
        (Fraction(1, 2), 2, "0.5", "0", "0.5"),
        (Fraction(3, 8), 2, "0.38", "0.005", "0.375"),
        (Fraction(0), 3, "0", "0", "0"),
        (Fraction(1, 700000), 3, "0.00000143", "5E-9", "0.00000142857142857"),
        (Fraction(1, 7 * 10**12), 2, "1.4E-13", "5E-15", "1.42857142857E-13"),
    ],
)
def test_numbers_are_told_to_the_digits_asked(number, digits, told, tolerance, value):
    assert typed(number, digits) == told
    assert written(tolerance_of(number, digits)) == tolerance
    assert written(value_of(number)) == value


@given(NUMBERS, st.integers(1, 6))
def test_what_is_typed_is_within_the_tolerance_and_its_neighbours_are_not(number, digits):
    unit, tolerance = unit_of(number, digits), Fraction(tolerance_of(number, digits))
    near = Fraction(typed(number, digits))
    assert abs(near - number) <= tolerance
    beyond = [near + unit, near - unit]
    assert all(abs(each - number) >= tolerance for each in beyond)
    assert abs(Fraction(value_of(number)) - number) <= abs(number) / 10**11


def test_only_finite_numbers_are_decimals():
    assert exactly(sp.sqrt(2)) == Fraction("1.414213562373095048801688724209698078570")
    assert exactly(sp.Symbol("a")) is None
    assert exactly(sp.oo) is None
    assert exactly(sp.zoo) is None
    assert exactly(1 + sp.I) is None
    assert complex_parts(1 - 2 * sp.I) == (1, -2)
    assert complex_parts(sp.nan) is None
    assert exactly(sp.Float("2.5", 30)) == Fraction(5, 2)
    assert written(Decimal("1E+20")) == "1E+20"
