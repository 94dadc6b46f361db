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
    """Return the frequencies of the poles and zeros on the axis, or on the unit circle, rising."""
    if response.period:
        return sorted({frequency_of(response, r) for r, _ in response.roots if abs(abs(r) - 1) <= ON_AXIS})
    return sorted({abs(r) for r, _ in response.roots if abs(r.real) <= ON_AXIS * abs(r)})


def frequency_of(response: FrequencyResponse, r: complex) -> float:
    """Return where a pole or zero is seen: |r|, of a discrete loop the angle of one of the plane over T."""
    return abs(float(np.angle(r))) / response.period if response.period else abs(r)


def corners_of(response: FrequencyResponse) -> list[float]:
    """Return the frequencies about which the curves bend: |r|, of a discrete loop those of the roots e^{rT} = z."""
    if not response.period:
        return [abs(r) for r, _ in response.roots]
    found = [abs(complex(np.log(complex(r)))) / response.period for r, _ in response.roots if r]
    return [min(each, response.last) for each in found if each] or [response.last / 10]


def factors_at(response: FrequencyResponse, omega: Array) -> tuple[Array, Array]:
    """Return ln |L| and the continuous phase in degrees."""
    if response.period:
        return _on_circle(response, omega)
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


def _on_circle(response: FrequencyResponse, omega: Array) -> tuple[Array, Array]:
    """The same at z = e^{jωT}; the phase of a root on the circle jumps as if it lay just inside."""
    theta = omega * response.period
    z = np.exp(1j * theta)
    size = np.log(abs(response.gain)) + response.power * np.log(2 * np.sin(theta / 2))
    angle = (90 + np.degrees(theta) / 2) * response.power - (HALF_TURN if response.gain < 0 else 0.0)
    for r, m in response.roots:
        for each in (r, np.conj(r)) if r.imag else (r.real,):
            with np.errstate(divide="ignore"):
                size = size + m * np.log(np.abs((z - each) / (1 - each)))
            if not r.imag:
                turned = np.angle((z - each) / (1 - each))
            elif abs(r) <= 1 + ON_AXIS:
                turned = theta + np.angle(1 - each / z)
            else:
                turned = np.angle(1 - z / each)
            angle = angle + m * np.degrees(turned)
    return size, angle


def decibels(response: FrequencyResponse, omega: Array) -> Array:
    """Return 20 log₁₀ |L|."""
    return 20 / np.log(10) * factors_at(response, omega)[0]


def values(response: FrequencyResponse, omega: Array) -> Array:
    """Return L(jω)."""
    size, angle = factors_at(response, omega)
    return np.exp(size + 1j * np.radians(angle))


def decades(responses: Sequence[FrequencyResponse], marked: Sequence[float]) -> tuple[float, float]:
    """Return the first and the last frequency shown: whole decades around the corners and what is marked.

    Of a discrete loop the last is the Nyquist frequency.
    """
    corners = [x for each in responses for x in corners_of(each)] + [omega for omega in marked if omega > 0]
    corners += [1 / each.delay for each in responses if each.delay]
    corners = corners or [1.0]
    low, high = np.log10(min(corners)) - MARGIN, np.log10(max(corners)) + MARGIN
    low, high = np.floor(low), np.ceil(high)
    last = max(each.last for each in responses)
    if last:
        return float(min(10**low, last / 100)), last
    if high - low < 2:
        high = low + 2
    return float(10**low), float(10**high)


def pieces(response: FrequencyResponse, low: float, high: float) -> list[tuple[float, float]]:
    """Return the intervals between poles and zeros on the axis."""
    beside = [each for each in on_the_axis(response) if low < each <= high]
    ends = [low, *(each for each in beside if each < high), high]
    return [
        (a * (1 + BESIDE * (a in beside)), b * (1 - BESIDE * (b in beside))) for a, b in pairwise(ends)
    ]  # fmt: skip


def frequencies(
    response: FrequencyResponse, ends: tuple[float, float], seen: Callable[[Array], Sequence[Array]]
) -> Array:
    """Return frequencies in an interval, closer where one of the curves of `seen` bends over the logarithm of ω."""
    a, b = np.log(ends[0]), np.log(ends[1])
    even = np.linspace(a, b, max(int(PER_DECADE * (b - a) / np.log(10)), 60))
    peaks = [np.log(frequency_of(response, r)) + s * max(_width(response, r), BESIDE) * w
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


def _width(response: FrequencyResponse, r: complex) -> float:
    """How wide the bend of a pair is, in parts of its frequency."""
    return abs(abs(r) - 1) / abs(float(np.angle(r))) if response.period else abs(r.real) / abs(r)


__all__ = [
    "corners_of",
    "decades",
    "decibels",
    "factors_at",
    "frequencies",
    "frequency_of",
    "on_the_axis",
    "pieces",
    "values",
]
