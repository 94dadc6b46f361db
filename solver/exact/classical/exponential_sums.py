"""Sums of decaying exponentials c tᵏ e^{λt}, and their zeros for t > 0, each located beyond doubt.

An interval has no zero where the value at its middle exceeds what the slope can change, and one at most where the slope
has no zero by the same test; else it is halved. Zeros are refined to the digits of decimal roots.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import exp, factorial
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.spectrum import DIGITS

WORKING = DIGITS + 15
Term = tuple[Any, int, Any]
"""λ, k and c of c tᵏ e^{λt}; of a conjugate pair the upper one, with twice its coefficient."""
ROUNDING = 1e-12
"""What sums in double precision may be wrong by, of the size of their terms."""
SMALL = 1e-9
"""Intervals that are so small beside their place are decided with many digits."""
NOTHING = mpmath.mpf(10) ** -(DIGITS - 2)
NEWTON = 12
FARTHEST = 400.0
"""In units of the slowest time constant: later than that nothing is sought."""


@dataclass(frozen=True)
class Zero:
    """A zero: its time to 30 digits; `touching` where the sign does not change."""

    time: Any
    touching: bool = False


@dataclass(frozen=True)
class ExponentialSum:
    """A real function: the real part of the sum of its terms, whose λ have negative real parts or are zero."""

    terms: tuple[Term, ...]

    @staticmethod
    def of_modes(modes: Sequence[tuple[Any, int, Any]]) -> ExponentialSum:
        """From λ, j, c of c t^{j−1}/(j−1)! e^{λt}, conjugates listed both."""
        kept = [(m, j - 1, c * (2 if m.imag > 0 else 1) / factorial(j - 1)) for m, j, c in modes if m.imag >= 0]
        return ExponentialSum(tuple((mpmath.mpc(m), k, mpmath.mpc(c)) for m, k, c in kept if c))

    @cached_property
    def slope(self) -> ExponentialSum:
        """The derivative."""
        found: list[Term] = []
        for m, k, c in self.terms:
            found += [(m, k, c * m)] if m else []
            found += [(m, k - 1, c * k)] if k else []
        return ExponentialSum(tuple(found))

    def less(self, level: Any) -> ExponentialSum:
        """The function less a constant."""
        return ExponentialSum((*self.terms, (mpmath.mpc(0), 0, mpmath.mpc(-level)))) if level else self

    @cached_property
    def rough(self) -> tuple[tuple[complex, int, complex], ...]:
        """The terms in double precision."""
        return tuple((complex(m), k, complex(c)) for m, k, c in self.terms)

    def at(self, t: float) -> float:
        """The value in double precision."""
        return sum((c * t**k * cmath.exp(m * t)).real for m, k, c in self.rough)

    def bound(self, a: float, b: float) -> float:
        """What the size does not exceed for a ≤ t ≤ b."""
        return sum(abs(c) * b**k * exp(m.real * a) for m, k, c in self.rough)

    def value(self, t: Any) -> Any:
        """The value with many digits."""
        return mpmath.fsum((c * t**k * mpmath.exp(m * t)).real for m, k, c in self.terms)

    def size(self, t: Any) -> Any:
        """The sum of the sizes of the terms, with many digits."""
        return mpmath.fsum(abs(c) * t**k * mpmath.exp(m.real * t) for m, k, c in self.terms)

    def sign(self, t: Any) -> int:
        """The sign, zero where the terms cancel to all digits but a few."""
        rough, size = self.at(float(t)), self.bound(float(t), float(t))
        if abs(rough) > ROUNDING * size:
            return 1 if rough > 0 else -1
        with mpmath.workdps(WORKING):
            value = self.value(mpmath.mpf(t))
            return 0 if abs(value) <= NOTHING * self.size(mpmath.mpf(t)) else int(mpmath.sign(value))

    @property
    def slowest(self) -> float:
        """The time constant of the slowest term that decays."""
        return max((-1 / m.real for m, _, _ in self.rough if m.real), default=0.0)

    @property
    def constant(self) -> Any:
        """The limit."""
        return mpmath.fsum(c.real for m, _, c in self.terms if not m)

    def below(self, level: float) -> float:
        """A time after which what is not constant is smaller than a level (positive)."""
        moving = ExponentialSum(tuple(term for term in self.terms if term[0]))
        low = max((-k / m.real for m, k, _ in moving.rough), default=0.0)
        if moving.bound(low, low) < level:
            return low
        step = moving.slowest / 64
        while moving.bound(low + step, low + step) >= level:
            low, step = low + step, step * 1.5
        high = low + step
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (middle, high) if moving.bound(middle, middle) >= level else (low, middle)
        return high


def zeros(f: ExponentialSum, a: float, b: float, *, last: bool = False) -> Iterator[Zero]:
    """The zeros in a < t ≤ b, the first one first, or the last one first."""
    with mpmath.workdps(WORKING):
        a = max(a, _after_start(f, b)) if a == 0 else a
    waiting = [(a, b)] if a < b else []
    while waiting:
        low, high = waiting.pop()
        middle, half = (low + high) / 2, (high - low) / 2
        if abs(f.at(middle)) > f.slope.bound(low, high) * half + ROUNDING * f.bound(low, high):
            continue
        slope = f.slope
        monotone = abs(slope.at(middle)) > slope.slope.bound(low, high) * half + ROUNDING * slope.bound(low, high)
        if monotone:
            yield from _between(f, low, high)
        elif half < SMALL * high:
            found = list(_decided(f, low, high))
            yield from reversed(found) if last else found
        else:
            halves = [(low, middle), (middle, high)]
            waiting += halves if last else reversed(halves)


def _after_start(f: ExponentialSum, b: float) -> float:
    """A time up to which f has no zero but perhaps t = 0: its first derivative that is not zero there decides."""
    order, g = 0, f
    while order < len(f.terms) + 40 and abs(g.value(mpmath.mpf(0))) <= NOTHING * g.size(mpmath.mpf(0)):
        order, g = order + 1, g.slope
    if order == 0:
        return 0.0
    fastest = max(abs(m) for m, _, _ in f.rough)
    end = min(b, 1 / fastest) if fastest else b
    change = g.slope.bound(0, end)
    first = abs(float(g.value(mpmath.mpf(0))))
    return min(end, first * (order + 1) / (2 * change)) if change else end


def _between(f: ExponentialSum, low: Any, high: Any) -> Iterator[Zero]:
    """The zero of a function that is monotone; one at the lower end belongs to the interval before."""
    before, after = f.sign(low), f.sign(high)
    if after == 0:
        yield Zero(_number(mpmath.mpf(high)))
    elif before * after < 0:
        yield Zero(_refined(f, low, high))


def _decided(f: ExponentialSum, low: float, high: float) -> Iterator[Zero]:
    """The zeros in a very small interval with at most one turning point."""
    with mpmath.workdps(WORKING):
        try:
            turning = mpmath.findroot(f.slope.value, (low, high), solver="secant", verify=False)
        except (ZeroDivisionError, ValueError):
            turning = mpmath.mpf(low + high) / 2
        turning = turning.real
        if not low < turning < high:
            yield from _between(f, low, high)
            return
        if abs(f.value(turning)) <= NOTHING * f.size(turning):
            yield Zero(_number(turning), touching=True)
            return
    yield from _between(f, low, turning)
    yield from _between(f, turning, high)


def _refined(f: ExponentialSum, low: Any, high: Any) -> sp.Float:
    """The only zero between two places, by halving and then by Newton's method."""
    before, a, b = f.sign(low), float(low), float(high)
    for _ in range(60):
        middle = (a + b) / 2
        if not a < middle < b or abs(f.at(middle)) <= ROUNDING * f.bound(middle, middle):
            break
        a, b = (middle, b) if (f.at(middle) > 0) == (before > 0) else (a, middle)
    with mpmath.workdps(WORKING):
        t = mpmath.mpf((a + b) / 2)
        for _ in range(NEWTON):
            step = f.value(t) / f.slope.value(t)
            t -= step
            if not low <= t <= high:
                break
            if abs(step) <= t * mpmath.mpf(10) ** (3 - WORKING):
                return _number(t)
        halving = (mpmath.mpf(low), mpmath.mpf(high))
        return _number(mpmath.findroot(f.value, halving, solver="bisect", maxsteps=4 * WORKING, verify=False))


