"""Sets of signs: the rules against numbers that have these signs."""

from itertools import chain, combinations, product

import pytest

from solver.exact.linear_algebra.sign_sets import ZERO, of_power, of_product, of_sum

SETS = [frozenset(each) for n in (1, 2, 3) for each in combinations((-1, 0, 1), n)]


def sign(x):
    return (x > 0) - (x < 0)


def numbers(signs):
    """Small numbers and large ones with these signs."""
    return sorted(set(chain.from_iterable((each, 2 * each, 3 * each) for each in signs)))


@pytest.mark.parametrize(("a", "b"), [*product(SETS, repeat=2)])
def test_the_signs_of_sums_and_products_are_those_of_numbers(a, b):
    pairs = list(product(numbers(a), numbers(b)))
    assert of_sum(a, b) == {sign(x + y) for x, y in pairs}
    assert of_product(a, b) == {sign(x * y) for x, y in pairs}


@pytest.mark.parametrize("a", SETS)
@pytest.mark.parametrize("exponent", [0, 1, 2, 3, -1, -2])
def test_the_signs_of_powers_are_those_of_numbers(a, exponent):
    assert of_power(a, exponent) == {sign(x**exponent) for x in numbers(a - ZERO if exponent < 0 else a)}
