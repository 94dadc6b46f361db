"""The parts of N and D on the boundary of stability, as polynomials: in w = ω², of a discrete loop in c = cos ωT.

On the axis p(jω) = E(w) + jω O(w), on the unit circle p(e^{jωT}) = E(c) + j sin ωT O(c).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import sympy as sp

from solver.exact.stability.boundary import parts_on_circle


@dataclass(frozen=True)
class Parts:
    """N = E + ju O and D = e + ju o with u = ω or sin ωT, polynomials in `w`, and R, I, |N|², |D|² made of them.

    `unit` is u²: w, of a discrete loop 1 − c².
    """

    E: sp.Poly
    O: sp.Poly
    e: sp.Poly
    o: sp.Poly
    w: sp.Symbol
    unit: sp.Poly

    @cached_property
    def real(self) -> sp.Poly:
        """R = E e + u² O o."""
        return self.E * self.e + self.O * self.o * self.unit

    @cached_property
    def imaginary(self) -> sp.Poly:
        """I = O e − E o."""
        return self.O * self.e - self.E * self.o

    @cached_property
    def above(self) -> sp.Poly:
        """|N|² = E² + u² O²."""
        return self.E**2 + self.O**2 * self.unit

    @cached_property
    def below(self) -> sp.Poly:
        """|D|² = e² + u² o²."""
        return self.e**2 + self.o**2 * self.unit


def parts_by_squares(N: sp.Poly, D: sp.Poly) -> Parts:
    """The parts on the imaginary axis."""
    w = sp.Symbol("w")
    (E, O), (e, o) = (_even_and_odd(p, w) for p in (N, D))
    return Parts(E, O, e, o, w, sp.Poly(w, w, domain=N.domain))


def parts_by_cosines(N: sp.Poly, D: sp.Poly) -> Parts:
    """The parts on the unit circle."""
    c = sp.Symbol("c")
    (E, O), (e, o) = (parts_on_circle(p, c) for p in (N, D))
    return Parts(E, O, e, o, c, sp.Poly(1 - c**2, c, domain=N.domain))


def _even_and_odd(p: sp.Poly, w: sp.Symbol) -> tuple[sp.Poly, sp.Poly]:
    """E and O of p(jω) = E(ω²) + jω O(ω²)."""
    rising = list(reversed(p.rep.to_list()))
    K = p.domain
    found = []
    for first in (0, 1):
        listed = [c if i % 2 == 0 else -c for i, c in enumerate(rising[first::2])]
        found.append(sp.Poly(list(reversed(listed)) or [K.zero], w, domain=K))
    return found[0], found[1]


__all__ = ["Parts", "parts_by_cosines", "parts_by_squares"]
