"""Elements of K and L as sympy expressions, at a root of the factor."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import sympy as sp

from solver.conditions import conditions_of
from solver.exact.linear_algebra.biquadratic import powers_at, tidied
from solver.exact.linear_algebra.fields import Algebraic, expression
from solver.exact.linear_algebra.radicals import over_root
from solver.exact.linear_algebra.spectrum import DIGITS, Factor, Root


def element_at(a: Algebraic, root: Root) -> sp.Expr:
    """The element of L = K[x]/(p) at x = root, as an expression."""
    K = a.modulus.domain
    coefficients = [expression(K, c) for c in a.coefficients]
    if len(coefficients) == 1:
        return coefficients[0]
    return value_at(coefficients, root)


def value_at(coefficients: Sequence[sp.Expr], root: Root) -> sp.Expr:
    """Σ cᵢ rootⁱ, multiplied out (numbers) or over one denominator (parameters); of a decimal root in decimals."""
    if root.kind == "decimal" or len(coefficients) > 2:
        real, imaginary = parts_at(coefficients, root)
        return sp.Add(real, sp.I * imaginary)
    known = root.kind == "surd" or conditions_of(root.shift.free_symbols)
    if len(coefficients) == 2 and root.shift.free_symbols and known:
        constant, slope = coefficients
        apart = over_root(slope * root.shift) * (sp.I if root.kind == "complex" else 1)
        return sp.factor(constant + slope * root.sigma) + apart
    value: sp.Expr = sp.Integer(0)
    for c in reversed(coefficients):
        value = sp.expand(value * root.value + c)
    if value.free_symbols and value.is_rational_function():
        return sp.expand(sp.cancel(value))
    return value


def parts_at(coefficients: Sequence[sp.Expr], root: Root) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of Σ cᵢ rootⁱ, for a factor of degree 3 or more.

    In decimals by Horner's rule with guard digits, with as many digits as the root; an integer alone stays one.
    """
    if not any(coefficients[1:]) and (coefficients[0].is_Integer or root.kind != "decimal"):
        return coefficients[0], sp.S.Zero
    if root.kind == "surd":
        return powers_at(coefficients, root.value, sp.S.Zero)
    if root.kind == "complex":
        return powers_at(coefficients, root.sigma, root.shift)
    with mpmath.workdps(DIGITS + 15):
        x = mpmath.mpc(mpmath.mpmathify(root.sigma), mpmath.mpmathify(root.shift))
        value = mpmath.polyval([_number(c) for c in reversed(coefficients)], x)
        real = sp.Float(mpmath.re(value), DIGITS)
        return real, sp.S.Zero if root.shift == 0 else sp.Float(mpmath.im(value), DIGITS)


def _number(c: sp.Expr) -> Any:
    if isinstance(c, sp.Rational):
        return mpmath.mpf(int(c.p)) / int(c.q)
    return mpmath.mpmathify(sp.N(c, DIGITS + 15))


def squares_of_roots(factor: Factor) -> list[sp.Expr]:
    """The two values of x² at the roots of x⁴ + bx² + c that are not in decimals, the larger or upper one first."""
    squares = []
    for root in factor.roots:
        real = root.kind == "surd"
        sigma, omega = (root.value, sp.S.Zero) if real else (root.sigma, root.shift)
        squares.append(tidied(sigma**2 - omega**2) + sp.I * tidied(2 * sigma * omega))
    first, second = dict.fromkeys(squares)
    distance = first - second
    lower = sp.re(distance).is_negative or (sp.re(distance).is_zero and sp.im(distance).is_negative)
    return [second, first] if lower else [first, second]
