"""Bode's diagram as two plots over one logarithmic axis: magnitudes in dB with their asymptotes, phases in degrees."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from solver.derivation.figures import DrawnCurve, DrawnPanels, DrawnPlot, Mark
from solver.derivation.frequency_figures import BodeDiagram, FrequencyResponse, MarkedFrequency
from solver.figures.responses import Array, decades, factors_at, frequencies, pieces
from solver.figures.sampling import plain

OMEGA = r"\omega\ \text{(rad/s)}"
DIGITS = 4
PER_NEPER = float(20 / np.log(10))
ABOVE = 30.0
"""So far above its asymptotes a magnitude is shown where it goes to infinity, in dB."""

LATEST = 400.0
"""A phase that falls for ever is shown down to so far below the last mark, in degrees."""

STEPS = (15, 30, 45, 90, 180, 360)
"""Distances of the ticks of phases."""


def bode_of(figure: BodeDiagram) -> DrawnPanels:
    """Return a diagram as plots."""
    low, high = decades(figure.responses, [each.omega for each in figure.marked])
    courses = [list(_course(each, low, high)) for each in figure.responses]
    sizes = [
        DrawnCurve(each.name, "line", *_thinned(omega, size))
        for each, pieces_of in zip(figure.responses, courses, strict=True)
        for omega, size, _ in pieces_of
    ]
    angles = [
        DrawnCurve(each.name, "line", *_thinned(omega, angle))
        for each, pieces_of in zip(figure.responses, courses, strict=True)
        for omega, _, angle in pieces_of
    ]
    if figure.asymptotes:
        sizes.append(_asymptotes(figure.responses[0], low, high))
    return DrawnPanels(
        figure.caption, (_magnitudes(figure, sizes, low, high), _phases(figure, angles, low, high))
    )  # fmt: skip


def _course(response: FrequencyResponse, low: float, high: float) -> Iterator[tuple[Array, Array, Array]]:
    """Frequencies, magnitudes in dB and phases between the poles and zeros on the axis."""

    def seen(omega: Array) -> tuple[Array, Array]:
        size, angle = factors_at(response, omega)
        return PER_NEPER * size, np.maximum(angle, -1e4)

    for ends in pieces(response, low, high):
        omega = frequencies(response, ends, seen)
        size, angle = seen(omega)
        yield omega, size, angle


def _thinned(omega: Array, y: Array) -> tuple[tuple[float, ...], tuple[float, ...]]:
    known = np.isfinite(y)
    x, shown = plain(np.log(omega[known]), y[known])
    return tuple(np.exp(x).tolist()), tuple(shown.tolist())


def corners(response: FrequencyResponse) -> list[tuple[float, int]]:
    """Return the corner frequencies, rising, each with the change of the slope in units of 20 dB a decade."""
    found = sorted((abs(r), m * (2 if r.imag else 1)) for r, m in response.roots)
    return [(omega, change) for omega, change in found if change]


def _asymptotes(response: FrequencyResponse, low: float, high: float) -> DrawnCurve:
    """The broken line of Bode's form."""
    slope, x = 20.0 * response.power, low
    y = PER_NEPER * float(np.log(abs(response.gain))) + slope * float(np.log10(low))
    xs, ys = [x], [y]
    for omega, change in corners(response):
        y += slope * float(np.log10(omega / x))
        x, slope = omega, slope + 20 * change
        xs.append(x)
        ys.append(y)
    xs.append(high)
    ys.append(y + slope * float(np.log10(high / x)))
    return DrawnCurve(r"\text{asymptotes}", "dashed", tuple(xs), tuple(ys))


def _reach(response: FrequencyResponse, low: float, high: float) -> tuple[float, ...]:
    """How high a curve goes apart from sharp peaks: the heights of its asymptotes, of a discrete loop its own."""
    if not response.period:
        return _asymptotes(response, low, high).y
    omega = np.geomspace(low, high * (1 - 1e-3), 400)
    size = PER_NEPER * factors_at(response, omega)[0]
    return tuple(float(each) for each in np.percentile(size[np.isfinite(size)], (2, 98)))


