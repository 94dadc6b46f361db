"""Discrete loops judged at e^{jωT}: crossovers by z = (1 + jx)/(1 − jx), which makes them polynomials in x = tan(ωT/2).

That is another way than that of the derivation, which goes by cos ωT.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np

from solver.numeric.judges.frequency.loops import NEAR, WORKING, NumericLoop, number_of, plus, times

EVEN = 6000
"""Samples of the circle."""


@dataclass(frozen=True)
class SampledLoop(NumericLoop):
    """L = N/D in z, with the sampling period."""

    period: Any

    def point(self, omega: Any) -> Any:
        """e^{jωT}."""
        return mpmath.expj(omega * self.period)

    def place(self, omega: Any) -> Any:
        """Cos ωT."""
        return mpmath.cos(omega * self.period)

    def unit(self, omega: Any) -> Any:
        """Sin ωT."""
        return mpmath.sin(omega * self.period)

    def values(self, omega: Any) -> Any:
        """L at many frequencies, in doubles."""
        z = np.exp(1j * np.asarray(omega, dtype=float) * float(self.period))
        above, below = (np.polyval([float(c) for c in p], z) for p in (self.N, self.D))
        with np.errstate(divide="ignore", invalid="ignore"):
            return above / below

    @cached_property
    def turned(self) -> tuple[Any, Any]:
        """(1 − jx)ⁿ N and (1 − jx)ⁿ D as polynomials in x, highest power first; n is the larger degree."""
        n = max(len(self.N), len(self.D)) - 1
        return _image(self.N, n), _image(self.D, n)

    def frequency(self, x: Any) -> Any:
        """ω = 2 arctan(x)/T."""
        return 2 * mpmath.atan(x) / self.period

    @property
    def last(self) -> Any:
        """The Nyquist frequency."""
        return mpmath.pi / self.period

    def gain_crossovers(self, level: Any = 1) -> list[Any]:
        """All 0 < ω ≤ π/T with |L| = level, rising."""
        found = super().gain_crossovers(level)
        end = abs(abs(self.at_end) - level) < NEAR * level
        return [*found, self.last] if end else found

    def real_crossings(self) -> list[tuple[Any, Any]]:
        """All 0 < ω ≤ π/T with L real and not zero, and L there."""
        found = super().real_crossings()
        return [*found, (self.last, self.at_end)] if NEAR < abs(self.at_end) < mpmath.inf else found

    @property
    def at_rest(self) -> Any:
        """L(1); infinite at a pole."""
        return self._real(1)

    @property
    def at_end(self) -> Any:
        """L(−1); infinite at a pole."""
        return self._real(-1)

    def _real(self, z: int) -> Any:
        with mpmath.workdps(WORKING):
            above, below = (mpmath.polyval(list(p), z) for p in (self.N, self.D))
            zero = abs(below) < NEAR**2 * sum(map(abs, self.D))
            return mpmath.inf if zero else above / below

    def is_place(self, root: complex) -> bool:
        """Whether a rough root in cos ωT is that of a frequency between the ends."""
        return abs(root.imag) < ROUGH * (1 + abs(root)) and -1 + 1e-12 < root.real < 1 - 1e-12

    @cached_property
    def sampled(self) -> tuple[Any, Any]:
        """Frequencies from 0 to π/T, close about the angles of the roots, and magnitudes."""
        T = float(self.period)
        roots = [z for p in (self.N, self.D) for z in np.roots([float(c) for c in p]) if abs(z)]
        close = [abs(np.angle(z)) + d * max(abs(abs(z) - 1), 1e-4) for z in roots for d in np.linspace(-6, 6, 241)]
        low = np.geomspace(1e-6, 1e-2, 200)
        theta = np.unique([*np.linspace(0, np.pi, EVEN)[1:], *low, *(t for t in close if 0 < t < np.pi)])
        return theta / T, np.abs(self.values(theta / T))


ROUGH = 1e-6


def sampled_loop(N: tuple[Any, ...], D: tuple[Any, ...], sample_time: Any) -> SampledLoop:
    """Return a loop of numbers, N and D without common roots."""
    return SampledLoop(N, D, mpmath.mpf(0), number_of(sample_time))


def _image(p: tuple[Any, ...], n: int) -> list[Any]:
    """(1 − jx)ⁿ p((1 + jx)/(1 − jx))."""
    j = mpmath.mpc(0, 1)
    up, down, total = [j, mpmath.mpc(1)], [-j, mpmath.mpc(1)], [mpmath.mpc(0)]
    for i, c in enumerate(p):
        k = len(p) - 1 - i
        term = [mpmath.mpc(c)]
        for factor in (*[up] * k, *[down] * (n - k)):
            term = times(term, factor)
        total = plus(total, term)
    return total


__all__ = ["SampledLoop", "sampled_loop"]
