"""Motions by their modes in decimals: what lasts for ever, and the peaks before, searched between samples.

A motion is a sum of pieces, each c t^{j−1}/(j−1)! e^{λt} in the time since its beginning. The samples are dense enough
for every mode as long as it lasts; a zero of the slope between two of them is refined.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from itertools import pairwise
from math import factorial, lcm, pi
from typing import Any, NamedTuple

import mpmath

from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.peaks import value_of_modes

PER_MODE = 400
PER_TURN = 24
"""Samples of the decay of a mode, and of a turn of an oscillation."""
LATEST = 40
"""In time constants of a mode: later than that nothing is left of it."""
MOST = 100_000
"""More samples are not taken."""
NOTHING = 1e-24
"""Real parts and coefficients below that, relatively, are zero: the decimals have some more digits."""
RATIO = 60
"""Frequencies whose ratio has no larger numerator and denominator make a period that is searched."""

Mode = tuple[Any, int, Any]
"""λ, j and the coefficient of t^{j−1}/(j−1)! e^{λt}."""


class Unbounded(ValueError):  # noqa: N818 - a finding
    """A variable grows without bound."""


class Unsearched(ValueError):  # noqa: N818 - a finding
    """Too many samples would be needed, or several frequencies have no period in common."""


@dataclass(frozen=True)
class Motion:
    """Pieces: when each begins, in order, and its modes."""

    pieces: Sequence[tuple[Any, Sequence[Mode]]]

    def value(self, t: Any, order: int = 0, *, before: bool = False, precise: bool = False) -> Any:
        """The value (or the slope: order 1) at a time; `before` what begins then."""
        begun = [i for i, (d, _) in enumerate(self.pieces) if d < t or (d == t and not before)]
        if precise:
            modes = ((self.pieces[i][1], t - self.pieces[i][0]) for i in begun)
            return sum((value_of_modes(m, since, order, mpmath.exp) for m, since in modes), mpmath.mpf(0))
        rough = ((self._rough[i], float(t - self.pieces[i][0])) for i in begun)
        return float(sum(value_of_modes(m, since, order, cmath.exp) for m, since in rough))

    @cached_property
    def _rough(self) -> list[list[Mode]]:
        """The modes of each piece in doubles: they are sampled thousands of times."""
        return [[(complex(r), j, complex(c)) for r, j, c in modes] for _, modes in self.pieces]


class Sustained(NamedTuple):
    """What lasts: the constant, and c by ω of the terms 2 Re(c e^{jωt}); `size` is the least bound of its size."""

    level: Any
    swings: Mapping[Any, Any]
    size: Any


def sustained(motion: Motion) -> Sustained:
    """What is left of a motion in the end; raises Unbounded, Unsearched."""
    total: dict[tuple[Any, int], Any] = {}
    scale = max((abs(c) for _, modes in motion.pieces for *_, c in modes), default=mpmath.mpf(0))
    with mpmath.workdps(DIGITS + 15):
        for delay, modes in motion.pieces:
            for root, j, c in modes:
                if root.real < -NOTHING * max(1, abs(root)) or abs(c) <= NOTHING * scale:
                    continue
                for i in range(1, j + 1):  # (t − T)^{j−1} by powers of t
                    part = c * mpmath.exp(-root * delay) * (-delay) ** (j - i) / factorial(j - i)
                    key = next((k for k in total if k[1] == i and abs(k[0] - root) < 1e-20), (root, i))
                    total[key] = total.get(key, mpmath.mpc(0)) + part
        left = {key: c for key, c in total.items() if abs(c) > NOTHING * scale}
        if any(root.real > NOTHING * max(1, abs(root)) or j > 1 for root, j in left):
            raise Unbounded
        level = sum((c.real for (root, _), c in left.items() if abs(root) < NOTHING), mpmath.mpf(0))
        swings = {root.imag: c for (root, _), c in left.items() if root.imag > NOTHING}
        return Sustained(level, swings, _bound(level, swings))


def _bound(level: Any, swings: Mapping[Any, Any]) -> Any:
    """|c| and the amplitude; of several frequencies the largest size in their period. Raises Unsearched without one."""
    amplitudes: Any = abs(level) + sum((2 * abs(c) for c in swings.values()), mpmath.mpf(0))
    if len(swings) < 2:
        return amplitudes
    first = next(iter(swings))
    ratios = [_ratio(omega / first) for omega in swings]
    if not all(ratios):
        raise Unsearched
    modes: list[Mode] = [(mpmath.mpc(0, omega), 1, 2 * c) for omega, c in swings.items()]
    alone = Motion([(mpmath.mpf(0), [*modes, (mpmath.mpc(0), 1, mpmath.mpc(level))])])
    period = 2 * pi * lcm(*(each.denominator for each in ratios if each)) / float(first)
    count = PER_TURN * RATIO * len(swings)
    return max(
        (each.size for each in _zeros(alone, [period * i / count for i in range(count + 1)])), default=amplitudes
    )


def _ratio(value: Any) -> Fraction | None:
    """The quotient of small numbers that a value is."""
    near = Fraction(float(value)).limit_denominator(RATIO)
    return (
        near if near.numerator <= RATIO and abs(value - mpmath.mpf(near.numerator) / near.denominator) < 1e-20 else None
    )


class Extreme(NamedTuple):
    """A size that is reached at a time; at a `corner` an input switches."""

    time: Any
    size: Any
    corner: bool = False


def searched(motion: Motion, last: Sustained) -> Iterator[Extreme]:
    """The largest zero of the slope, and the corners; raises Unsearched."""
    starts = [delay for delay, _ in motion.pieces]
    for start in starts:
        sides = [abs(motion.value(start, precise=True))]
        sides += [abs(motion.value(start, before=True, precise=True))] if start else []
        yield Extreme(start, max(sides), corner=True)
    times = _times(motion, last)
    found = max(_zeros(motion, times), key=lambda each: each.size, default=None)
    if found is not None:
        yield found


def _zeros(motion: Motion, times: Sequence[float]) -> Iterator[Extreme]:
    """The largest sizes among the zeros of the slope, refined; roughly all of them, the best exactly."""
    slopes = [(t, slope) for t in times if (slope := motion.value(t, 1))]
    switched = [float(delay) for delay, _ in motion.pieces]
    rough = [
        _halved(motion, a, b)
        for (a, before), (b, after) in pairwise(slopes)
        if before * after < 0 and not any(a < each <= b for each in switched)
    ]
    if not rough:
        return
    a, b = max(rough, key=lambda ends: abs(motion.value(ends[0])))
    with mpmath.workdps(DIGITS + 15):
        slope = partial(motion.value, order=1, precise=True)
        near = mpmath.mpf(10) ** -8 * max(1, b)
        time = mpmath.findroot(slope, (mpmath.mpf(a), mpmath.mpf(b) + near), tol=1e-60, maxsteps=60, verify=False)
        if not abs(time - a) <= 1000 * near:
            time = mpmath.mpf(a)
        yield Extreme(time, abs(motion.value(time, precise=True)))


def _halved(motion: Motion, a: float, b: float) -> tuple[float, float]:
    """An interval of a zero of the slope, halved until its size does not matter."""
    left = motion.value(a, 1)
    for _ in range(40):
        middle = (a + b) / 2
        slope = motion.value(middle, 1)
        if slope * left > 0:
            a, left = middle, slope
        else:
            b = middle
    return a, b


def _times(motion: Motion, last: Sustained) -> list[float]:
    """Samples for each mode from each beginning on, as long as it lasts."""
    roots = [complex(root) for _, modes in motion.pieces for root, _, c in modes if c]
    decays = [-root.real for root in roots if root.real < -NOTHING]
    turn = max((2 * pi / float(omega) for omega in last.swings), default=0.0)
    longest = LATEST / min(decays, default=float("inf")) + turn
    times: set[float] = set()
    for delay, _ in motion.pieces:
        for root in dict.fromkeys(roots):
            span = min(LATEST / -root.real if root.real < -NOTHING else longest, longest)
            times.update(float(delay) + span * (i / PER_MODE) ** 2 for i in range(PER_MODE + 1))
            count = int(span * abs(root.imag) / (2 * pi) * PER_TURN) + 1 if root.imag > NOTHING else 0
            if count > MOST:
                raise Unsearched
            times.update(float(delay) + span * i / count for i in range(count))
    return sorted(times)
