"""What a step response that settles shows: rise, peak, overshoot and the last entry into a band, in 30 digits.

Where the response has one real mode, or its peak a closed form, the numbers are exact.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import mpmath
import sympy as sp

from solver.exact.classical.exponential_sums import WORKING, ExponentialSum, Zero, first_zero, zeros
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.peaks import modes_of
from solver.exact.time_response.response import ClosedForm
from solver.exact.time_response.stationary import stationary


@dataclass(frozen=True)
class Rise:
    """When the response first reaches two levels, fractions of the final value."""

    low: sp.Expr
    high: sp.Expr
    begins: sp.Expr
    ends: sp.Expr

    @property
    def time(self) -> sp.Expr:
        """The rise time."""
        return self.ends - self.begins


@dataclass(frozen=True)
class Extreme:
    """A time and the value of y there, as a fraction of the final value."""

    time: sp.Expr
    share: sp.Expr


@dataclass(frozen=True)
class StepEvents:
    """`peak` is the largest value above the final one, `reached` whether that is reached at all.

    `settling` is the time of the last entry into the band, at the share `edge` of the final value (None: it is never
    outside); `under` the lowest value below zero before the rise.
    """

    final: sp.Expr
    peak: Extreme | None
    reached: bool
    rise: Rise
    settling: sp.Expr
    edge: sp.Expr | None
    under: Extreme | None


def step_events(found: ClosedForm, band: sp.Expr, *, whole: bool) -> StepEvents:
    """The events of a response to a unit step, which tends to a limit that is not zero.

    The rise is from 0 to 100 % where it is asked for as a `whole` and the final value is reached, else 10 to 90 %.
    """
    image, final = found.pieces[0][1].y, found.y_final[0]  # type: ignore[index]  # it has a limit
    with mpmath.workdps(WORKING):
        size = mpmath.mpmathify(sp.N(final, WORKING))
        share = ExponentialSum.of_modes([(m, j, c / size) for m, j, c in modes_of(image)])  # type: ignore[arg-type]
        start = share.value(mpmath.mpf(0))
        away = ExponentialSum(tuple(term for term in share.terms if term[0]))
        crossing = None if start >= 1 else first_zero(away)
        over = _largest(share, away, crossing, start)
    reached = bool(start >= 1 or crossing is not None)
    single = _only_mode(found)
    levels = (sp.Integer(0), sp.Integer(1)) if whole and reached else (sp.Rational(1, 10), sp.Rational(9, 10))
    times = [_first_time(share, level, start, single) for level in levels]
    settling, edge = _last_entry(share, band, single)
    rise = Rise(levels[0], levels[1], *times)
    under = _lowest(share, away, float(rise.ends))
    return StepEvents(final, _exact_peak(found, over, final), reached, rise, settling, edge, under)


def _first_time(share: ExponentialSum, level: Any, start: Any, single: Any) -> sp.Expr:
    """When the share first reaches a level."""
    if level == 0 or start >= _number(level):
        return sp.Integer(0)
    if level == 1:
        zero = first_zero(ExponentialSum(tuple(term for term in share.terms if term[0])))
    else:
        with mpmath.workdps(WORKING):
            zero = first_zero(share.less(_number(level)))
    assert zero is not None  # noqa: S101 - a level below the final value is reached, that itself was asked before
    return _by_logarithm(single, level) if single is not None else zero.time


def _number(value: Any) -> Any:
    with mpmath.workdps(WORKING):
        return mpmath.mpf(sp.Rational(value).p) / sp.Rational(value).q


def _only_mode(found: ClosedForm) -> tuple[sp.Expr, sp.Expr] | None:
    """Σ and c of y = y_f (1 + c e^{σt}); None for other responses."""
    image = found.pieces[0][1].y
    moving = [(each, order) for each, order in image.poles if each.factor.roots[0].value != 0]  # type: ignore[union-attr]
    if len(moving) != 1 or moving[0][1] != 1 or moving[0][0].factor.degree != 1:
        return None
    y, final = found.y[0], found.y_final[0]  # type: ignore[index]
    sigma = moving[0][0].factor.roots[0].value
    return sigma, sp.radsimp(sp.expand(y.subs(found.time, 0)) / final - 1)


def _by_logarithm(single: tuple[sp.Expr, sp.Expr], level: Any) -> sp.Expr:
    """When 1 + c e^{σt} is at a level."""
    sigma, c = single
    ratio = sp.radsimp(c / (level - 1))
    return sp.log(ratio) * sp.radsimp(-1 / sigma)


def _last_entry(share: ExponentialSum, band: sp.Expr, single: Any) -> tuple[sp.Expr, sp.Expr | None]:
    """The last time at which the share is at an edge of the band and was outside before."""
    last: tuple[Any, Any] | None = None
    for edge in (1 + band, 1 - band):
        with mpmath.workdps(WORKING):
            f = share.less(_number(edge))
        for zero in zeros(f, 0.0, f.below(float(band)), last=True):
            if not zero.touching:
                last = (zero.time, edge) if last is None or zero.time > last[0] else last
                break
    if last is None:
        return sp.Integer(0), None
    return (_by_logarithm(single, last[1]) if single is not None else last[0]), last[1]


def _largest(share: ExponentialSum, away: ExponentialSum, crossing: Zero | None, start: Any) -> Extreme | None:
    """The largest share above one; what comes after the deviation has decayed below what was found does not count."""
    best = Extreme(sp.Integer(0), sp.Float(start, DIGITS)) if start > 1 else None
    if not away.terms or (crossing is None and best is None) or (crossing is not None and crossing.touching):
        return best
    begin = float(crossing.time) if crossing is not None else 0.0
    seen = float(best.share) - 1 if best is not None else _first_height(away, begin)
    for zero in zeros(away.slope, 0.0 if not begin else begin * (1 - 1e-9), away.below(seen)):
        value = share.value(mpmath.mpmathify(zero.time))
        if value > 1 and (best is None or value > mpmath.mpmathify(best.share) * (1 + mpmath.mpf(10) ** (5 - DIGITS))):
            best = Extreme(zero.time, sp.Float(value, DIGITS))
    return best


def _first_height(away: ExponentialSum, begin: float) -> float:
    """How far the response is above its limit somewhere after it crosses it, a lower bound of the overshoot."""
    turning = next(zeros(away.slope, begin, begin + away.below(away.bound(begin, begin) * 1e-6)), None)
    places = [begin * (1 + i / 64) for i in range(1, 65)] + ([float(turning.time)] if turning is not None else [])
    return max(1e-290, max(away.at(t) for t in places) * (1 - 1e-9))


def _exact_peak(found: ClosedForm, over: Extreme | None, final: sp.Expr) -> Extreme | None:
    """The peak in closed form where the slope has one pair of modes, two real ones, or a repeated one."""
    if over is None:
        return over
    image, y = found.pieces[0][1].y, found.y[0]  # type: ignore[index]  # it has an output
    if not over.time:
        return Extreme(over.time, sp.radsimp(sp.expand(y.subs(found.time, 0) / final)))
    moving = [(each, order) for each, order in image.poles if each.factor.roots[0].value != 0]  # type: ignore[union-attr]
    if len(moving) > 2:
        return over
    flat = stationary(y, [(root, order) for each, order in moving for root in each.factor.roots], found.time)
    near = sp.Float("1e-15") * (1 + over.time)
    for time in flat.times if flat is not None else ():
        if not time.has(sp.Float) and abs(sp.N(time, DIGITS) - over.time) < near:
            value = sp.expand(y.subs(found.time, time) / final, power_exp=False, log=False)
            return Extreme(time, value)
    return over


def _lowest(share: ExponentialSum, away: ExponentialSum, ends: float) -> Extreme | None:
    """The lowest share below zero before the end of the rise."""
    low: Extreme | None = None
    with mpmath.workdps(WORKING):
        start = share.value(mpmath.mpf(0))
        if start < -(mpmath.mpf(10) ** -DIGITS):
            low = Extreme(sp.Integer(0), sp.Float(start, DIGITS))
        if not away.terms or not ends:
            return low
        for zero in zeros(away.slope, 0.0, ends):
            value = share.value(mpmath.mpmathify(zero.time))
            if value < -(mpmath.mpf(10) ** (5 - DIGITS)) and (low is None or value < mpmath.mpmathify(low.share)):
                low = Extreme(zero.time, sp.Float(value, DIGITS))
    return low
