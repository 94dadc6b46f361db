"""Polynomials at a number w: at rationals and at a + b√c by arithmetic of the field, at decimals in decimals."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.spectrum import DIGITS

WORKING = DIGITS + 15
"""Decimal digits that are carried on the way."""


def decimal(value: Any) -> Any:
    """A real number in mpmath's decimals."""
    if value.is_Rational:
        return mpmath.mpf(value.p) / value.q
    if value.is_Float:
        return mpmath.mpf(value._mpf_)
    return mpmath.mpmathify(sp.N(value, WORKING))


def surd(x: Any) -> tuple[Any, Any, Any] | None:
    """a, b and c of x = a + b√c, all rational; None for another number."""
    a, rest = x.as_coeff_Add()
    b, root = rest.as_coeff_Mul()
    if not (root.is_Pow and root.exp == sp.S.Half and root.base.is_Rational):
        return None
    return a, b, root.base


def value_of(p: sp.Poly, x: sp.Expr) -> sp.Expr:
    """p(x), multiplied out."""
    if x.has(sp.Float):
        with mpmath.workdps(WORKING):
            return sp.Float(mpmath.polyval([decimal(c) for c in p.all_coeffs()], decimal(x)), WORKING)
    if p.domain.is_QQ and (found := surd(x)) is not None:
        rest = p.rem(_minimal(*found, p.gen))
        return sp.expand(rest.nth(1) * x + rest.nth(0))
    value: sp.Expr = sp.S.Zero
    for c in p.all_coeffs():
        value = sp.expand(value * x + c)
    return value


def ratio_of(p: sp.Poly, q: sp.Poly, x: sp.Expr) -> sp.Expr:
    """p(x)/q(x), multiplied out, where q(x) is not zero."""
    if not x.has(sp.Float) and p.domain.is_QQ and (found := surd(x)) is not None:
        m = _minimal(*found, p.gen)
        rest = (p.rem(m) * q.rem(m).invert(m)).rem(m)
        return sp.expand(rest.nth(1) * x + rest.nth(0))
    value = value_of(p, x) / value_of(q, x)
    return value if value.is_Rational or value.has(sp.Float) else sp.expand(sp.radsimp(value))


@lru_cache(maxsize=64)
def _minimal(a: sp.Expr, b: sp.Expr, c: sp.Expr, x: sp.Symbol) -> sp.Poly:
    """(x − a)² − b² c."""
    return sp.Poly([1, -2 * a, a**2 - b**2 * c], x, domain=sp.QQ)


def reciprocal(x: sp.Expr) -> sp.Expr:
    """1/x without a root below."""
    if x.has(sp.Float) or x.is_Rational:
        return 1 / x
    if (found := surd(x)) is not None:
        a, b, c = found
        return sp.expand((2 * a - x) / (a**2 - b**2 * c))
    return sp.radsimp(1 / x)


def root_of(x: sp.Expr) -> sp.Expr:
    """√x of a positive number, taken apart where that is possible: √(3 + 2√2) = 1 + √2."""
    if x.has(sp.Float):
        return sp.Float(sp.sqrt(x), DIGITS)
    if (found := surd(x)) is not None:
        a, b, c = found
        whole = sp.sqrt(a**2 - b**2 * c)
        return sp.expand(sp.sqrtdenest(sp.sqrt(x))) if whole.is_Rational else sp.sqrt(x)
    return sp.sqrt(x)


__all__ = ["WORKING", "decimal", "ratio_of", "reciprocal", "root_of", "surd", "value_of"]
