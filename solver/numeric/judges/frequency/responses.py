"""Frequency responses judged by values of C G/(1 + C G H) at jω."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.judges.frequency.crossings import decimal
from solver.numeric.judges.frequency.loops import WORKING
from solver.numeric.judges.frequency.roots import top_between
from solver.numeric.judges.frequency.waves import oscillations

POINTS = ("0.0173", "0.29", "0.83", "1.37", "2.9", "7.7", "31.3", "190.7")
"""Frequencies at which functions of ω are compared."""
SAMPLES = 4000
WRONG = float("inf")


def _quotient(factor: Any, s: Any) -> Callable[[Any], Any]:
    """A rational function of s, evaluated by the coefficients of its two polynomials."""
    above, below = ([decimal(c) for c in sp.Poly(part, s).all_coeffs()] for part in sp.fraction(sp.together(factor)))
    return lambda at: mpmath.polyval(above, at) / mpmath.polyval(below, at)


@dataclass(frozen=True)
class ClosedResponse:
    """T by its factors: formulas in s and the dead time of the plant; in z with a sampling period."""

    C: Any
    G: Any
    H: Any
    s: Any
    delay: Any
    period: Any = None

    @cached_property
    def _function(self) -> Callable[[Any], Any]:
        parts = [_quotient(each, self.s) for each in (self.C, self.G, self.H)]
        late = decimal(self.delay)
        period = None if self.period is None else decimal(self.period)

        def value(omega: Any) -> Any:
            at = mpmath.mpc(0, omega) if period is None else mpmath.expj(omega * period)
            C, G, H = (part(at) for part in parts)
            forward = C * G * (mpmath.exp(-at * late) if late else 1)
            return forward / (1 + forward * H)

        return value

    def value(self, omega: Any) -> Any:
        """T(jω), 40 digits."""
        with mpmath.workdps(WORKING):
            return self._function(omega)

    def magnitude_residual(self, found: Any, at: Any) -> float:
        """How far a number, or a function of omega, is from |T(jω)|."""
        return self._worst(found, at, lambda value, own: abs(own - abs(value)) / (1 + abs(value)))

    def phase_residual(self, found: Any, at: Any) -> float:
        """How far a number of degrees, or a function, is from the phase, up to full turns."""

        def away(value: Any, own: Any) -> Any:
            gap = own - mpmath.degrees(mpmath.arg(value))
            return abs(gap - 360 * mpmath.nint(gap / 360)) / 180

        return self._worst(found, at, away)

    def _worst(self, found: Any, at: Any, away: Callable[[Any, Any], Any]) -> float:
        worst = 0.0
        with mpmath.workdps(WORKING):
            for point in POINTS if at is None else (at,):
                omega = mpmath.mpf(point) if isinstance(point, str) else decimal(point)
                own = found.subs(sp.Symbol("omega"), sp.Float(str(omega), WORKING))
                if own.free_symbols or own.has(sp.zoo, sp.nan, sp.oo):
                    return WRONG
                worst = max(worst, float(away(self.value(omega), mpmath.re(mpmath.mpmathify(sp.N(own, WORKING))))))
        return worst

    def steady_residual(self, y: Any, u: Any) -> float:
        """How far y is from Σ c T(jω) e^{jωt} of the input Σ c e^{jωt}, ω of both signs or 0, at some moments.

        Of a discrete loop y is a function of k, t = kT, and told by its samples.
        """
        t, k = sp.symbols("t k")
        time, moments = t, ["0.11", "0.73", "1.9", "4.7"]
        if self.period is not None:
            u, y = (each.subs(t, k * self.period) for each in (u, y))
            time, moments = k, ["0", "1", "2", "5", "13"]
        if y.free_symbols - {time}:
            return WRONG
        with mpmath.workdps(WORKING):
            waves = oscillations(u, time)
            if waves is None:
                return WRONG
            period = 1 if self.period is None else decimal(self.period)
            passed = [(c * self.value_at(omega / period), omega) for c, omega in waves]
            size, worst = sum(abs(c) for c, _ in passed), 0.0
            for moment in moments:
                wanted = sum(mpmath.re(c * mpmath.expj(omega * mpmath.mpf(moment))) for c, omega in passed)
                own = decimal(y.subs(time, sp.Float(moment, WORKING)))
                worst = max(worst, float(abs(wanted - own) / size))
        return worst

    def value_at(self, omega: Any) -> Any:
        """T(jω); at ω = 0 the limit, where a factor of T has a pole there."""
        try:
            return self.value(omega)
        except ZeroDivisionError:
            return self.value(mpmath.mpf(10) ** -WORKING)

    def frequency_asked(self, u: Any, omega: Any) -> Any:
        """The frequency of a question in rad/s; None for a function."""
        if u is None or self.period is None:
            return frequencies_asked(u, omega)
        if u.has(sp.Symbol("t")):
            return frequencies_asked(u, None)
        asked = frequencies_asked(u, None, sp.Symbol("k"))
        return None if asked is None else asked / self.period

    @cached_property
    def _samples(self) -> tuple[Any, Any]:
        """Frequencies and magnitudes, in doubles."""
        whole = sp.fraction(sp.cancel(sp.together(self.C * self.G / (1 + self.C * self.G * self.H))))
        roots = [
            abs(z) for p in whole for z in np.roots([complex(c) for c in sp.Poly(p, self.s).all_coeffs()]) if abs(z)
        ]
        if self.period is not None:
            return self._on_circle(whole)
        scale = (min(roots), max(roots)) if roots else (1.0, 1.0)
        close = [abs(z) * (1 + d) for z in roots for d in np.linspace(-0.05, 0.05, 201)]
        omega = np.unique([*np.geomspace(scale[0] / 1e4, scale[1] * 1e4, SAMPLES), *close])
        return omega, self._magnitudes(omega)

    def _magnitudes(self, omega: Any) -> Any:
        """|T| in doubles; where they have no room for powers of jω, by mpmath."""
        at = 1j * omega
        with np.errstate(all="ignore"):
            C, G, H = (
                np.divide(*(np.polyval([float(decimal(c)) for c in sp.Poly(part, self.s).all_coeffs()], at) for part in
                            sp.fraction(sp.together(each))))
                for each in (self.C, self.G, self.H)
            )  # fmt: skip
            forward = C * G * np.exp(-at * float(decimal(self.delay)))
            sizes = np.abs(forward / (1 + forward * H))
        for i in np.flatnonzero(~np.isfinite(sizes)):
            sizes[i] = float(abs(self._function(mpmath.mpf(omega[i]))))
        return sizes

    def _on_circle(self, whole: Any) -> tuple[Any, Any]:
        """Frequencies from 0 to π/T, close about the angles of the roots, and magnitudes."""
        T = float(decimal(self.period))
        roots = [z for p in whole for z in np.roots([complex(c) for c in sp.Poly(p, self.s).all_coeffs()]) if abs(z)]
        close = [abs(np.angle(z)) + d * max(abs(abs(z) - 1), 1e-4) for z in roots for d in np.linspace(-6, 6, 121)]
        theta = [*np.linspace(0, np.pi, SAMPLES // 2)[1:-1], *np.geomspace(1e-6, 1e-2, 200), *close]
        omega = np.unique([each / T for each in theta if 0 < each < np.pi * (1 - 1e-12)])
        with mpmath.workdps(WORKING):
            at = [*(mpmath.mpf(w) for w in omega), mpmath.pi / decimal(self.period)]
            return np.array([float(w) for w in at]), np.array([float(abs(self._function(w))) for w in at])

    def peak(self) -> tuple[Any, Any, Any] | None:
        """The frequency of the largest magnitude, that, and the phase; None where it is largest at an end."""
        omega, sizes = self._samples
        i = int(np.argmax(sizes))
        if i == 0 or (i == len(omega) - 1 and self.period is None):
            return None
        if i == len(omega) - 1:
            with mpmath.workdps(WORKING):
                last = mpmath.pi / decimal(self.period)
                value = self.value(last)
                return last, abs(value), mpmath.degrees(mpmath.arg(value))
        with mpmath.workdps(WORKING):
            a = top_between(omega, i, self.value)
            value = self.value(a)
            return a, abs(value), mpmath.degrees(mpmath.arg(value))

    def bandwidth(self) -> Any:
        """The first frequency where the magnitude has fallen to 1/√2 of that at 0; None if it never does."""
        omega, sizes = self._samples
        with mpmath.workdps(WORKING):
            level = abs(self.value(mpmath.mpf(omega[0]) * mpmath.mpf(10) ** -14)) / mpmath.sqrt(
                2
            )  # G may have a pole at 0
            below = np.flatnonzero(sizes < float(level))
            if not len(below) or below[0] == 0:
                return None
            first, last = max(below[0] - 2, 0), min(below[0] + 1, len(omega) - 1)  # a sample may lie just there
            a, b = mpmath.mpf(omega[first]), mpmath.mpf(omega[last])
            for _ in range(120):
                middle = (a + b) / 2
                a, b = (middle, b) if abs(self.value(middle)) > level else (a, middle)
            return a


@lru_cache(maxsize=32)
def closed_response(C: Any, G: Any, H: Any, s: Any, delay: Any, period: Any = None) -> ClosedResponse:
    """Return T = C G e^{−Ts}/(1 + C G e^{−Ts} H); with a sampling period that of a discrete loop.

    Whoever marks asks for it with every answer.
    """
    return ClosedResponse(sp.S.Zero + C, sp.S.Zero + G, sp.S.Zero + H, s, sp.S.Zero + delay, period)


def frequencies_asked(u: Any, omega: Any, t: Any = None) -> Any:
    """The frequency of a question: that of its input, a function of t; None for a function."""
    if u is None:
        return omega
    t = sp.Symbol("t") if t is None else t
    angles = {abs(each.args[0].coeff(t)) for each in u.atoms(sp.cos, sp.sin)}
    return angles.pop() if len(angles) == 1 else None


__all__ = ["ClosedResponse", "closed_response", "frequencies_asked"]
