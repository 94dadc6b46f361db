"""The gain at which a loop begins to oscillate: roots of D(s) + K N(s) on the imaginary axis.

With N(jω) = Nₑ + jω Nₒ and D(jω) = Dₑ + jω Dₒ, polynomials in w = ω², the real and the imaginary part are
Dₑ + K Nₑ = 0 and ω (Dₒ + K Nₒ) = 0; without K, Dₑ Nₒ − Dₒ Nₑ = 0. Between the gains found no root crosses the axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.design.placement import roots_of
from solver.exact.frequency.axis import on_axis
from solver.exact.frequency.encirclements import encirclements
from solver.exact.frequency.real_axis import phase_crossovers
from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.root_counts import root_counts

BELOW = 1 - 1e-6
"""Times the ultimate gain the loop is still stable."""

NEAREST = sp.Rational(1, 10**9)
"""Relative distance below which two gains in decimals are taken for one."""


@dataclass(frozen=True)
class Axis:
    """Real and imaginary part of D + K N at jω as pairs (without K, factor of K) in w = ω²; the second over ω.

    `equation` is Dₑ Nₒ − Dₒ Nₑ.
    """

    real: tuple[sp.Expr, sp.Expr]
    imaginary: tuple[sp.Expr, sp.Expr]
    equation: sp.Expr
    w: sp.Symbol


@dataclass(frozen=True)
class Oscillation:
    """A gain K > 0 with roots ±jω; ω = 0 for a root at the origin; `square` is ω²."""

    gain: sp.Expr
    frequency: sp.Expr
    square: sp.Expr


@dataclass(frozen=True)
class GainInterval:
    """Gains between `start` and `stop` (∞: oo), and how many roots lie in the right half plane there."""

    start: sp.Expr
    stop: sp.Expr
    outside: int


@dataclass(frozen=True)
class UltimateGain:
    """Crossings by rising gain, the intervals between them, and the crossing at which stability is lost.

    `why` is empty, or says why there is none: "never_stable", "never_oscillates" (stable however large K is),
    "at_the_origin" (the root that crosses is real), "at_infinity" (the degree drops).
    """

    crossings: tuple[Oscillation, ...]
    intervals: tuple[GainInterval, ...]
    ultimate: Oscillation | None
    why: str = ""


def on_the_axis(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol) -> Axis:
    """Return the two conditions for a root of D + K N at jω. N and D are polynomials in s with real numbers."""
    w = sp.Symbol("w")
    (De, Do), (Ne, No) = (_parts(p, s, w) for p in (denominator, numerator))
    return Axis((De, Ne), (Do, No), sp.expand(De * No - Do * Ne), w)


def _parts(p: sp.Expr, s: sp.Symbol, w: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Even and odd part at jω: p(jω) = E(ω²) + jω O(ω²)."""
    terms = sp.Poly(p, s).terms()
    even = sp.Add(*(c * (-w) ** (k // 2) for (k,), c in terms if k % 2 == 0))
    odd = sp.Add(*(c * (-w) ** (k // 2) for (k,), c in terms if k % 2))
    return even, odd


def ultimate_gain(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol) -> UltimateGain:
    """Return where D + K N has roots on the axis for K > 0, and the least K at which a stable loop begins to oscillate.

    N and D have real numbers as coefficients, D a higher degree than N or the same. Raises NotExact as `spectrum` does.
    """
    axis = on_the_axis(numerator, denominator, s)
    roots = _positive_roots(axis.equation, axis.w)
    found = [Oscillation(K, _root(w), w) for w in roots if (K := _gain(axis, w)) is not None]
    zero = _ratio(denominator, numerator, s, 0)
    found += [Oscillation(zero, sp.Integer(0), sp.Integer(0))] if zero is not None else []
    crossings = tuple(sorted(found, key=lambda each: (_size(each.gain), _size(each.frequency))))
    degree = sp.degree(denominator, s)
    drop = _ratio(denominator, numerator, s, degree)
    ends = _apart([each.gain for each in crossings] + ([drop] if drop is not None else []))
    starts = [sp.Integer(0), *ends]
    intervals = tuple(
        GainInterval(a, b, _outside(denominator + _between(a, b) * numerator, s))
        for a, b in zip(starts, [*ends, sp.oo], strict=True)
    )
    stable = next((each for each in intervals if not each.outside), None)
    if stable is None:
        return UltimateGain(crossings, intervals, None, "never_stable")
    if stable.stop == sp.oo:
        return UltimateGain(crossings, intervals, None, "never_oscillates")
    there = [each for each in crossings if _same(each.gain, stable.stop)]
    if not there:
        return UltimateGain(crossings, intervals, None, "at_infinity")
    turning = [each for each in there if each.frequency != 0]
    return UltimateGain(crossings, intervals, *((turning[0], "") if turning else (None, "at_the_origin")))


def _positive_roots(equation: sp.Expr, w: sp.Symbol) -> list[sp.Expr]:
    """The positive roots of a polynomial in w, in decimals where they belong to a factor of degree ≥ 3."""
    p = sp.Poly(equation, w)
    if p.degree() < 1:
        return []
    listed = p.monic().all_coeffs()
    roots = dict.fromkeys(roots_of(listed))
    return [root for root in roots if not root.has(sp.I) and _size(root) > 0]


def _gain(axis: Axis, w: sp.Expr) -> sp.Expr | None:
    """K at a root w of the equation: −Dₑ/Nₑ, or −Dₒ/Nₒ where that has no value; None where it is not positive."""
    for without, factor in (axis.real, axis.imaginary):
        below = _at(factor, axis.w, w)
        if below != 0 and (not below.has(sp.Float) or abs(below) > sp.Float("1e-20")):
            K = _tidy(-_at(without, axis.w, w) / below)
            return K if _size(K) > 0 else None
    return None


def _ratio(denominator: sp.Expr, numerator: sp.Expr, s: sp.Symbol, power: int) -> sp.Expr | None:
    """K > 0 at which the coefficient of a power of s vanishes; None where there is none."""
    n, d = (sp.Poly(p, s).coeff_monomial(s**power) for p in (numerator, denominator))
    K = -d / n if n != 0 else sp.Integer(0)
    return K if _size(K) > 0 else None


def _at(p: sp.Expr, w: sp.Symbol, value: sp.Expr) -> sp.Expr:
    return _tidy(p.xreplace({w: value})) if p.has(w) else p


def _tidy(value: sp.Expr) -> sp.Expr:
    """A number as a person writes it, decimals to their digits."""
    if value.has(sp.Float):
        return sp.N(value, DIGITS)
    K, ((entry,),) = (matrix := domain_matrix(sp.Matrix([[value]]))).domain, matrix.to_list()
    return expression(K, entry)


def _root(w: sp.Expr) -> sp.Expr:
    """√w, exact where w is rational, else in decimals: roots are not nested."""
    return sp.sqrt(w) if w.is_Rational else sp.N(sp.sqrt(w), DIGITS)


def _size(value: Any) -> float:
    return float(sp.N(value, DIGITS))


def _same(a: sp.Expr, b: sp.Expr) -> bool:
    return bool(a == b or abs(sp.N(a - b, DIGITS)) <= NEAREST * abs(sp.N(b, DIGITS)))


def _apart(gains: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The gains by size, each once."""
    found: list[sp.Expr] = []
    for gain in sorted(gains, key=_size):
        if not found or not _same(gain, found[-1]):
            found.append(gain)
    return found


def _between(a: sp.Expr, b: sp.Expr) -> sp.Rational:
    """A rational number between two gains."""
    low, high = (sp.Rational(str(sp.N(x, DIGITS))) if x != sp.oo else None for x in (a, b))
    assert low is not None  # noqa: S101 - only the last interval has no end
    return (low + high) / 2 if high is not None else 2 * low + 1


def _outside(p: sp.Expr, s: sp.Symbol) -> int:
    """How many roots lie in the right half plane or on the axis."""
    counts = root_counts(sp.Poly(p, s).all_coeffs())
    assert counts is not None  # noqa: S101 - the coefficients are numbers
    return counts.outside + counts.on


def ultimate_with_dead_time(
    numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, delay: sp.Expr
) -> tuple[Oscillation | None, str]:
    """Return the least K > 0 at which the loop of K N/D e^{−delay s} begins to oscillate, in decimals, or why none.

    "unstable": with a small gain the loop is not stable, "never_oscillates": the phase never reaches −180°.
    """
    L = on_axis(numerator, denominator, s, delay)
    found = [each for each in phase_crossovers(L).found if each.omega != 0]
    if not found:
        return None, "never_oscillates"
    first = max(found, key=lambda each: _size(each.magnitude))
    K = sp.N(1 / first.magnitude, DIGITS)
    below, above = (sp.Rational(str(sp.N(K * factor, 15))) for factor in (BELOW, 1 / BELOW))
    if not _is_stable(below * numerator, denominator, s, delay) or _is_stable(above * numerator, denominator, s, delay):
        return None, "unstable"
    omega = sp.N(first.omega, DIGITS)
    return Oscillation(K, omega, sp.N(omega**2, DIGITS)), ""


def _is_stable(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, delay: sp.Expr) -> bool:
    turns = encirclements(sp.expand(numerator), denominator, s, delay)
    return turns.closed_loop == 0 and not turns.through
