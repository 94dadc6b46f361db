"""For which gains K a loop K L₁ with a dead time is stable: its curve is that of L₁, and the point is −1/K.

Each crossing of the real axis by L₁ passes −1/K at one K; further ones, beyond the last that is listed, are all
clockwise and at greater gains.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.frequency.axis import on_axis
from solver.exact.frequency.encirclements import encirclements
from solver.exact.frequency.real_axis import phase_crossovers
from solver.exact.frequency.surds import decimal, reciprocal
from solver.exact.linear_algebra.fields import NotExact


@dataclass(frozen=True)
class CriticalGain:
    """At the gain K = `gain` the curve passes −1, at the frequency `omega`, where L₁ is `value`.

    Beyond it, as |K| grows, `poles` more poles of the loop are in the right half plane.
    """

    gain: sp.Expr
    omega: sp.Expr
    value: sp.Expr
    poles: int


@dataclass(frozen=True)
class LateGains:
    """Gains at which poles pass the axis, rising in size, of K > 0 or of K < 0 as K is known to be.

    `small` poles are in the right half plane for K beside 0. The loop is stable where `condition` holds.
    """

    gain: sp.Symbol
    critical: tuple[CriticalGain, ...]
    small: int
    condition: Any


def late_gains(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, delay: sp.Expr) -> LateGains:
    """Return where K L₁ = N/D e^{−Ts} is stable; raises NotExact unless its only letter is a factor K of known sign."""
    letters: list[Any] = sorted((numerator.free_symbols | denominator.free_symbols | delay.free_symbols) - {s}, key=str)
    gain: Any = letters[0]
    N = sp.cancel(numerator / gain)
    if len(letters) > 1 or (N.free_symbols | denominator.free_symbols) - {s} or delay.free_symbols:
        raise NotExact("frequency/parameters", names=letters)
    if not (gain.is_positive or gain.is_negative):
        raise NotExact("frequency/sign_not_known", what=gain)
    sign = 1 if gain.is_positive else -1
    L = on_axis(sign * N, denominator, s, delay)
    crossings = phase_crossovers(L).found
    found = encirclements(sp.expand(sign * N), denominator, s, delay)
    if found.on_axis:
        return LateGains(gain, (), found.open_loop, sp.false)
    small = found.open_loop + sum(each.passes for each in found.arcs) + found.closing
    rising = sorted(crossings, key=lambda each: -decimal(each.magnitude))
    listed = rising.index(crossings[-1]) + 1 if crossings else 0
    critical = tuple(
        CriticalGain(sign * reciprocal(each.magnitude), each.omega, -sign * each.magnitude,
                     each.clockwise * (1 if each.end else 2))
        for each in rising[:listed]
    )  # fmt: skip
    if not critical or critical[-1].poles <= 0 or any(each.clockwise < 0 for each in rising[listed:]):
        raise NotExact("frequency/parameters", names=letters)
    return LateGains(gain, critical, small, sp.Or(*_stable(gain, critical, small)))


def _stable(gain: sp.Symbol, critical: tuple[CriticalGain, ...], small: int) -> Iterator[Any]:
    """The intervals of K without poles in the right half plane; none reaches beyond the last gain."""
    poles, last = small, None
    for each in critical:
        if not poles:
            low, high = (last, each.gain) if gain.is_positive else (each.gain, last)
            yield sp.And(*([gain > low] if low is not None else []), *([gain < high] if high is not None else []))
        poles, last = poles + each.poles, each.gain


__all__ = ["CriticalGain", "LateGains", "late_gains"]
