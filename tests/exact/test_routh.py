"""Routh arrays: textbook arrays, both special cases, counts against numpy, the bilinear image."""

from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact import bilinear, routh, routh_parts, sign_of
from tests.helpers.tried import tried

s, k, eps = sp.Symbol("s"), sp.Symbol("k", real=True), sp.Symbol("epsilon")


def changes(array):
    signs = [sign_of(entry) for entry in array.at_zero]
    return sum(first != second for first, second in pairwise(signs))


def count(coefficients):
    """Roots in the right half plane, by the arrays of the parts."""
    return sum(m * changes(routh(part)) for part, m in routh_parts(coefficients))


@pytest.mark.parametrize(
    ("coefficients", "rows"),
    [
        ([1, 2, 3, 4, 5], [[1, 3, 5], [2, 4, 0], [1, 5, 0], [-6, 0, 0], [5, 0, 0]]),
        ([1, 10, 31, 1030], [[1, 31], [10, 1030], [-72, 0], [1030, 0]]),
        ([3, 7, 6, 14, 3, 7], [[3, 6, 3], [7, 14, 7], [28, 28, 0], [7, 7, 0], [14, 0, 0], [7, 0, 0]]),
        ([1, 2, 1, k], [[1, 1], [2, k], [1 - k / 2, 0], [k, 0]]),
        ([1, 0], [[1], [1]]),
        ([7], [[7]]),
    ],
)  # fmt: skip
def test_textbook_arrays(coefficients, rows):
    assert [row.power for row in routh(coefficients).rows] == list(range(len(coefficients) - 1, -1, -1))
    assert (routh([sp.sympify(c) for c in coefficients]).matrix - sp.Matrix(rows)).applyfunc(sp.cancel).is_zero_matrix


def test_a_zero_pivot_becomes_epsilon():
    array = routh([1, 2, 2, 4, 11, 10])
    assert array.rows[2].special == "pivot"
    assert array.rows[2].computed[0] == 0
    assert array.rows[2].entries == (eps, 6)
    assert sp.cancel(array.rows[3].entries[0] - (4 - 12 / eps)) == 0
    assert changes(array) == 2


def test_a_row_of_zeros_becomes_the_derivative_of_the_auxiliary_polynomial():
    row = routh([1, 7, 6, 42, 8, 56]).rows[2]
    assert row.special == "zeros"
    assert row.computed == (0, 0)
    assert row.auxiliary == (7, 42, 56)
    assert row.entries == (28, 84)


def test_epsilon_avoids_a_parameter_of_its_name():
    assert routh([1, 0, eps, 2]).epsilon == sp.Symbol("varepsilon")


def test_a_leading_zero_is_refused():
    with pytest.raises(ValueError, match="leading"):
        routh([0, 1])


def test_epsilon_and_symmetric_roots_are_counted_apart():
    coefficients = [sp.Integer(c) for c in (1, 1, 3, 3, 3, 2, 1)]  # (s² + 1)(s⁴ + s³ + 2s² + 2s + 1)
    assert changes(routh(coefficients)) == 4
    assert count(coefficients) == 2


roots = st.lists(
    st.one_of(
        st.tuples(st.integers(-3, 3)),
        st.tuples(st.integers(-2, 2), st.sampled_from([1, 2])),
    ),
    min_size=1,
    max_size=4,
)


@tried(60)
@given(roots)
def test_the_number_of_roots_in_the_right_half_plane(listed):
    factors = [s - r[0] if len(r) == 1 else (s - r[0]) ** 2 + r[1] ** 2 for r in listed]
    coefficients = sp.Poly(sp.prod(factors), s).all_coeffs()
    outside = sum((1 if len(r) == 1 else 2) for r in listed if r[0] > 0)
    assert count(coefficients) == outside


@tried(40)
@given(st.lists(st.integers(-6, 6), min_size=2, max_size=6))
def test_numpy_counts_the_same(tail):
    found = np.roots([1, *tail])
    if np.all(np.abs(found.real) > 1e-3):
        assert count([sp.Integer(c) for c in (1, *tail)]) == np.sum(found.real > 0)


def test_the_bilinear_image_has_the_roots_moved():
    image = bilinear([sp.Integer(1), sp.Integer(-1), sp.Rational(1, 2)])
    z = np.roots([1, -1, 0.5])
    assert np.allclose(np.sort_complex(np.roots([float(c) for c in image])), np.sort_complex((z + 1) / (z - 1)))
