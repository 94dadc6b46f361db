"""Nyquist's diagram as a plot: the curve of L(jω) with its mirror image, its arcs at infinity, and the point −1."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from solver.derivation.figures import DrawnCurve, DrawnPlot, Mark
from solver.derivation.frequency_figures import FrequencyResponse, NyquistDiagram
from solver.figures.bode import short
from solver.figures.responses import (
    Array,
    decades,
    factors_at,
    frequencies,
    frequency_of,
    on_the_axis,
    pieces,
    values,
)
from solver.figures.sampling import plain

LEAST = 1.7
"""The window reaches at least so far from the origin."""

LARGE = 8.0
"""A curve that goes farther than this hides what happens at −1: that is shown by a figure of its own."""

SMALL = 0.07
"""Crossings nearer to the origin than this part of the window have no name."""

FAR = 4.0
"""The asymptote of a curve that comes from infinity is shown where it is not farther than so many times the rest."""

WIDER = 3.0
"""Decades beyond the corners, where the curve goes to its ends."""

ARC = 90
"""Points of an arc at infinity for each half turn."""


def reach_of(response: FrequencyResponse, crossings: tuple[float, ...]) -> float:
    """Return how far from the origin something happens: crossings, the whole curve where it is finite."""
    needed = [abs(x) for x in crossings]
    low, high = _range(response)
    omega = np.geomspace(low, high, 400)
    L = values(response, omega)
    if response.power >= 0 and not on_the_axis_of_poles(response):
        needed.append(float(np.max(np.abs(L))))
    elif response.power == -1 and abs(float(L[0].real)) < FAR * max([LEAST, *needed]):
        needed.append(1.2 * abs(float(L[0].real)))
    return max([LEAST / 1.25, *needed])


def on_the_axis_of_poles(response: FrequencyResponse) -> list[tuple[float, int]]:
    """Return the frequencies of the poles on the axis but the origin, with their multiplicities."""
    on = on_the_axis(response)
    return [(frequency_of(response, r), -m) for r, m in response.roots if m < 0 and frequency_of(response, r) in on]


def nyquist_of(figure: NyquistDiagram) -> DrawnPlot:
    """Return a diagram as a plot."""
    response = figure.response
    shown = figure.crossings
    if figure.near:
        radius = 1.35 * max([LEAST, *(abs(x) for x in shown if abs(x) < LARGE / 2)])
    else:
        radius = 1.25 * reach_of(response, shown)
    name = response.name
    curves: list[DrawnCurve] = []
    for branch in _visible(response, radius):
        for sign, style, label in ((1, "arrow", r"\omega > 0"), (-1, "dashed arrow", r"\omega < 0")):
            x, y = (side[::sign] for side in plain(branch.real, sign * branch.imag))
            curves.append(DrawnCurve(label, style, tuple(x.tolist()), tuple(y.tolist())))
    curves += [] if figure.near else list(_arcs(response, 0.94 * radius))
    curves.append(DrawnCurve("-1", "cross", (-1.0,), (0.0,)))
    near = [(x, short(x) if abs(x) > SMALL * radius else "") for x in figure.crossings if abs(x) < radius]
    marks = tuple(Mark(x, 0.0, label) for x, label in near)
    window = (-radius, radius, -radius, radius)
    labels = rf"\operatorname{{Re}} {name}", rf"\operatorname{{Im}} {name}"
    return DrawnPlot(figure.caption, *labels, tuple(sorted(curves, key=_order)), marks, True, window)


def _order(curve: DrawnCurve) -> tuple[bool, str]:
    """ω > 0 first: it has the first colour."""
    return curve.style != "arrow", curve.style


def _range(response: FrequencyResponse) -> tuple[float, float]:
    low, high = decades([response], [])
    if response.period:
        return low / 10**WIDER, high
    return low / 10**WIDER, high * 10**WIDER


def _visible(response: FrequencyResponse, radius: float) -> Iterator[Array]:
    """The parts of the curve within the window, ω rising."""
    low, high = _range(response)
    if response.delay:
        high = min(high, 60 / response.delay)
    limit = 1.3 * radius

    def seen(omega: Array) -> tuple[Array, Array]:
        L = values(response, omega)
        return np.clip(L.real, -limit, limit), np.clip(L.imag, -limit, limit)

    for ends in pieces(response, low, high):
        L = values(response, frequencies(response, ends, seen))
        inside = np.isfinite(L) & (np.abs(L.real) <= radius) & (np.abs(L.imag) <= radius)
        for part in np.split(np.arange(len(L)), np.flatnonzero(np.diff(inside)) + 1):
            if len(part) > 1 and inside[part[0]] and np.ptp(np.abs(L[part])) + np.ptp(np.angle(L[part])) > 0:
                yield L[part]


def _arcs(response: FrequencyResponse, radius: float) -> Iterator[DrawnCurve]:
    """What becomes of the small half circles round the poles on the axis: half turns clockwise, at infinity."""
    start = 90.0 * response.power - (180.0 if response.gain < 0 else 0.0)
    if response.power < 0:
        yield _arc(start - 180.0 * response.power, start, radius)
    for omega, m in on_the_axis_of_poles(response):
        _, angle = factors_at(response, np.array([omega * (1 - 1e-7)]))
        before = float(angle[0])
        yield _arc(before, before - 180.0 * m, radius)
        if omega != response.last:
            yield _arc(180.0 * m - before, -before, radius)


def _arc(start: float, stop: float, radius: float) -> DrawnCurve:
    """A part of a circle; one of more than a turn winds inward so that each turn is seen."""
    count = max(int(ARC * abs(stop - start) / 180), 2)
    angle = np.radians(np.linspace(start, stop, count))
    size = radius * (1 - 0.05 * np.linspace(0, 1, count) * abs(stop - start) / 360)
    x, y = size * np.cos(angle), size * np.sin(angle)
    return DrawnCurve(r"\text{at infinity}", "arc", tuple(x.tolist()), tuple(y.tolist()))


__all__ = ["LARGE", "nyquist_of", "on_the_axis_of_poles", "reach_of"]
