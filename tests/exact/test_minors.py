"""Euclid's algorithm on rows and columns against the minors one by one; angles at which a rank drops."""

from functools import reduce

import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from sympy import QQ
from sympy.polys.rings import ring

from solver.exact import NotExact
from solver.exact.structure.critical_angles import _merged
from solver.exact.structure.minors import MOST_MINORS, diagonal_product, minors_of
from tests.helpers.tried import tried

R, x = ring("x", QQ)
pi, a, number = sp.pi, sp.Symbol("a", real=True), sp.Symbol("n", integer=True)
polynomials = st.lists(st.integers(-2, 2), max_size=3).map(lambda c: sum((n * x**i for i, n in enumerate(c)), R.zero))


@st.composite
def matrices(draw):
    """Polynomials 2×2 to 3×3, often with factors in common."""
    n = draw(st.integers(2, 3))
    m = draw(st.integers(n, 3))
    factors = [draw(st.sampled_from([R.one, x, x + 1, x**2 - 1])) for _ in range(n)]
    return [[factor * draw(polynomials) for _ in range(m)] for factor in factors]


@tried(60)
@given(matrices())
def test_the_greatest_common_divisor_of_the_largest_minors(rows):
    minors = list(minors_of(rows, len(rows)))
    divisor = reduce(lambda p, q: p.gcd(q), minors)
    if divisor:
        assert diagonal_product([list(row) for row in rows]) == divisor.monic()


def test_minors_are_determinants_of_chosen_columns_and_not_too_many():
    rows = [[x, R.one, R.zero], [R.one, x, x + 1]]
    assert list(minors_of(rows, 2)) == [x**2 - 1, x**2 + x, x + 1]
    assert list(minors_of(rows, 1)) == [x, R.one, R.zero, R.one, x, x + 1]
    with pytest.raises(NotExact):
        list(minors_of([[x] * (MOST_MINORS + 1)], 1))
    with pytest.raises(NotExact):
        list(minors_of([[x]] * (MOST_MINORS + 1), 1))
    assert len(list(minors_of([[x] * MOST_MINORS], 1))) == MOST_MINORS


@pytest.mark.parametrize(
    ("angles", "merged"),
    [
        ([pi / 2, -pi / 2], [pi / 2 + number * pi]),
        ([pi / 3], [pi / 3 + 2 * number * pi]),
        ([pi / 3, pi / 2], [pi / 3 + 2 * number * pi, pi / 2 + 2 * number * pi]),
        ([a, -a], [a + 2 * number * pi, -a + 2 * number * pi]),
    ],
)
def test_angles_and_any_number_of_turns(angles, merged):
    assert [sp.expand(left - right) for left, right in zip(_merged(angles, number), merged, strict=True)] == [0] * len(
        merged
    )
