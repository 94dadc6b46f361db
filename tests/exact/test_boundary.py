"""Roots on the boundary of stability, against numpy; ends of conditions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.exact import boundary_roots, edges

a, b, K = sp.symbols("a b K", real=True)
small = st.integers(-5, 5)


@pytest.mark.parametrize(
    ("coefficients", "discrete", "roots"),
    [
        ([1, a, b, a * b], False, [sp.I * sp.sqrt(b)]),
        ([1, a, b, 0], False, [0]),
        ([1, 2, 3, 6], False, [sp.I * sp.sqrt(3)]),
        ([1, 1, 0, 0], False, []),  # twice zero: what is left grows
        ([1, 0, 2, 0, 1], False, []),  # twice j and -j
        ([1, 0, -4], False, []),  # real, on both sides
        ([1, 2, 3, 4], False, []),
        ([1, -K, K - 1], True, [1]),
        ([1, 0, -1], True, [1, -1]),
        ([1, -1, 1], True, [sp.Rational(1, 2) + sp.sqrt(3) * sp.I / 2]),
    ],
)
def test_simple_roots_on_the_boundary(coefficients, discrete, roots):
    assert list(boundary_roots([sp.sympify(c) for c in coefficients], discrete=discrete)) == roots


@given(st.integers(1, 9), small, small)
def test_pairs_on_the_axis_are_those_of_numpy(square, p, q):
    """(s² + ω²)(s² + p s + q) with simple roots."""
    assume(q != 0 and not (p == 0 and (q >= 0)))
    coefficients = np.polymul([1, 0, square], [1, p, q])
    found = boundary_roots([sp.Integer(int(c)) for c in coefficients], discrete=False)
    expected = sorted({round(r.imag, 6) for r in np.roots(coefficients) if abs(r.real) < 1e-6 and r.imag > 0})
    assert np.allclose(sorted(float(sp.im(root)) for root in found), expected)


def test_the_ends_of_a_condition():
    assert set(edges((K > 0) & (a * b > K))) == {(K, 0), (K, a * b)}
    assert edges((a * b - K > 0) & (sp.sin(K) < 1)) == ((K, a * b),)
    assert set(edges((-b < K) & (b * K + a > 0))) == {(K, -b), (a, -b * K)}
    assert edges((a * b * K > 1) & (a * b < K**2)) == ()
