"""Where |L(jω)| passes a level, at roots of a polynomial in w = ω², of a discrete loop in c = cos ωT."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.surds import value_of


@dataclass(frozen=True)
class Crossover:
    """A frequency ω ≥ 0 with |L| and ∠L there (degrees, in (−180, 180]); `square` is ω², of a discrete loop cos ωT.

    `clockwise` is, of a crossing of the negative real axis, 1 or −1 for the direction about the origin, 0 where the
    curve only touches it. At an `end`, ω = 0 or π/T, the curve crosses with that of −ω.
    """

    omega: sp.Expr
    square: sp.Expr
    magnitude: sp.Expr
    phase: sp.Expr
    clockwise: int = 0
    end: bool = False


@dataclass(frozen=True)
class GainCrossovers:
    """Where |L| = `level`: roots of |N|² − level² |D|², a polynomial in ω² or cos ωT; `everywhere`: it is zero."""

    polynomial: sp.Poly
    found: tuple[Crossover, ...]
    everywhere: bool = False


@lru_cache(maxsize=64)
def gain_crossovers(L: OnAxis, level: sp.Expr = sp.S.One) -> GainCrossovers:
    """All ω > 0 (of a discrete loop up to π/T) with |L(jω)| = level > 0."""
    p = L.parts.above - L.parts.below * sp.Poly((sp.S.Zero + level) ** 2, L.parts.w)
    if p.is_zero:
        return GainCrossovers(p, (), everywhere=True)
    places = [*L.places(p), *(each for each in [L.end] if each is not None and value_of(p, each.value) == 0)]
    found = tuple(
        Crossover(each.omega, each.value, sp.S.Zero + level, L.phase(each.omega), end=each is L.end) for each in places
    )
    return GainCrossovers(p, found)


__all__ = ["Crossover", "GainCrossovers", "gain_crossovers"]
