"""Bounds on what an expression becomes: never below what really comes out."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

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


FRACTIONS = st.builds(Fraction, st.integers(1, 5000), st.integers(1, 5000))


@given(st.lists(FRACTIONS, min_size=1, max_size=6), st.sampled_from([CONSTANTS["j"], SYMBOL]), st.integers(1, 4))
def test_like_terms_have_a_common_denominator(fractions, unit, n):
    terms = [("+", times([of_number(each), unit])) for each in fractions]
    together = sum(fractions)
    assert plus(terms).bits >= bits_of(together)
    assert plus(terms).below >= together.denominator.bit_length() - 1
    assert integer_power(plus(terms), n).bits >= bits_of(together**n)
    assert inverse(plus(terms)).bits >= bits_of(1 / together)


@given(FRACTIONS, FRACTIONS, FRACTIONS, FRACTIONS)
def test_a_quotient_of_complex_numbers_is_made_real_below(a, b, c, d):
    def size(re, im):
        return plus([("+", of_number(re)), ("+", times([of_number(im), CONSTANTS["j"]]))])

    quotient = times([size(a, b), inverse(size(c, d))])
    norm = c**2 + d**2
    assert quotient.bits >= max(bits_of((a * c + b * d) / norm), bits_of((b * c - a * d) / norm))


def test_whole_coefficients_do_not_grow_in_nested_sums():
    nested = SYMBOL
    for _ in range(30):
        nested = plus([("+", times([nested, SYMBOL])), ("+", of_number(Fraction(7)))])
    assert nested.below == 0
    assert nested.bits < 100


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
