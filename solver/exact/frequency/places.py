"""Real roots of polynomials in w = ω², or in c = cos ωT: exact where they are of degree two at most."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.surds import decimal
from solver.exact.linear_algebra.spectrum import DIGITS, roots_of

ROUGH = 1e-5
"""Rough roots so near to the real axis may lie on it."""


@dataclass(frozen=True)
class Place:
    """A frequency ω and what it is a root by, ω² or cos ωT, as often as `multiplicity` says.

    In decimals (30 digits) where the irreducible factor is of degree ≥ 3.
    """

    omega: sp.Expr
    value: sp.Expr
    multiplicity: int


def real_roots(p: sp.Poly) -> list[tuple[sp.Expr, int]]:
    """The real roots of a polynomial, rising, each once with its multiplicity."""
    found = [(root, m) for factor, m in p.factor_list()[1] for root in _numbers(factor.to_field().monic())]
    return sorted(((root, m) for root, m in found if root.is_real), key=lambda pair: decimal(pair[0]))


def _numbers(p: sp.Poly) -> list[sp.Expr]:
    """The real roots of an irreducible polynomial."""
    if p.degree() <= 2:
        return [sp.expand(root.value) for root in roots_of(p) if not root.value.has(sp.I)]
    with mpmath.workdps(2 * DIGITS):
        listed = [decimal(c) for c in p.all_coeffs()]
        found = _refined(listed)
        if p.domain.is_QQ and len(found) != p.count_roots():
            zeros = map(mpmath.mpc, mpmath.polyroots(listed, maxsteps=500, extraprec=400))
            tiny = mpmath.mpf(10) ** -DIGITS
            found = [z.real for z in zeros if abs(z.imag) < tiny * (1 + abs(z))]
        return [sp.Float(x, DIGITS) for x in found]


def _refined(listed: list[Any]) -> list[Any]:
    """The real roots by Newton's method from rough ones, each between two places of different sign."""
    slope = [c * (len(listed) - 1 - i) for i, c in enumerate(listed[:-1])]
    with mpmath.workdps(15):
        rough = mpmath.polyroots([+c for c in listed], maxsteps=200, extraprec=60)
    found = []
    for z in map(mpmath.mpc, rough):
        if abs(z.imag) > ROUGH * (1 + abs(z)):
            continue
        x = mpmath.mpf(z.real)
        for _ in range(6):
            below = mpmath.polyval(slope, x)
            x = x - mpmath.polyval(listed, x) / below if below else x
        step = abs(x) * mpmath.mpf(10) ** (-DIGITS - 5)
        if mpmath.polyval(listed, x - step) * mpmath.polyval(listed, x + step) < 0:
            found.append(x)
    return found


__all__ = ["Place", "real_roots"]
