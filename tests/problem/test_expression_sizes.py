"""Bounds on what an expression becomes: never below what really comes out."""

from fractions import Fraction

import pytest

from solver.problem.expressions.size import (
    CONSTANTS,
    SYMBOL,
    Size,
    bits_of,
    integer_power,
    inverse,
    of_number,
    plus,
    power,
    times,
)

THREE_SEVENTHS = Fraction(3, 7)


def test_rational_numbers_are_known_exactly():
    x, y = of_number(THREE_SEVENTHS), of_number(Fraction(-2, 5))
    assert plus([("+", x), ("-", y)]).value == Fraction(29, 35)
    assert times([x, y]).value == Fraction(-6, 35)
    assert inverse(y).value == Fraction(-5, 2)
    assert integer_power(y, 3).value == Fraction(-8, 125)
    assert integer_power(y, -2).value == Fraction(25, 4)
    assert integer_power(y, 0).value == 1
    assert plus([("+", x), ("±", y)]).value is None
    assert bits_of(Fraction(-8, 125)) == 4 + 7


def test_the_inverse_of_a_complex_number_has_the_square_of_its_size_below():
    z = plus([("+", of_number(Fraction(1023))), ("+", times([of_number(Fraction(1021)), CONSTANTS["j"]]))])
    below = 1023**2 + 1021**2
    assert inverse(z).bits >= below.bit_length()
    assert abs(inverse(z).estimate - 1 / complex(1023, 1021)) < 1e-15


@pytest.mark.parametrize(("n", "bits", "reach"), [(1, 6, 2.0), (5, 30, 10.0), (0, 6, 0.0)])
def test_a_power_grows_with_its_exponent(n, bits, reach):
    grown = integer_power(Size(bits=6, reach=2.0, weight=3.0), n)
    assert (grown.bits, grown.reach, grown.weight) == (bits, reach, 3.0**n)
    assert not grown.constant


def test_an_exponent_that_is_no_whole_number_counts_as_the_next_one():
    grown = power(Size(bits=6, weight=2.0), of_number(Fraction(5, 2)))
    assert grown.bits >= 6 * 3
    assert grown.weight == 2.0**3


def test_what_cancels_to_noise_is_not_estimated():
    root = power(of_number(Fraction(2)), of_number(Fraction(1, 2)))
    assert plus([("+", root), ("-", root)]).estimate is None
    assert abs(plus([("+", root), ("+", root)]).estimate - 2 * 2**0.5) < 1e-12


def test_a_symbol_makes_a_sum_or_product_no_constant():
    number = of_number(THREE_SEVENTHS)
    assert not plus([("+", SYMBOL), ("+", number)]).constant
    assert not times([SYMBOL, number]).constant
    assert times([SYMBOL, number]).estimate is None
    assert times([CONSTANTS["pi"], number]).constant
    assert times([SYMBOL, number]).bits == bits_of(THREE_SEVENTHS)
