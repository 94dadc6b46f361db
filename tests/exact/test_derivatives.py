"""Derivatives of motions are those of sympy, as expressions and in form."""

import pytest
import sympy as sp

from solver.exact.functions.derivatives import derivative_of

t, a = sp.symbols("t a")
MOTIONS = [
    sp.S(3),
    a * t,
    3 * sp.exp(-t) - 2 * t**2 * sp.exp(-3 * t) / 5,
    sp.exp(-t) * sp.cos(2 * t) - t * sp.sin(2 * t) / 7,
    (1 + sp.sqrt(2)) * sp.exp(t * (1 - sp.sqrt(2))),
    sp.Float("0.25") * sp.exp(sp.Float("-1.5") * t),
    sp.cosh(a * t) / a,
    (1 + t**2) ** -1,
]


@pytest.mark.parametrize("motion", MOTIONS)
def test_it_is_the_derivative(motion):
    assert sp.expand(derivative_of(motion, t)) == sp.expand(sp.diff(motion, t))
