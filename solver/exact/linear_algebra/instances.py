"""Elements of K and L as sympy expressions, at a root of the factor."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import sympy as sp

from solver.conditions import conditions_of
from solver.exact.linear_algebra.fields import Algebraic, expression
from solver.exact.linear_algebra.radicals import over_root
from solver.exact.linear_algebra.spectrum import DIGITS, Root


def element_at(a: Algebraic, root: Root) -> sp.Expr:
    """The element of L = K[x]/(p) at x = root, as an expression."""
    K = a.modulus.domain
    coefficients = [expression(K, c) for c in a.coefficients]
    if len(coefficients) == 1:
        return coefficients[0]
    return value_at(coefficients, root)


def value_at(coefficients: Sequence[sp.Expr], root: Root) -> sp.Expr:
    """Σ cᵢ rootⁱ, multiplied out (numbers) or over one denominator (parameters); of a decimal root in decimals."""
    if root.kind == "decimal":
        real, imaginary = decimal_parts(coefficients, root)
        return sp.Add(real, sp.I * imaginary)
    if len(coefficients) == 2 and root.shift.free_symbols and conditions_of(root.shift.free_symbols):
        constant, slope = coefficients
        apart = over_root(slope * root.shift) * (sp.I if root.kind == "complex" else 1)
        return sp.factor(constant + slope * root.sigma) + apart
    value: sp.Expr = sp.Integer(0)
    for c in reversed(coefficients):
        value = sp.expand(value * root.value + c)
    if value.free_symbols and value.is_rational_function():
        return sp.expand(sp.cancel(value))
    return value


def decimal_parts(coefficients: Sequence[sp.Expr], root: Root) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of Σ cᵢ rootⁱ by Horner's rule with guard digits, with as many digits as the root."""
    if not any(coefficients):
        return sp.S.Zero, sp.S.Zero
    with mpmath.workdps(DIGITS + 15):
        x = mpmath.mpc(mpmath.mpmathify(root.sigma), mpmath.mpmathify(root.shift))
        value = mpmath.polyval([_number(c) for c in reversed(coefficients)], x)
        real = sp.Float(mpmath.re(value), DIGITS)
        return real, sp.S.Zero if root.shift == 0 else sp.Float(mpmath.im(value), DIGITS)


def _number(c: sp.Expr) -> Any:
    if isinstance(c, sp.Rational):
        return mpmath.mpf(int(c.p)) / int(c.q)
    return mpmath.mpmathify(sp.N(c, DIGITS + 15))
