"""Where |L(jω)| passes a level, at roots of a polynomial in w = ω²: exact where they are of degree two at most."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.surds import decimal, root_of
from solver.exact.linear_algebra.spectrum import DIGITS, roots_of

ROUGH = 1e-5
"""Rough roots so near to the real axis may lie on it."""


@dataclass(frozen=True)
class PositiveRoot:
    """A root w = ω² > 0 with its multiplicity; decimals (30 digits) where its irreducible factor is of degree ≥ 3."""

    square: sp.Expr
    multiplicity: int

    @property
    def omega(self) -> sp.Expr:
        """The frequency."""
        return root_of(self.square)


@dataclass(frozen=True)
class Crossover:
    """A frequency ω ≥ 0 with |L| and ∠L there (degrees, in (−180, 180]).

    `clockwise` is, of a crossing of the negative real axis, 1 or −1 for the direction about the origin, 0 where the
    curve only touches it; ω = 0, where the curve crosses with that of −ω, counts so too.
    """

    omega: sp.Expr
    square: sp.Expr
    magnitude: sp.Expr
    phase: sp.Expr
    clockwise: int = 0


@dataclass(frozen=True)
class GainCrossovers:
    """Where |L| = `level`: the positive roots of |N|² − level² |D|², a polynomial in ω²; `everywhere`: it is zero."""

    polynomial: sp.Poly
    found: tuple[Crossover, ...]
    everywhere: bool = False


def positive_roots(p: sp.Poly) -> list[PositiveRoot]:
    """The positive roots of a polynomial, rising, each once."""
    found: list[PositiveRoot] = []
    for factor, m in p.factor_list()[1]:
        monic = factor.to_field().monic()
        for root in _numbers(monic):
            if root.is_real and decimal(root) > 0:
                found.append(PositiveRoot(root, m))
    return sorted(found, key=lambda each: decimal(each.square))


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


@lru_cache(maxsize=64)
def gain_crossovers(L: OnAxis, level: sp.Expr = sp.S.One) -> GainCrossovers:
    """All ω > 0 with |L(jω)| = level > 0."""
    p = L.parts.above - L.parts.below * sp.Poly((sp.S.Zero + level) ** 2, L.parts.w)
    if p.is_zero:
        return GainCrossovers(p, (), everywhere=True)
    found = tuple(
        Crossover(root.omega, root.square, sp.S.Zero + level, L.phase(root.omega)) for root in positive_roots(p)
    )
    return GainCrossovers(p, found)


__all__ = ["Crossover", "GainCrossovers", "PositiveRoot", "gain_crossovers", "positive_roots"]
