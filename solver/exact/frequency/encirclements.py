"""How often L(jω) goes round −1 while s runs up the imaginary axis, round its poles on the right, and back at infinity.

Each passage of the real axis to the left of −1 counts, from below to above as one turn clockwise. With P poles of L in
the right half plane the loop has Z = P + N there. Of a discrete loop z runs round the unit circle, outside of poles on
it, and P and Z are those outside. Source: H. Nyquist, Bell System Technical Journal 11 (1932), 126–147.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis, on_axis
from solver.exact.frequency.circle import on_circle
from solver.exact.frequency.crossings import Crossover
from solver.exact.frequency.real_axis import phase_crossovers
from solver.exact.frequency.surds import WORKING, decimal
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.stability.root_counts import root_counts

TOO_CLOSE = mpmath.mpf(10) ** (10 - DIGITS)
"""Decimals that differ from one by less do not tell on which side of −1 the curve passes."""


@dataclass(frozen=True)
class Arc:
    """What becomes of the half circle round a pole jω of L: half turns clockwise at infinity.

    They pass the negative real axis `passes` times, those of both poles ±jω together. At an `end` there is one pole.
    """

    omega: sp.Expr
    half_turns: int
    passes: int
    end: bool = False


@dataclass(frozen=True)
class Encirclements:
    """The turns N about −1, `clockwise`, with the P poles of L and the Z of the loop that are not in the stable region.

    `beyond` are the crossings of the real axis left of −1 at ω ≥ 0, `arcs` those of the poles on the axis, `closing`
    what the way through ω = ∞ adds. `on_axis` counts the poles of the loop on the axis, with a dead time those that
    cancel in L; `through` says that L is −1 somewhere.
    `real`: L is real on the whole axis, so that no crossing tells a turn.
    """

    clockwise: int
    open_loop: int
    closed_loop: int
    on_axis: int
    beyond: tuple[Crossover, ...]
    arcs: tuple[Arc, ...]
    closing: int
    through: bool
    real: bool

    @property
    def stable(self) -> bool:
        """Whether no pole of the loop is in the right half plane or on the axis."""
        return not self.closed_loop and not self.through and not self.on_axis


@lru_cache(maxsize=64)
def encirclements(
    numerator: sp.Expr,
    denominator: sp.Expr,
    s: sp.Symbol,
    delay: sp.Expr = sp.S.Zero,
    *,
    sample_time: sp.Expr | None = None,
) -> Encirclements:
    """Count for L = N/D e^{−Ts}, nothing cancelled in N and D; raises NotExact where decimals do not decide.

    With a sampling period for L = N/D in z.
    """
    discrete = sample_time is not None
    L = on_axis(numerator, denominator, s, delay)
    if sample_time is not None:
        L = on_circle(numerator, denominator, s, sample_time)
    P = _counted(denominator, s, discrete=discrete)
    phases = phase_crossovers(L)
    beyond = tuple(each for each in phases.found if _exceeds_one(each.magnitude)) if not phases.everywhere else ()
    arcs = tuple(_arcs(L, [omega for omega, _ in phases.real_axis])) if not phases.everywhere else ()
    closing = _closing(L)
    turns = sum(each.clockwise * (1 if each.end else 2) for each in beyond)
    turns += sum(each.passes for each in arcs) + closing
    if L.late:
        through = any(each.magnitude == 1 for each in phases.found)
        hidden = _counted(sp.gcd(sp.Poly(numerator, s), sp.Poly(denominator, s)).as_expr(), s)
        on = hidden.on  # what cancels in L stays a pole of the loop
        return Encirclements(turns, P.outside, P.outside + turns, on, beyond, arcs, closing, through, real=False)
    Z = _counted(numerator + denominator, s, discrete=discrete)
    through = _counted((L.N + L.D).as_expr(), s, discrete=discrete).on > 0
    if not phases.everywhere and not through and turns != Z.outside - P.outside:
        raise NotExact("frequency/count_not_confirmed")
    if phases.everywhere:
        turns = Z.outside - P.outside
    return Encirclements(turns, P.outside, Z.outside, Z.on, beyond, arcs, closing, through, real=phases.everywhere)


def _counted(p: sp.Expr, s: sp.Symbol, *, discrete: bool = False) -> Any:
    found = root_counts(sp.Poly(p, s).all_coeffs(), discrete=discrete)
    if found is None:
        raise NotExact("frequency/parameters", names=sorted(p.free_symbols - {s}, key=str))
    return found


def _exceeds_one(magnitude: sp.Expr) -> bool:
    """Whether a crossing lies left of −1."""
    with mpmath.workdps(WORKING):
        away = decimal(magnitude) - 1
        if magnitude.has(sp.Float) and abs(away) < TOO_CLOSE:
            raise NotExact("frequency/too_close_to_minus_one")
        return bool(away > 0)


def _arcs(L: OnAxis, crossings: Iterable[sp.Expr]) -> Iterator[Arc]:
    """The poles on the axis, that at the origin first; between an arc and the next frequency here L is not real."""
    with mpmath.workdps(WORKING):
        poles = [(root.omega, root.multiplicity // 2) for root in L.places(L.parts.below)]
        marks = sorted([*map(decimal, crossings), *(decimal(omega) for omega, _ in poles)])
        c, power = L.start
        if power < 0:
            small = (marks[0] if marks else mpmath.mpf(1)) / 2
            small = min([small, *(L.distance(r) / 8 for r, _ in L.roots)])
            limit = mpmath.mpf(90) * power - (180 if decimal(c) < 0 else 0)
            after = L.turned(small)
            yield Arc(sp.S.Zero, -power, half_turn_passes(2 * limit - 180 * power - after, after), end=True)
        for omega, m in poles:
            value = decimal(omega)
            below = max([mpmath.mpf(0), *(each for each in marks if each < value * (1 - TOO_CLOSE))])
            above = min([2 * value, *(each for each in marks if each > value * (1 + TOO_CLOSE))])
            before, after = L.turned((below + value) / 2), L.turned((above + value) / 2)
            yield Arc(omega, m, 2 * half_turn_passes(before, after))
        yield from _last_arc(L, marks)


def _last_arc(L: OnAxis, marks: Iterable[Any]) -> Iterator[Arc]:
    """That of a pole at z = −1, which the path passes between the half for ω > 0 and its mirror image."""
    m = -sum(power for r, power in L.roots if L.end is not None and r == -1 and power < 0)
    if m and L.end is not None:
        last = decimal(L.end.omega)
        before = L.turned((max([mpmath.mpf(0), *marks]) + last) / 2)
        limit = L.turned(last)
        yield Arc(L.end.omega, m, half_turn_passes(before, 2 * limit - 180 * m - before), end=True)


def half_turn_passes(start: Any, stop: Any) -> int:
    """How often an angle that goes from one to another, in degrees, passes 180°: clockwise positive."""
    sign, low, high = (1, stop, start) if stop <= start else (-1, start, stop)
    first, last = mpmath.ceil((low - 180) / 360), mpmath.floor((high - 180) / 360)
    return sign * max(int(last - first) + 1, 0)


def _closing(L: OnAxis) -> int:
    """The crossing at ω = ∞, of a loop whose L(∞) is left of −1."""
    if L.excess or L.late or L.discrete:
        return 0
    value = L.N.LC() / L.D.LC()
    slope = L.parts.imaginary
    if decimal(value) >= -1 or slope.is_zero:
        return 0
    return -int(sp.sign(slope.LC()))


__all__ = ["Arc", "Encirclements", "encirclements", "half_turn_passes"]
