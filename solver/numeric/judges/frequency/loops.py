"""Loops judged at jω in numbers: crossovers by companion matrices or from samples, poles by the argument principle."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.judges.frequency.roots import roots_of

WORKING = 40
NEAR = mpmath.mpf(10) ** -12
ROUGH = 1e-3
"""Roots by doubles so near to the real axis, relatively, may lie on it: multiple ones are not exact."""

SAMPLES = 60
"""Samples in a time 1/T of the frequency: a curve with a dead time turns by a radian there."""

FAR = 60
"""With a dead time crossings are sought up to so many times 1/T, and beyond the corners."""


@dataclass(frozen=True)
class NumericLoop:
    """L = N/D e^{−Ts}: the coefficients, highest power first, and T as mpmath's numbers."""

    N: tuple[Any, ...]
    D: tuple[Any, ...]
    T: Any

    def value(self, omega: Any) -> Any:
        """L(jω), 40 digits."""
        with mpmath.workdps(WORKING):
            s = self.point(omega)
            found = mpmath.polyval(self.N, s) / mpmath.polyval(self.D, s)
            return found * mpmath.exp(-s * self.T) if self.T else found

    def point(self, omega: Any) -> Any:
        """The point of the boundary of stability."""
        return mpmath.mpc(0, omega)

    def place(self, omega: Any) -> Any:
        """What sizes are polynomials in."""
        return omega**2

    def unit(self, omega: Any) -> Any:
        """The factor of odd parts."""
        return omega

    def frequency(self, x: Any) -> Any:
        """The frequency of a root of the polynomials `turned`."""
        return x

    def is_place(self, root: complex) -> bool:
        """Whether a rough root of a polynomial in ω² is that of a frequency."""
        return abs(root.imag) < 1e-6 * (1 + abs(root)) and root.real > 1e-12

    def values(self, omega: Any) -> Any:
        """L(jω) at many frequencies, in doubles."""
        s = 1j * np.asarray(omega, dtype=float)
        above, below = (np.polyval([float(c) for c in p], s) for p in (self.N, self.D))
        with np.errstate(divide="ignore", invalid="ignore"):
            return above / below * np.exp(-s * float(self.T))

    @cached_property
    def turned(self) -> tuple[Any, Any]:
        """The coefficients of N(jω) and D(jω) as polynomials in ω."""
        return tuple(  # type: ignore[return-value]
            [c * mpmath.mpc(0, 1) ** (len(p) - 1 - i) for i, c in enumerate(p)] for p in (self.N, self.D)
        )

    @cached_property
    def scale(self) -> float:
        """The largest size of a root of N or D, at least 1/T, else 1."""
        roots = [abs(z) for p in (self.N, self.D) for z in np.roots([float(c) for c in p])]
        return max([*(r for r in roots if r), 1 / float(self.T) if self.T else 0.0], default=1.0) or 1.0

    def gain_crossovers(self, level: Any = 1) -> list[Any]:
        """All ω > 0 with |L| = level, rising."""
        n, d = self.turned
        p = _minus(times(n, _conjugate(n)), [level**2 * c for c in times(d, _conjugate(d))])
        found = map(self.frequency, _positive_roots(p))
        return [w for w in found if abs(abs(self.value(w)) - level) < NEAR * level]

    def real_crossings(self) -> list[tuple[Any, Any]]:
        """All ω > 0 with L real and not zero, and L there; with a dead time those up to a last one far away."""
        if self.T:
            return self._sampled_crossings()
        n, d = self.turned
        product = times(n, _conjugate(d))
        found = []
        for x in _positive_roots([mpmath.im(c) for c in product]):
            if abs(mpmath.polyval(d, x)) > NEAR * sum(abs(c) * x ** (len(d) - 1 - i) for i, c in enumerate(d)):
                w = self.frequency(x)
                value = self.value(w)
                if abs(mpmath.im(value)) < NEAR * abs(value):
                    found.append((w, mpmath.re(value)))
        return found

    def _sampled_crossings(self) -> list[tuple[Any, Any]]:
        step, stop = 1 / (SAMPLES * float(self.T)), FAR / float(self.T) + 20 * self.scale
        even = np.arange(step, stop, max(step, stop / 400_000))
        omega = np.unique(np.concatenate([np.geomspace(step * 1e-6, stop, 20_000), even]))
        L = self.values(omega)
        known = np.isfinite(L)
        omega, sides = omega[known], np.imag(L[known])
        found = []
        for i in np.flatnonzero(sides[:-1] * sides[1:] < 0):
            w = _bracketed(lambda x: mpmath.im(self.value(x)), omega[i], omega[i + 1])
            value = self.value(w)
            if mpmath.isfinite(value) and abs(value) < 1 / ROUGH * (abs(L[known][i]) + abs(L[known][i + 1])):
                found.append((w, mpmath.re(value)))
        return found

    @cached_property
    def sampled(self) -> tuple[Any, Any]:
        """Frequencies, close about the roots, and magnitudes."""
        roots = [abs(z) for p in (self.N, self.D) for z in np.roots([float(c) for c in p]) if abs(z)] or [1.0]
        close = [r * (1 + d) for r in roots for d in np.linspace(-0.05, 0.05, 401)]
        omega = np.unique([*np.geomspace(min(roots) / 1e4, max(roots) * 1e4, 8000), *close])
        return omega, np.abs(self.values(omega))

    @property
    def last(self) -> Any:
        """The last frequency; there is none on the axis."""
        return None

    @property
    def at_rest(self) -> Any:
        """L(0); infinite at a pole."""
        return mpmath.inf if self.D[-1] == 0 else self.N[-1] / self.D[-1]