def _magnitudes(figure: BodeDiagram, curves: list[DrawnCurve], low: float, high: float) -> DrawnPlot:
    reach = [_reach(each, low, high) for each in figure.responses]
    ys = [y for each in curves for y in each.y]
    top = min(max(ys), max(map(max, reach)) + ABOVE)
    bottom = max(min(ys), min(map(min, reach)) - ABOVE)
    if figure.marked:
        top, bottom = max(top, 5.0), min(bottom, -5.0)
    guides, marks = [], []
    for each in _shown(figure.marked):
        y = _at(figure.responses[0], each.omega)[0]
        guides.append(DrawnCurve(_name(each) * (each.of != "phase"), "guide", (each.omega,) * 2, (bottom, top)))
        if each.of == "phase" and each.margin is not None:
            guides.append(DrawnCurve(margin_of(each), "span", (each.omega, each.omega), (0.0, y)))
        if each.of:
            marks.append(Mark(each.omega, y if each.of == "phase" else 0.0))
    window = (low, high, bottom - 0.04 * (top - bottom), top + 0.12 * (top - bottom))
    label = rf"|{figure.responses[0].name}|\ \text{{(dB)}}" if len(figure.responses) == 1 else r"\text{dB}"
    return DrawnPlot(
        figure.caption, OMEGA, label, (*guides, *_named(curves, figure)), tuple(marks), False, window, logarithmic=True
    )


def _named(curves: Sequence[DrawnCurve], figure: BodeDiagram) -> list[DrawnCurve]:
    """The curves; where they are one, its name is that of the axis."""
    return list(curves) if len(figure.responses) > 1 or figure.asymptotes else [
        DrawnCurve("", each.style, each.x, each.y) for each in curves
    ]  # fmt: skip


def _phases(figure: BodeDiagram, curves: list[DrawnCurve], low: float, high: float) -> DrawnPlot:
    shown = _shown(figure.marked)
    marked = [_at(figure.responses[0], each.omega)[1] for each in shown]
    ys = [y for each in curves for y in each.y]
    top, bottom = max(ys), min(ys)
    if any(each.delay for each in figure.responses):
        firsts = [each.y[0] for each in curves]
        bottom = max(bottom, min([*marked, *firsts]) - LATEST)
    levels = {_nearest_level(y) for each, y in zip(shown, marked, strict=True) if each.of}
    top, bottom = max([top, *levels]), min([bottom, *levels])
    step = next((each for each in STEPS if (top - bottom) / each <= 5), STEPS[-1])
    guides = [DrawnCurve("", "guide", (low, high), (level, level)) for level in sorted(levels)]
    for each, y in zip(shown, marked, strict=True):
        guides.append(DrawnCurve(_name(each) * (each.of == "phase"), "guide", (each.omega,) * 2, (top, bottom)))
        if each.of == "gain" and each.margin is not None:
            guides.append(DrawnCurve(margin_of(each), "span", (each.omega, each.omega), (_nearest_level(y), y)))
    marks = [Mark(each.omega, y) for each, y in zip(shown, marked, strict=True) if each.of]
    edge = 0.08 * max(top - bottom, 20)
    window = (low, high, bottom - edge, top + edge)
    label = (
        rf"\angle {figure.responses[0].name}\ (^{{\circ}})"
        if len(figure.responses) == 1
        else r"\text{phase}\ (^{\circ})"
    )
    named = _named(curves, figure) if len(figure.responses) > 1 else [
        DrawnCurve("", each.style, each.x, each.y) for each in curves
    ]  # fmt: skip
    return DrawnPlot(
        figure.caption, OMEGA, label, (*guides, *named), tuple(marks), False, window, logarithmic=True, y_step=step
    )


def short(value: float) -> str:
    """Return a number with few digits as LaTeX."""
    digits, _, power = f"{value:.{DIGITS}g}".partition("e")
    return rf"{digits} \cdot 10^{{{int(power)}}}" if power else digits


def _name(mark: MarkedFrequency) -> str:
    return f"{mark.name} = {short(mark.omega)}" if mark.name else ""


def margin_of(mark: MarkedFrequency) -> str:
    """Return the name of a margin with its value."""
    if mark.margin is None:
        return ""
    value = short(mark.margin)
    return rf"G_{{m}} = {value}\ \text{{dB}}" if mark.of == "phase" else rf"\varphi_{{m}} = {value}^{{\circ}}"


def _shown(marked: Sequence[MarkedFrequency]) -> list[MarkedFrequency]:
    return [each for each in marked if each.omega > 0]


def _at(response: FrequencyResponse, omega: float) -> tuple[float, float]:
    """The magnitude in dB and the phase at a frequency."""
    size, angle = factors_at(response, np.array([omega]))
    return PER_NEPER * float(size[0]), float(angle[0])


def _nearest_level(phase: float) -> float:
    """The level −180° − 360° k that is nearest to a phase."""
    return -180.0 + 360.0 * round((phase + 180.0) / 360.0)


__all__ = ["bode_of", "corners", "margin_of", "short"]
