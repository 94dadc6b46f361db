"""Sums of c C(k, j−1) p^{k−j+1} over |p| < 1, k = 0, 1, …: their values, bounds, and from where on they keep a sign."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import ceil, comb
from typing import Any

import mpmath
import numpy as np

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS

MOST = 400_000
"""Samples looked through at most."""
SAME = 1e-20
"""Sizes and directions of poles nearer than that are equal."""
PERIODS = 24
"""Poles of one size whose directions come round after so many samples at most are told apart sample by sample."""
NOTHING = mpmath.mpf(10) ** (3 - DIGITS)

Array = np.ndarray[Any, np.dtype[Any]]
Mode = tuple[Any, int, Any]
"""p, j and c."""


@dataclass(frozen=True)
class PowerSum:
    """A real sequence, conjugate modes listed both."""

    modes: tuple[Mode, ...]

    def value(self, k: int) -> Any:
        """The value with many digits."""
        with mpmath.workdps(DIGITS + 15):
            return mpmath.fsum(_term(p, j, c, k).real for p, j, c in self.modes)

    def sign(self, k: int, level: Any) -> int:
        """The sign of the value less a level, zero where they cancel to all digits but a few."""
        with mpmath.workdps(DIGITS + 15):
            level = mpmath.mpf(int(level.p)) / int(level.q)
            value = self.value(k) - level
            size = mpmath.fsum(abs(_term(p, j, c, k)) for p, j, c in self.modes) + abs(level)
            return 0 if abs(value) <= NOTHING * size else int(mpmath.sign(value))

    def rough(self, count: int) -> Array:
        """The first values in double precision."""
        total = np.zeros(count)
        k = np.arange(count)
        for p, j, c in self.modes:
            total = total + np.real(complex(c) * _powers(complex(p), j, k))
        return total

    @cached_property
    def sizes(self) -> list[tuple[Any, int, Any]]:
        """|p|, j and |c|, equal sizes and powers together."""
        found: list[tuple[Any, int, Any]] = []
        with mpmath.workdps(DIGITS + 15):
            for p, j, c in self.modes:
                same = next((i for i, (size, n, _) in enumerate(found) if n == j and abs(size - abs(p)) < SAME), None)
                if same is None:
                    found.append((abs(p), j, abs(c)))
                else:
                    found[same] = (found[same][0], j, found[same][2] + abs(c))
        return found

    def bounds(self, k: Array) -> Array:
        """What the sizes of values do not exceed."""
        total = np.zeros(len(k))
        for size, j, c in self.sizes:
            total = total + float(c) * np.real(_powers(complex(float(size)), j, k))
        return total

    @property
    def falling(self) -> int:
        """From here on the bound falls: C(k, j−1) |p|^k does from k = (j−1)/(1 − |p|)."""
        return max((ceil((j - 1) / (1 - float(size))) + 1 if size else j for size, j, _ in self.sizes), default=0)

    def within(self, level: float) -> int:
        """A sample from which on the bound is less than a level, the first one where the bound falls."""
        low = self.falling
        if self._below(low, level):
            return low
        high = max(2 * low, 8)
        while not self._below(high, level):
            low, high = high, 2 * high
            if high > 2 * MOST:
                raise NotExact("step_specifications/slow")
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if self._below(middle, level) else (middle, high)
        return high

    def _below(self, k: int, level: float) -> bool:
        return bool(self.bounds(np.array([k]))[0] * (1 + 1e-9) < level) or not self.modes

    def negative_from(self) -> int | None:
        """A sample from which on all values are negative or zero alike; None where positive ones come again and again.

        Raises NotExact where the slowest modes cancel so that this is not seen.
        """
        with mpmath.workdps(DIGITS + 15):
            lead = self._leading()
        if lead is None:
            return self.falling
        greatest, start = lead
        return start if greatest <= 0 else None

    def _leading(self) -> tuple[float, int] | None:
        """The greatest value of the slowest modes, and from where on these decide; None without modes."""
        moving = [(p, j, c) for p, j, c in self.modes if p]
        if not moving:
            return None
        rho = max(abs(p) for p, _, _ in moving)
        order = max(j for p, j, _ in moving if abs(abs(p) - rho) < SAME)
        slow = [(p / rho, c) for p, j, c in moving if j == order and abs(abs(p) - rho) < SAME]
        greatest = _greatest(slow, order)
        rest = [(p, j, c) for p, j, c in moving if not (j == order and abs(abs(p) - rho) < SAME)]
        if not greatest:  # they cancel in some samples of each period: the other modes, if any, decide these
            if rest:
                raise NotExact("step_specifications/slow")
            return greatest, self.falling
        return greatest, self._decided(rest, float(rho), order, abs(greatest))

    def _decided(self, rest: list[Mode], rho: float, order: int, least: float) -> int:
        """From where on the other modes are less than half the leading ones."""
        start = self.falling + max((ceil((j + order) / (1 - abs(p) / rho)) for p, j, _ in rest if abs(p) < rho - SAME),
                                   default=0)  # fmt: skip
        while start < MOST:
            others = sum(
                float(abs(c)) * comb(start, j - 1) * float(abs(p) / rho) ** start * float(abs(p)) ** (1 - j)
                for p, j, c in rest
            )
            if others < least * comb(start, order - 1) * rho ** (1 - order) / 2:
                return start
            start = 2 * start + 1
        raise NotExact("step_specifications/slow")


def _term(p: Any, j: int, c: Any, k: int) -> Any:
    return c * comb(k, j - 1) * p ** (k - j + 1) if k >= j - 1 else mpmath.mpf(0)


def _powers(p: complex, j: int, k: Array) -> Array:
    """C(k, j−1) p^{k−j+1}."""
    exponent = np.maximum(k - j + 1, 0)
    found = np.where(k >= j - 1, p**exponent, 0.0)
    for i in range(j - 1):
        found = found * (k - i) / (i + 1)
    return found


def _greatest(slow: list[tuple[Any, Any]], order: int) -> float:
    """The greatest value of Re Σ c u^k for k = 0, 1, …, |u| = 1: over a period, or where there is none the supremum.

    Zero where they cancel in the samples of a period in which it is greatest.
    """
    size = float(sum(abs(c) for _, c in slow))
    for period in range(1, PERIODS + 1):
        if all(abs(u**period - 1) < SAME for u, _ in slow):
            values = [float(mpmath.fsum((c * u ** (r - order + 1)).real for u, c in slow)) for r in range(period)]
            greatest = max(values)
            return greatest if abs(greatest) >= 1e-12 * size else 0.0
    turning = [abs(c) for u, c in slow if abs(u.imag) > SAME]
    steady = sum(c.real for u, c in slow if abs(u - 1) < SAME)
    sides = sum(abs(c) for u, c in slow if abs(u + 1) < SAME)
    greatest = float(steady + sum(turning) + sides)
    if len(turning) > 2 and greatest > 0:
        raise NotExact("step_specifications/slow")
    if abs(greatest) < 1e-12 * size:
        raise NotExact("step_specifications/slow")
    return greatest