@dataclass(frozen=True)
class NumericMargins:
    """Pairs (frequency, margin) of those that decide: of equal ones all; gain margins as ratios, phases in degrees."""

    gains: tuple[tuple[Any, Any], ...]
    phases: tuple[tuple[Any, Any], ...]


def number_of(value: Any) -> Any:
    """A number with 40 digits."""
    return mpmath.mpmathify(sp.N(value, WORKING))


def numeric_margins(loop: NumericLoop) -> NumericMargins:
    """The margins by the definition: nearest to −1 in degrees and in decibels."""
    gains, phases = [], []
    for w in loop.gain_crossovers():
        margin = mpmath.degrees(mpmath.arg(-loop.value(w)))
        gains.append((w, margin if margin > -180 + NEAR else margin + 360))
    crossings = [(w, value) for w, value in loop.real_crossings() if value < 0]
    if loop.at_rest < 0:
        crossings.insert(0, (mpmath.mpf(0), loop.at_rest))
    if not crossings and not loop.T:  # real for all ω
        crossings = [(w, mpmath.mpf(-1)) for w, margin in gains if abs(margin) < NEAR and _is_real(loop)]
    phases = [(w, -1 / value) for w, value in crossings]
    return NumericMargins(
        _least(gains, abs), _least(phases, lambda ratio: abs(mpmath.log(ratio)))
    )  # fmt: skip


def _is_real(loop: NumericLoop) -> bool:
    """Whether L(jω) is real at several frequencies."""
    return all(abs(mpmath.im(loop.value(w))) < NEAR * abs(loop.value(w)) for w in (0.37, 1.91, 5.3))


def _least(pairs: Sequence[tuple[Any, Any]], distance: Callable[[Any], Any]) -> tuple[tuple[Any, Any], ...]:
    best = min((distance(margin) for _, margin in pairs), default=None)
    return tuple(each for each in pairs if best is not None and distance(each[1]) <= best + NEAR * (1 + best))


def unstable_poles(loop: NumericLoop) -> tuple[int, int]:
    """How many poles of 1/(1 + L) lie in the right half plane, and on the axis; discrete: beside the unit circle."""
    if not loop.T:
        p = plus(list(loop.N), list(loop.D))
        return roots_outside(p, discrete=loop.last is not None)
    return _by_the_argument(loop)


def margin_residual(value: Any, known: Sequence[Any], name: str) -> float:
    """How far a value is, relatively, from the nearest of those that are right; oo is right where there are none."""
    if not known or not value.is_finite:
        return 0.0 if not known and value == sp.oo else float("inf")
    own = number_of(value)
    if name == "gain_margin_db":
        known = [20 * mpmath.log10(each) for each in known]
    away = [abs(own - each) for each in known]
    if name == "phase_margin":
        away = [abs(mpmath.fmod(each + 180, 360) - 180) for each in away]
    return float(min(gap / (1 + abs(each)) for gap, each in zip(away, known, strict=True)))


def roots_outside(p: Sequence[Any], *, discrete: bool = False) -> tuple[int, int]:
    """How many roots of a polynomial lie in the right half plane, and on the axis; discrete: beside the unit circle."""
    return _roots_outside(tuple(p), discrete)


@lru_cache(maxsize=64)
def _roots_outside(p: tuple[Any, ...], discrete: bool) -> tuple[int, int]:
    factors = sp.Poly([sp.Float(str(c), WORKING) if not isinstance(c, sp.Expr) else c for c in p], sp.Dummy("s"))
    with mpmath.workdps(3 * WORKING):
        listed = [mpmath.mpmathify(sp.N(c, 3 * WORKING)) for c in factors.all_coeffs()]
        roots = roots_of(listed)
        away = [(abs(z) - 1 if discrete else mpmath.re(z)) / (1 + abs(z)) for z in roots]
        return sum(1 for each in away if each >= NEAR), sum(1 for each in away if abs(each) < NEAR)


