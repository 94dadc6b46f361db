"""Discs around eigenvalues: the signs that are known from how the matrix was made, and none where one is zero."""

from math import prod

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.judges.stability.discs import characteristic_coefficients, excess_of_discs
from solver.numeric.judges.stability.location import certain_excess, located

x = sp.Symbol("x")
tiny = sp.Rational(1, 10**12)


def companion(roots):
    low = sp.Poly(prod(x - root for root in roots), x).all_coeffs()[:0:-1]
    n = len(low)
    return sp.ImmutableMatrix(n, n, lambda i, j: -low[j] if i == n - 1 else int(j == i + 1))


def signs(A, *, discrete=False):
    excess = excess_of_discs(A, {}, discrete=discrete)
    return None if excess is None else [sum(excess < 0), sum(excess > 0)]


def test_a_root_close_to_the_boundary_is_told_where_doubles_leave_it_open():
    for root, expected in ((-tiny, [10, 0]), (tiny, [9, 1])):
        A = companion([root, *range(-9, 0)])
        assert certain_excess(A, {}, discrete=False) is None
        assert signs(A) == expected
        assert located(A, {}, discrete=False)[:3] == (expected[0], 0, expected[1])


def test_pairs_and_the_unit_circle():
    pair = [sp.I * 3 - tiny, -sp.I * 3 - tiny]
    double = [sp.I * 5 - sp.Rational(1, 1000), -sp.I * 5 - sp.Rational(1, 1000)] * 2
    assert signs(companion([*pair, *double, -1, -2])) == [8, 0]
    assert signs(companion([*pair, tiny, -7])) == [3, 1]
    assert signs(companion([1 - tiny, -1 + tiny, 0]), discrete=True) == [3, 0]
    assert signs(companion([1 + tiny, -1 + tiny, 0]), discrete=True) == [2, 1]


@pytest.mark.parametrize("on", [0, tiny**3])
def test_on_the_boundary_nothing_is_told(on):
    assert signs(companion([on, -1, -2])) is None
    assert signs(companion([sp.I, -sp.I, -2])) is None
    assert signs(companion([1 + on, sp.Rational(1, 2)]), discrete=True) is None


@given(st.lists(st.integers(-3, 3).filter(bool), min_size=1, max_size=6), st.integers(0, 9), st.randoms())
def test_signs_are_those_of_the_eigenvalues(eigenvalues, power, random):
    n = len(eigenvalues)
    T = sp.Matrix(n, n, lambda i, j: int(i == j) or (random.randint(-3, 3) if j < i else 0))
    J = sp.Matrix(n, n, lambda i, j: sp.Rational(eigenvalues[i], 10**power) if i == j else int(j == i + 1))
    found = signs(sp.ImmutableMatrix(T * J * T.inv()))
    assert found in ([sum(each < 0 for each in eigenvalues), sum(each > 0 for each in eigenvalues)], None)


def test_the_coefficients_are_those_of_the_polynomial():
    roots = [-1, -2, -3, -4, -20]
    found = characteristic_coefficients(companion(roots), {}, multiple(50))
    assert np.allclose(np.array(found, dtype=float), np.poly(roots), rtol=1e-14, atol=0)
