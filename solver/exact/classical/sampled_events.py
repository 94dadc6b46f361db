"""What a step response of a discrete system shows: rise, peak, overshoot, settling, all at samples.

The deviation from the final value is a sum of c C(k, j−1) p^{k−j+1}, whose sizes added up bound what is still to come:
so no sample is overlooked. Samples are compared exactly where they are rational, else with 40 digits.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.exact.classical.power_sums import MOST, PowerSum
from solver.exact.classical.step_events import Extreme, Rise
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.peaks import modes_of
from solver.exact.time_response.response import ClosedForm

RECURSION = 400
"""So many samples are found in fractions."""
LONGEST = 20
"""Digits of a denominator that are still written out."""
TIED = 64
"""So many samples that are nearly the largest are compared."""
AMBIGUOUS = 1e-9
"""Samples nearer to a level than that, relatively, are compared exactly."""


@dataclass(frozen=True)
class SampledEvents:
    """Times are numbers of samples. `peak` is the largest sample above the final value, `reached` whether that is.

    `settling` is the first sample of those that stay in the band, `outside` the last one that is not (None: there is
    none); `under` the lowest sample below zero before the rise. From the sample `within` on the `bound` is less than
    the band: c, the size of p and j of its terms c C(k, j−1) |p|^{k−j+1}, relative to the final value.
    """

    final: sp.Expr
    peak: Extreme | None
    reached: bool
    rise: Rise
    settling: sp.Integer
    outside: Extreme | None
    under: Extreme | None
    within: sp.Integer
    bound: tuple[tuple[sp.Expr, sp.Expr, int], ...]
    samples: tuple[sp.Expr, ...]


def sampled_events(found: ClosedForm, band: sp.Expr, *, whole: bool, shown: int = 12) -> SampledEvents:
    """The events of a response to a unit step, which tends to a limit that is not zero; `samples` up to some shown.

    Raises NotExact where it settles too slowly for its samples to be looked through.
    """
    seen = _Seen(found)
    within = seen.away.within(float(band))
    last = _last_outside(seen, within, band)
    first = _first_above(seen, within)
    peak = _largest(seen)
    levels = (sp.Integer(0), sp.Integer(1)) if whole and first is not None else (sp.Rational(1, 10), sp.Rational(9, 10))
    begins = 0 if levels[0] == 0 else seen.first_at(levels[0], within)
    ends = first if levels[1] == 1 and first is not None else seen.first_at(levels[1], within)
    settling = 0 if last is None else last + 1
    low = int(np.argmin(seen.away.rough(ends + 1)))
    under = seen.extreme(low) if seen.compare(low, sp.Integer(0)) < 0 else None
    count = min(max(shown, 1), max(settling, ends, 0 if peak is None else int(peak.time)) + 3)
    bound = tuple((sp.Float(c, DIGITS), sp.Float(size, DIGITS), j) for size, j, c in seen.away.sizes)
    return SampledEvents(
        seen.final,
        peak,
        first is not None,
        Rise(*levels, sp.Integer(begins), sp.Integer(ends)),
        sp.Integer(settling),
        None if last is None else seen.extreme(last),
        under,
        sp.Integer(within),
        bound,
        tuple(sp.expand(seen.share(k) * seen.final) for k in range(count)),
    )


@dataclass(frozen=True)
class _Seen:
    """The samples of a response as shares of its final value."""

    found: ClosedForm

    @property
    def final(self) -> sp.Expr:
        """The final value."""
        return self.found.y_final[0]  # type: ignore[index]  # it has a limit

    @cached_property
    def away(self) -> PowerSum:
        """The deviation from the final value, over it."""
        image = self.found.pieces[0][1].y
        with mpmath.workdps(DIGITS + 15):
            size = mpmath.mpmathify(sp.N(self.final, DIGITS + 15))
            modes = [(p, j, c / size) for p, j, c in modes_of(image) if p != 1]  # type: ignore[arg-type]
            return PowerSum(tuple(mode for mode in modes if mode[2]))

    @cached_property
    def exact(self) -> list[sp.Expr]:
        """The first samples as fractions, by the recursion of the states; none where the system is not rational."""
        system: Any = self.found.system
        D = system.D if system.D is not None else sp.zeros(1, 1)
        if not all(entry.is_Rational for M in (system.A, system.B, system.C, D) for entry in M):
            return []
        A, B, C = ([[sp.QQ.from_sympy(entry) for entry in row] for row in M.tolist()] for M in (
            system.A, system.B, system.C))  # fmt: skip
        x, listed = [sp.QQ.zero] * len(A), []
        through, final = sp.QQ.from_sympy(D[0]), sp.QQ.from_sympy(self.final)
        for _ in range(RECURSION):
            listed.append(sp.QQ.to_sympy((sum((c * v for c, v in zip(C[0], x, strict=True)), through)) / final))
            x = [sum((a * v for a, v in zip(row, x, strict=True)), b[0]) for row, b in zip(A, B, strict=True)]
        return listed

    def share(self, k: int) -> sp.Expr:
        """A sample over the final value: a fraction that is not too long, else a decimal."""
        if k < len(self.exact):
            value: Any = self.exact[k]
            return value if len(str(value.q)) <= LONGEST else sp.N(value, DIGITS)
        return sp.Float(1 + self.away.value(k), DIGITS)

    def compare(self, k: int, level: Any) -> int:
        """The sign of a sample less a level, both as shares."""
        if k < len(self.exact):
            return int(sp.sign(self.exact[k] - level))
        return self.away.sign(k, level - 1)

    def extreme(self, k: int) -> Extreme:
        """A sample as a time and a share."""
        return Extreme(sp.Integer(k), self.share(k))

    def doubles(self, count: int) -> tuple[Any, Any]:
        """The first deviations in double precision, and how near to a level they are to be compared exactly."""
        return self.away.rough(count), AMBIGUOUS * (1 + self.away.bounds(np.arange(count)))

    def stays_below(self, k: int) -> bool:
        """Whether no sample from k on is above the final value."""
        never = self.away.negative_from()
        return never is not None and k >= never

    def first_at(self, level: sp.Expr, within: int) -> int:
        """The first sample that is at a level below the final value, or beyond."""
        e, doubt = self.doubles(within + 1)
        near = np.nonzero(e >= float(level) - 1 - doubt)[0]
        return next((int(k) for k in near if self.compare(int(k), level) >= 0), within)


def _last_outside(seen: _Seen, within: int, band: sp.Expr) -> int | None:
    """The last sample outside the band."""
    e, doubt = seen.doubles(within)
    near = np.nonzero(abs(e) > float(band) - doubt)[0]
    outside = (int(k) for k in near[::-1] if seen.compare(int(k), 1 + band) > 0 or seen.compare(int(k), 1 - band) < 0)
    return next(outside, None)


def _first_above(seen: _Seen, within: int) -> int | None:
    """The first sample at the final value or beyond it; None where there is none, however late."""
    start, stop = 0, max(within, 16)
    while start < MOST:
        e = seen.away.rough(stop)
        size = seen.away.bounds(np.arange(start, stop))
        near = start + np.nonzero(e[start:] >= -AMBIGUOUS * size)[0]
        found = next((int(k) for k in near if seen.compare(int(k), sp.Integer(1)) >= 0), None)
        if found is not None or seen.stays_below(stop):
            return found
        start, stop = stop, 2 * stop
    raise NotExact("step_specifications/slow")


def _largest(seen: _Seen) -> Extreme | None:
    """The largest sample above the final value, the first one where several are equal."""
    start, stop = 0, 64
    while start < MOST:
        e = seen.away.rough(stop)
        best = float(e.max())
        doubt = AMBIGUOUS * (abs(best) + 1e-3 * seen.away.bounds(np.arange(stop)))
        first, *others = (int(k) for k in np.nonzero(e >= best - doubt)[0][:TIED])
        for k in others:
            if _greater(seen, k, first):
                first = k
        if seen.compare(first, sp.Integer(1)) > 0:
            if stop > seen.away.within(max(best * (1 - AMBIGUOUS), 1e-280)):
                return seen.extreme(first)
        elif seen.stays_below(stop):
            return None
        start, stop = stop, 2 * stop
    raise NotExact("step_specifications/slow")


def _greater(seen: _Seen, k: int, other: int) -> bool:
    """Whether one sample is greater than another, beyond doubt."""
    if max(k, other) < len(seen.exact):
        return bool(seen.exact[k] > seen.exact[other])
    a, b = seen.away.value(k), seen.away.value(other)
    return bool(a - b > mpmath.mpf(10) ** (5 - DIGITS) * (abs(a) + abs(b)))