def _by_the_argument(loop: NumericLoop) -> tuple[int, int]:
    """Zeros of D + N e^{−Ts} to the right, by the change of its argument along a large half disc a little inside."""
    N, D = ([float(c) for c in p] for p in (loop.N, loop.D))
    T, inset = float(loop.T), 1e-7

    def f(s: Any) -> Any:
        return np.polyval(D, s) + np.polyval(N, s) * np.exp(-s * T)

    radius = 10 * loop.scale + 10 * max([abs(float(c)) for c in N]) / max(abs(D[0]), 1e-12)
    count = int(min(200_000, 2000 + 400 * radius * T + 200 * radius / min(1.0, loop.scale)))
    line = inset + 1j * np.concatenate([-np.geomspace(radius, 1e-6, count), np.geomspace(1e-6, radius, count)])
    arc = inset + radius * np.exp(1j * np.linspace(np.pi / 2, -np.pi / 2, count))
    values = f(np.concatenate([line, arc]))
    turns = np.sum(np.angle(np.roll(values, -1) / values)) / (2 * np.pi)
    near = np.min(np.abs(f(1j * np.imag(line))) / (np.abs(np.polyval(D, line)) + np.abs(np.polyval(N, line))))
    return round(-float(turns)), int(near < 1e-9)


def times(a: Sequence[Any], b: Sequence[Any]) -> list[Any]:
    """The product of two polynomials, highest power first."""
    found = [mpmath.mpc(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            found[i + j] += x * y
    return found


def _conjugate(p: Sequence[Any]) -> list[Any]:
    return [mpmath.conj(c) for c in p]


def plus(a: list[Any], b: list[Any]) -> list[Any]:
    """Their sum."""
    size = max(len(a), len(b))
    pad = [[mpmath.mpf(0)] * (size - len(p)) + list(p) for p in (a, b)]
    return [x + y for x, y in zip(*pad, strict=True)]


def _minus(a: list[Any], b: list[Any]) -> list[Any]:
    return plus(a, [-c for c in b])


def _positive_roots(p: Sequence[Any]) -> list[Any]:
    """The positive real roots of a polynomial, rising, each once: companion matrix, then Newton's method on p/p'."""
    listed = [mpmath.re(c) for c in p]
    size = max((abs(c) for c in listed), default=mpmath.mpf(0))
    while listed and abs(listed[0]) <= NEAR**2 * size:
        listed.pop(0)
    while listed and listed[-1] == 0:
        listed.pop()
    if len(listed) < 2:
        return []
    slope = [c * (len(listed) - 1 - i) for i, c in enumerate(listed[:-1])]
    bend = [c * (len(slope) - 1 - i) for i, c in enumerate(slope[:-1])] or [mpmath.mpf(0)]
    scale = abs(listed[-1] / listed[0]) ** (mpmath.mpf(1) / (len(listed) - 1))
    scaled = [float(c * scale ** (len(listed) - 1 - i) / listed[-1]) for i, c in enumerate(listed)]
    found: list[Any] = []
    with mpmath.workdps(WORKING):
        for z in np.roots(scaled):
            if abs(z.imag) > ROUGH * (1 + abs(z)) or z.real <= 0:
                continue
            x = scale * mpmath.mpf(float(z.real))
            for _ in range(40):
                f, g, h = (mpmath.polyval(q, x) for q in (listed, slope, bend))
                below = g * g - f * h
                step = f * g / below if below else mpmath.mpf(0)
                x -= step
                if abs(step) <= abs(x) * mpmath.mpf(10) ** (-WORKING + 6):
                    break
            if x > 0 and all(abs(x - other) > NEAR * x for other in found):
                found.append(x)
    return sorted(found)


def _bracketed(f: Callable[[Any], Any], low: float, high: float) -> Any:
    """The zero between two places of different sign."""
    with mpmath.workdps(WORKING):
        ends = (mpmath.mpf(low), mpmath.mpf(high))
        return mpmath.findroot(f, ends, solver="anderson", tol=mpmath.mpf(10) ** (4 - 2 * WORKING), verify=False)


__all__ = ["NumericLoop", "NumericMargins", "margin_residual", "number_of", "numeric_margins", "plus", "roots_outside",
           "times", "unstable_poles"]  # fmt: skip