def _number(t: Any) -> sp.Float:
    with mpmath.workdps(WORKING):
        return sp.Float(t, DIGITS)


def settled_sign(f: ExponentialSum) -> float | None:
    """A time from which on f, which tends to zero, keeps its sign; None where it oscillates for ever."""
    slow = -1 / f.slowest
    near = [term for term in f.rough if abs(term[0].real - slow) < SMALL * abs(slow)]
    highest = max(k for _, k, _ in near)
    real = [c for m, k, c in near if k == highest and not m.imag]
    if not real:
        return None
    lead = abs(sum(real))
    others = [(m - slow, k - highest, c) for m, k, c in f.rough if not (not m.imag and k == highest and m.real == slow)]
    t = max([1.0 / abs(slow), *(k / -m.real for m, k, _ in others if m.real < 0 < k)])
    while sum(abs(c) * t**k * exp(min(0.0, m.real) * t) for m, k, c in others) >= lead * (1 - SMALL):
        t *= 1.5
        if t > FARTHEST / abs(slow):
            return None
    return t


def first_zero(f: ExponentialSum) -> Zero | None:
    """The first zero for t > 0; None where there is none."""
    if f.constant:
        return next(zeros(f, 0.0, f.below(abs(float(f.constant)))), None)
    if not f.terms:
        return None
    end = settled_sign(f)
    if end is not None:
        return next(zeros(f, 0.0, end), None)
    start, stop = 0.0, f.slowest
    while start < FARTHEST * f.slowest:
        found = next(zeros(f, start, stop), None)
        if found is not None:
            return found
        start, stop = stop, stop + 2 * f.slowest
    return None
