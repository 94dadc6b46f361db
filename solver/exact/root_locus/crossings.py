"""Where branches meet the imaginary axis: D(jω) + K N(jω) = 0 with K > 0, by the even and the odd parts."""

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
from solver.exact.stability.root_counts import root_counts


@dataclass(frozen=True)
class AxisParts:
    """D(jω) = a + jω b and N(jω) = c + jω d, polynomials in u = ω²; K from a + K c = 0 and b + K d = 0.

    `eliminated` is a d − b c, zero at the crossings; it is 0 where whole branches lie on the axis.
    """

    real: tuple[sp.Poly, sp.Poly]
    imaginary: tuple[sp.Poly, sp.Poly]
    eliminated: sp.Poly


@dataclass(frozen=True)
class Crossing:
    """Branches at ±jω for the gain K > 0; `square` is ω²."""

    frequency: sp.Expr
    square: sp.Expr
    gain: sp.Expr


def on_imaginary_axis(equation: LocusEquation) -> AxisParts:
    """The parts of D(jω) and N(jω)."""
    (a, b), (c, d) = (_parts(p) for p in (equation.denominator, equation.numerator))
    return AxisParts((a, c), (b, d), a * d - b * c)


def _parts(p: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    """The even part and the odd part over jω, in u = ω²: s² is −u."""
    u, listed = sp.Symbol("u"), list(reversed(p.rep.to_list()))
    parts = []
    for first in (0, 1):
        signed = [c if i % 2 == 0 else -c for i, c in enumerate(listed[first::2])]
        parts.append(sp.Poly(list(reversed(signed)) or [p.domain.zero], u, domain=p.domain))
    return parts[0], parts[1]


def crossings(equation: LocusEquation) -> tuple[Crossing, ...]:
    """The points of the imaginary axis with K > 0, by rising gains; none that lie on a branch along the axis."""
    return _crossings(equation)


@lru_cache(maxsize=16)
def _crossings(equation: LocusEquation) -> tuple[Crossing, ...]:
    axis = on_imaginary_axis(equation)
    found = [each for each in [_at_the_origin(equation)] if each is not None]
    for at in roots_with_factors(axis.eliminated) if not axis.eliminated.is_zero else ():
        if at.real and sp.N(at.value, WORKING_DIGITS) > 0:
            gain = _gain(axis, at)
            if gain is not None and sp.N(gain, WORKING_DIGITS) > 0:
                found.append(Crossing(_root(at.value), at.value, gain))
    return tuple(sorted(found, key=lambda each: (sp.N(each.gain, 40), sp.N(each.frequency, 40))))


def _at_the_origin(equation: LocusEquation) -> Crossing | None:
    N, D = equation.numerator.TC(), equation.denominator.TC()
    if N == 0 or D == 0:
        return None
    gain = sp.radsimp(-D / N)
    zero = sp.Integer(0)
    return Crossing(zero, zero, gain) if sp.N(gain, WORKING_DIGITS) > 0 else None


def _gain(axis: AxisParts, at: PlacedRoot) -> sp.Expr | None:
    """K from the equation that tells it; None at a zero of L."""
    for constant, slope in (axis.real, axis.imaginary):
        if element_of(slope, at):
            return value_of(-quotient_at(constant, slope, at), at)
    return None


def _root(square: sp.Expr) -> sp.Expr:
    """ω; a decimal where a square root stands below the root."""
    found = sp.sqrtdenest(square_root(square))
    nested = any(each.base.has(sp.Pow) for each in found.atoms(sp.Pow) if not each.base.is_Rational)
    return sp.Float(sp.N(square, DIGITS + 10) ** sp.Rational(1, 2), DIGITS) if nested else found


@dataclass(frozen=True)
class Range:
    """For `low` < K < `high`, `outside` poles of the loop lie in the right half plane and `on` on the axis."""

    low: sp.Expr
    high: sp.Expr
    outside: int
    on: int


def stable_gains(equation: LocusEquation) -> tuple[Range, ...]:
    """The ranges of K > 0 between critical gains, with the numbers of poles that are not in the left half plane."""
    cuts = [sp.Integer(0), *(each.gain for each in crossings(equation))]
    if on_imaginary_axis(equation).eliminated.is_zero:  # whole branches lie on the axis and leave it where they meet
        cuts += [each.gain for each in meetings(equation) if each.belongs and each.gain]
    if equation.excess == 0 and not equation.positive:
        cuts.append(sp.radsimp(-1 / equation.lead))  # a pole passes through infinity
    rising: list[sp.Expr] = []
    for cut in sorted(cuts, key=lambda each: sp.N(each, 40)):
        if not rising or sp.N(cut - rising[-1], 40) > sp.Float(10) ** -25:
            rising.append(cut)
    always = root_counts(expressions_of(equation.common)) if equation.common.degree() else None
    more = (always.outside, always.on) if always else (0, 0)
    found: list[Range] = []
    for low, high in zip(rising, [*rising[1:], sp.oo], strict=True):
        counts = root_counts(equation.coefficients(_between(low, high)))
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
