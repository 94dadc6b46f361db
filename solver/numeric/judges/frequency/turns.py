"""Turns of L about −1 along Nyquist's path, by the change of the argument of 1 + L; its crossings of the real axis."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np

from solver.numeric.judges.frequency.crossings import decimal, is_real
from solver.numeric.judges.frequency.loops import NumericLoop, plus
from solver.numeric.judges.frequency.roots import roots_of

INSET = 1e-7
"""The path runs so far right of the axis, in parts of the largest root: that passes poles on it on their right."""

OUTSIDE = 0.02
"""The path of a discrete loop runs outside of the circle by half of this at most."""

MANY = 120
ON_CIRCLE = mpmath.mpf(10) ** -12
"""Multiple roots keep a part of many digits; those so near to the circle are on it."""

COUNT = 20_000
STEP = 1.2
"""A larger change of the argument from sample to sample asks for more samples."""

WRONG = float("inf")


def turns_about(loop: NumericLoop) -> int | None:
    """Return the clockwise turns; None where samples cannot follow the curve."""
    if loop.last is not None:
        return _turns_on_circle(loop)
    N, D = (np.array([float(c) for c in p]) for p in (loop.N, loop.D))
    T, scale = float(loop.T), loop.scale
    roots = [z for p in (N, D) for z in np.roots(p)]
    inset = INSET * min([abs(z) for z in roots if abs(z) > 1e-9] or [1.0])
    gain = max(np.max(np.abs(N)) / abs(D[0]), 1.0)
    radius = 100 * scale * gain
    even = np.geomspace(inset / 1e3, radius, COUNT)
    close = [abs(z.imag) + np.concatenate([-w, w]) for z in roots for w in (np.geomspace(inset / 1e3, scale, 2000),)]
    fine = np.arange(0, min(radius, 60 / T), 0.01 / T) if T else np.array([])
    up = np.unique(np.concatenate([even, *close, fine]))
    up = up[(up > 0) & (up <= radius)]
    if T:
        up = up[up <= 60 / T]
    omega = np.concatenate([-up[::-1], [0.0], up])
    arc = [] if T else up[-1] * np.exp(1j * np.linspace(np.pi / 2, -np.pi / 2, COUNT)[1:-1])
    s = np.concatenate([inset + 1j * omega, inset + np.asarray(arc)])
    values = 1 + np.polyval(N, s) / np.polyval(D, s) * np.exp(-s * T)
    steps = np.angle(np.roll(values, -1) / values)
    if not np.all(np.isfinite(steps)) or np.max(np.abs(steps)) > STEP:
        return None
    return -round(float(np.sum(steps)) / (2 * np.pi))


def _turns_on_circle(loop: NumericLoop) -> int | None:
    """The same while z runs round the unit circle, outside of it by half the distance of the nearest root there."""
    N, D = (np.array([float(c) for c in p]) for p in (loop.N, loop.D))
    with mpmath.workdps(MANY):
        listed = [roots_of(p) for p in (list(loop.D), plus(list(loop.N), list(loop.D)))]
        away = [float(abs(z) - 1) for z in (*listed[0], *listed[1]) if abs(z) - 1 > ON_CIRCLE]
    inset = min([OUTSIDE, *away]) / 2
    around = np.geomspace(inset / 10, 2 * np.pi, 3000)
    close = [float(mpmath.arg(z)) + np.concatenate([-around, around]) for z in (*listed[0], *listed[1])]
    theta = np.unique(np.concatenate([np.linspace(-np.pi, np.pi, COUNT), *close]))
    z = (1 + inset) * np.exp(1j * theta[(theta >= -np.pi) & (theta <= np.pi)])
    values = 1 + np.polyval(N, z) / np.polyval(D, z)
    steps = np.angle(np.roll(values, -1) / values)
    if not np.all(np.isfinite(steps)) or np.max(np.abs(steps)) > STEP:
        return None
    return -round(float(np.sum(steps)) / (2 * np.pi))


def crossing_residual(loop: NumericLoop, found: Sequence[Any]) -> float:
    """How far values are from the real values of L, ω > 0, in any order; with a dead time from the largest."""
    if is_real(loop):
        return 0.0 if not found else WRONG
    wanted = sorted((value for _, value in loop.real_crossings()), key=abs, reverse=True)
    own = sorted((decimal(each) for each in found), key=abs, reverse=True)
    if loop.T:
        if len(own) > len(wanted) or (len(own) < len(wanted) and wanted and abs(wanted[len(own)]) >= 1):
            return WRONG
        wanted = wanted[: len(own)]
    if len(own) != len(wanted):
        return WRONG
    left = list(wanted)
    worst = mpmath.mpf(0)
    for value in own:
        nearest = min(left, key=lambda each: abs(each - value))
        left.remove(nearest)
        worst = max(worst, abs(nearest - value) / abs(nearest))
    return float(worst)


__all__ = ["crossing_residual", "turns_about"]
