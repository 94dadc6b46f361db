"""Where branches meet the boundary of stability with K > 0: D(jω) + K N(jω) = 0, in discrete time D + K N at e^{jθ}.

With the even and the odd parts, p(jω) = a(ω²) + jω b(ω²); on the unit circle p(e^{jθ}) = a(cos θ) + j sin θ b(cos θ).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import expression, in_powers
from solver.exact.linear_algebra.radicals import square_root
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.root_locus.breakaway import meetings
from solver.exact.root_locus.equation import (
    WORKING_DIGITS,
    LocusEquation,
    PlacedRoot,
    element_of,
    expressions_of,
    quotient_at,
    roots_with_factors,
    value_of,
)
from solver.exact.stability.boundary import parts_on_circle
from solver.exact.stability.root_counts import root_counts


@dataclass(frozen=True)
class BoundaryParts:
    """D = a + jω b and N = c + jω d on the axis, polynomials in u = ω²; K from a + K c = 0 and b + K d = 0.

    On the circle sin θ stands for ω, and they are polynomials in cos θ. `eliminated` is a d − b c, zero at the
    crossings; it is 0 where whole branches lie on the boundary.
    """

    real: tuple[sp.Poly, sp.Poly]
    imaginary: tuple[sp.Poly, sp.Poly]
    eliminated: sp.Poly


@dataclass(frozen=True)
class Crossing:
    """Branches at a pair of points of the boundary, `point` above the real axis or on it, for the gain K > 0.

    On the imaginary axis point = jω with ω² = `place`, on the unit circle e^{jθ} with cos θ = `place`.
    """

    point: sp.Expr
    place: sp.Expr
    gain: sp.Expr

    @property
    def real(self) -> bool:
        """Whether it is one point of the real axis, no pair."""
        return not self.point.has(sp.I)


def on_boundary(equation: LocusEquation) -> BoundaryParts:
    """The parts of D and N on the boundary of stability."""
    (a, b), (c, d) = (_parts(p, discrete=equation.discrete) for p in (equation.denominator, equation.numerator))
    return BoundaryParts((a, c), (b, d), a * d - b * c)


def _parts(p: sp.Poly, *, discrete: bool) -> tuple[sp.Poly, sp.Poly]:
    """The even part and the odd part over jω, in u = ω²: s² is −u; on the circle those in the cosine."""
    if discrete:
        return parts_on_circle(p, sp.Symbol("c"))
    u, listed = sp.Symbol("u"), list(reversed(p.rep.to_list()))
    parts = []
    for first in (0, 1):
        signed = [c if i % 2 == 0 else -c for i, c in enumerate(listed[first::2])]
        parts.append(sp.Poly(list(reversed(signed)) or [p.domain.zero], u, domain=p.domain))
    return parts[0], parts[1]


def crossings(equation: LocusEquation) -> tuple[Crossing, ...]:
    """The points of the boundary with K > 0, by rising gains; none that lie on a branch along it."""
    return _crossings(equation)


@lru_cache(maxsize=16)
def _crossings(equation: LocusEquation) -> tuple[Crossing, ...]:
    parts, discrete = on_boundary(equation), equation.discrete
    real = (_on_the_real_axis(equation, x) for x in ((1, -1) if discrete else (0,)))
    found = [each for each in real if each is not None]
    for at in roots_with_factors(parts.eliminated) if not parts.eliminated.is_zero else ():
        if at.real and _is_inside(at.value, discrete=discrete):
            gain = _gain(parts, at)
            if gain is not None and sp.N(gain, WORKING_DIGITS) > 0:
                point = _on_circle(at.value) if discrete else sp.I * _root(at.value)
                found.append(Crossing(point, at.value, gain))
    return tuple(sorted(found, key=lambda each: (sp.N(each.gain, 40), sp.N(sp.im(each.point), 40))))


def _is_inside(place: sp.Expr, *, discrete: bool) -> bool:
    """Whether a real root is that of a pair: ω² > 0, or a cosine between −1 and 1."""
    value = sp.N(place, WORKING_DIGITS)
    return bool(-1 < value < 1) if discrete else bool(value > 0)


def _on_the_real_axis(equation: LocusEquation, x: int) -> Crossing | None:
    """Where a branch passes the real point of the boundary: the origin, on the circle 1 or −1."""
    at = sp.Integer(x)
    N, D = (sp.expand(p(at)) for p in (equation.numerator, equation.denominator))
    if N == 0 or D == 0:
        return None
    gain = sp.radsimp(-D / N)
    return Crossing(at, at, gain) if sp.N(gain, WORKING_DIGITS) > 0 else None


def _gain(parts: BoundaryParts, at: PlacedRoot) -> sp.Expr | None:
    """K from the equation that tells it; None at a zero of L."""
    for constant, slope in (parts.real, parts.imaginary):
        if element_of(slope, at):
            return value_of(-quotient_at(constant, slope, at), at)
    return None


def _root(square: sp.Expr) -> sp.Expr:
    """ω; a decimal where a square root stands below the root."""
    found = sp.sqrtdenest(square_root(square))
    nested = any(each.base.has(sp.Pow) for each in found.atoms(sp.Pow) if not each.base.is_Rational)
    return sp.Float(sp.N(square, DIGITS + 10) ** sp.Rational(1, 2), DIGITS) if nested else found


def _on_circle(cosine: sp.Expr) -> sp.Expr:
    """The point c + j√(1 − c²) of the unit circle, both parts decimals where the root is one."""
    sine = _root(sp.expand(1 - cosine**2))
    return (sp.Float(sp.N(cosine, DIGITS + 10), DIGITS) if sine.has(sp.Float) else cosine) + sp.I * sine


@dataclass(frozen=True)
class Range:
    """For `low` < K < `high`, `outside` poles of the loop lie outside of the region of stability, `on` its boundary."""

    low: sp.Expr
    high: sp.Expr
    outside: int
    on: int


def stable_gains(equation: LocusEquation) -> tuple[Range, ...]:
    """The ranges of K > 0 between critical gains, with the numbers of poles that are not in the region of stability."""
    cuts = [sp.Integer(0), *(each.gain for each in crossings(equation))]
    if on_boundary(equation).eliminated.is_zero:  # whole branches lie on the boundary and leave it where they meet
        cuts += [each.gain for each in meetings(equation) if each.belongs and each.gain]
    if equation.excess == 0 and not equation.positive:
        cuts.append(sp.radsimp(-1 / equation.lead))  # a pole passes through infinity
    rising: list[sp.Expr] = []
    for cut in sorted(cuts, key=lambda each: sp.N(each, 40)):
        if not rising or sp.N(cut - rising[-1], 40) > sp.Float(10) ** -25:
            rising.append(cut)
    discrete, common = equation.discrete, equation.common
    always = root_counts(expressions_of(common), discrete=discrete) if common.degree() else None
    more = (always.outside, always.on) if always else (0, 0)
    found: list[Range] = []
    for low, high in zip(rising, [*rising[1:], sp.oo], strict=True):
        counts = root_counts(equation.coefficients(_between(low, high)), discrete=discrete)
        assert counts is not None  # noqa: S101 - the coefficients are numbers
        found.append(Range(low, high, counts.outside + more[0], counts.on + more[1]))
    return tuple(found)


def _between(low: sp.Expr, high: sp.Expr) -> sp.Rational:
    """A short rational number between two ends."""
    a, b = (sp.N(each, WORKING_DIGITS) for each in (low, high))
    if high == sp.oo:
        return sp.floor(a) + 1
    middle, digits = (a + b) / 2, 1
    while True:
        found = sp.Rational(str(sp.N(middle, digits)))
        if a < found < b:
            return found
        digits += 1


def in_squares(p: sp.Poly, omega: sp.Symbol) -> sp.Expr:
    """A polynomial in u = ω² as an expression in ω."""
    listed: list[Any] = []
    for c in p.rep.to_list():
        listed += [c, p.domain.zero]
    return in_powers(listed[:-1], p.domain, omega) if listed else expression(p.domain, p.domain.zero)
