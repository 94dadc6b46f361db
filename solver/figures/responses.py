"""Values of frequency responses in Bode's form, and frequencies at which to take them: more where the curves bend."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from solver.derivation.frequency_figures import FrequencyResponse

Array = np.ndarray[Any, np.dtype[Any]]

PER_DECADE = 40
ROUNDS = 6
"""So often are stretches halved in which a curve bends."""

FINE = 2e-3
"""A bend of this part of the height is seen."""

BESIDE = 1e-6
"""So near, relatively, to a pole or zero on the axis a curve ends."""

ON_AXIS = 1e-12
HALF_TURN = 180.0
MARGIN = 0.7
"""Decades shown before the first corner and beyond the last, at least."""


def on_the_axis(response: FrequencyResponse) -> list[float]:
    """Return the frequencies of the poles and zeros on the axis, rising."""
    return sorted({abs(r) for r, _ in response.roots if abs(r.real) <= ON_AXIS * abs(r)})


def factors_at(response: FrequencyResponse, omega: Array) -> tuple[Array, Array]:
    """Return ln |L| and the continuous phase in degrees."""
    size = np.log(abs(response.gain)) + response.power * np.log(omega)
    angle = np.full(omega.shape, 90.0 * response.power - (HALF_TURN if response.gain < 0 else 0.0))
    for r, m in response.roots:
        if r.imag:
            real, imaginary = 1 - (omega / abs(r)) ** 2, -2 * omega * r.real / abs(r) ** 2
            if abs(r.real) <= ON_AXIS * abs(r):
                imaginary = 0 * omega
            angle = angle + m * np.degrees(np.arctan2(imaginary, real))
        else:
            real, imaginary = np.ones_like(omega), -omega / r.real
            angle = angle + m * np.degrees(np.arctan(imaginary))
        with np.errstate(divide="ignore"):
            size = size + m * np.log(np.hypot(real, imaginary))
    return size, angle - np.degrees(omega * response.delay)


def decibels(response: FrequencyResponse, omega: Array) -> Array:
    """Return 20 log₁₀ |L|."""
    return 20 / np.log(10) * factors_at(response, omega)[0]


def values(response: FrequencyResponse, omega: Array) -> Array:
    """Return L(jω)."""
    size, angle = factors_at(response, omega)
    return np.exp(size + 1j * np.radians(angle))


def decades(responses: Sequence[FrequencyResponse], marked: Sequence[float]) -> tuple[float, float]:
    """Return the first and the last frequency shown: whole decades around the corners and what is marked."""
    corners = [abs(r) for each in responses for r, _ in each.roots] + [omega for omega in marked if omega > 0]
    corners += [1 / each.delay for each in responses if each.delay]
    corners = corners or [1.0]
    low, high = np.log10(min(corners)) - MARGIN, np.log10(max(corners)) + MARGIN
    low, high = np.floor(low), np.ceil(high)
    if high - low < 2:
        high = low + 2
    return float(10**low), float(10**high)


def pieces(response: FrequencyResponse, low: float, high: float) -> list[tuple[float, float]]:
    """Return the intervals between poles and zeros on the axis."""
    inner = [each for each in on_the_axis(response) if low < each < high]
    ends = [low, *inner, high]
    return [
        (a * (1 + BESIDE * (a in inner)), b * (1 - BESIDE * (b in inner))) for a, b in pairwise(ends)
    ]  # fmt: skip


def frequencies(
    response: FrequencyResponse, ends: tuple[float, float], seen: Callable[[Array], Sequence[Array]]
) -> Array:
    """Return frequencies in an interval, closer where one of the curves of `seen` bends over the logarithm of ω."""
    a, b = np.log(ends[0]), np.log(ends[1])
    even = np.linspace(a, b, max(int(PER_DECADE * (b - a) / np.log(10)), 60))
    peaks = [np.log(abs(r)) + s * max(abs(r.real) / abs(r), BESIDE) * w
             for r, _ in response.roots if r.imag for s in (-1, 1) for w in (0, 0.3, 1, 3, 10)]  # fmt: skip
    at = np.unique(np.concatenate([even, [each for each in peaks if a < each < b]]))
    for _ in range(ROUNDS):
        between = (at[1:] + at[:-1]) / 2
        bends = np.zeros(between.shape, dtype=bool)
        for ours, theirs in zip(seen(np.exp(at)), seen(np.exp(between)), strict=True):
            known = ours[np.isfinite(ours)]
            height = float(np.ptp(known)) if len(known) else 1.0
            bends |= np.abs(theirs - (ours[1:] + ours[:-1]) / 2) > FINE * (height or 1.0)
        if not bends.any():
            break
        at = np.sort(np.concatenate([at, between[bends]]))
    found: Array = np.exp(at)
    return found


__all__ = ["decades", "decibels", "factors_at", "frequencies", "on_the_axis", "pieces", "values"]
