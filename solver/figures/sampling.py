"""The numbers of a plot: curves sampled where they bend, cut where they jump; the window chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from solver.derivation.figures import Curve, DrawnCurve, DrawnPlot, Mark, Plot
from solver.lazy import numeric
from solver.lazy import sympy as sp

POINTS = 301
ROUNDS = 5
"""So often are stretches halved in which a curve bends."""

FINE = 2e-3
"""A bend of this part of the height is seen."""

COARSE = 2e-4
"""A point that lies so near to the line between its neighbours says nothing."""

INSET = 1e-9
"""So near to a break, in parts of the stretch, a curve has its limit."""

REACH = 1e6
"""Values beyond this are not drawn: no reader can tell them from infinity."""

SAME = 1e-9
"""Curves that differ by no more than this part of the height are equal."""

BAND = 0.02
"""The settling band about the final value."""

Array = np.ndarray[Any, np.dtype[np.float64]]


def sampled(plot: Plot) -> DrawnPlot:
    """Return a plot as numbers; points where a curve has no finite real value are left out."""
    start, stop = number(plot.start), number(plot.stop)
    curves = tuple(named_together([_curve(curve, plot.variable, start, stop) for curve in plot.curves]))
    marks = tuple(Mark(number(mark.x), number(mark.y), mark.label, mark.sign) for mark in plot.marks)
    window = window_of(plot, curves, marks)
    if plot.settles is not None and curves:
        curves = (*_settling(curves[0], number(plot.settles), stop), *curves)
    return DrawnPlot(plot.caption, plot.x_label, plot.y_label, curves, marks, plot.equal, window)


def number(value: Any) -> float:
    """Return a real number as it is drawn."""
    return float(numeric.evaluate(value, {}).real)


def complex_number(value: Any) -> complex:
    """Return a number as it is drawn."""
    return complex(numeric.evaluate(value, {}))


def _curve(curve: Curve, variable: Any, start: float, stop: float) -> DrawnCurve:
    if curve.style == "jumps":
        return DrawnCurve(curve.label, curve.style, tuple(map(number, curve.x)), tuple(map(number, curve.y)))
    if curve.style == "samples":
        pieces = [_values(curve, variable, np.arange(np.ceil(start), np.floor(stop) + 1))]
    elif curve.style == "arrow":
        pieces = [_values(curve, variable, np.linspace(start, stop, POINTS))]
    else:
        breaks = _breaks(curve, variable)
        ends = [start, *(each for each in breaks if start < each < stop), stop]
        pieces = [plain(*_bent(curve, variable, (a, b), breaks)) for a, b in pairwise(ends)]
    x, y = (np.concatenate(each) for each in zip(*pieces, strict=True))
    return DrawnCurve(curve.label, curve.style, tuple(x.tolist()), tuple(y.tolist()))


def _breaks(curve: Curve, variable: Any) -> list[float]:
    """Return where steps of the curve's signals lie: there it jumps, or has a kink."""
    steps = {each.args[0] for side in (curve.x, curve.y) if side is not None for each in _steps_of(side)}
    return sorted({number(variable - each) for each in steps if each.diff(variable) == 1})


def _steps_of(expression: Any) -> set[Any]:
    found: set[Any] = expression.atoms(sp.Heaviside) if hasattr(expression, "atoms") else set()
    return found


def _bent(curve: Curve, variable: Any, ends: tuple[float, float], breaks: list[float]) -> tuple[Array, Array]:
    """Sample a curve from end to end, at breaks up to the limit from inside, with more points where it bends."""
    a, b = ends
    inset = (b - a) * INSET
    at = np.linspace(a + inset * (a in breaks), b - inset * (b in breaks), POINTS)
    x, y = _sides(curve, variable, at)
    for _ in range(ROUNDS):
        height = _span(y[np.isfinite(y)])
        between = (at[1:] + at[:-1]) / 2
        middle_x, middle_y = _sides(curve, variable, between)
        bends = np.abs(middle_y - (y[1:] + y[:-1]) / 2) > FINE * height
        if not bends.any():
            break
        order = np.argsort(np.concatenate([at, between[bends]]), kind="stable")
        at, x, y = (
            np.concatenate([old, new[bends]])[order] for old, new in ((at, between), (x, middle_x), (y, middle_y))
        )
    if curve.x is None:
        x[0], x[-1] = a, b
    return _seen(x, y)


def _values(curve: Curve, variable: Any, at: Array) -> tuple[Array, Array]:
    return _seen(*_sides(curve, variable, at))


def _sides(curve: Curve, variable: Any, at: Array) -> tuple[Array, Array]:
    y = numeric.values_at(curve.y, variable, at)
    return (at.copy() if curve.x is None else numeric.values_at(curve.x, variable, at)), y


def _seen(x: Array, y: Array) -> tuple[Array, Array]:
    seen = np.isfinite(x) & np.isfinite(y) & (np.abs(y) < REACH) & (np.abs(x) < REACH)
    return x[seen], y[seen]


def plain(x: Array, y: Array) -> tuple[Array, Array]:
    """Leave out points on the line between those that stay, by Ramer, Douglas and Peucker."""
    if len(x) < 3:
        return x, y
    scale_x, scale_y = _span(x), _span(y)
    kept, stack = {0, len(x) - 1}, [(0, len(x) - 1)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        u, v = (x[a : b + 1] - x[a]) / scale_x, (y[a : b + 1] - y[a]) / scale_y
        away = np.abs(u * v[-1] - v * u[-1]) / max(float(np.hypot(u[-1], v[-1])), 1e-12)
        away = np.maximum(away, np.hypot(u, v) * (away < 1e-12) * (np.hypot(u[-1], v[-1]) < 1e-12))
        farthest = a + int(np.argmax(away))
        if away.max() > COARSE:
            kept.add(farthest)
            stack += [(a, farthest), (farthest, b)]
    places = sorted(kept)
    return x[places], y[places]


def named_together(curves: Sequence[DrawnCurve]) -> list[DrawnCurve]:
    """Give curves that lie on each other one line with both names: nobody could tell them apart."""
    found: list[DrawnCurve] = []
    for each in curves:
        twin = next((i for i, other in enumerate(found) if each.label and other.label and _equal(each, other)), None)
        if twin is None:
            found.append(each)
        else:
            found[twin] = replace(found[twin], label=f"{found[twin].label} = {each.label}")
    return found


def _equal(a: DrawnCurve, b: DrawnCurve) -> bool:
    """Whether two curves are the same to the eye, and to a tolerance no drawing shows."""
    if a.style != b.style or len(a.x) != len(b.x) or not a.x or a.label == b.label:
        return False
    near = SAME * _span(np.array(a.y))
    return bool(np.allclose(a.x, b.x, rtol=SAME) and np.allclose(a.y, b.y, rtol=0, atol=near))


def _settling(curve: DrawnCurve, final: float, stop: float) -> list[DrawnCurve]:
    """The band about the final value, and the time from which the curve stays in it."""
    half = BAND * abs(final)
    if not half:
        return []
    band = DrawnCurve("", "area", (0.0, stop, stop, 0.0), (final - half, final - half, final + half, final + half))
    outside = [i for i, y in enumerate(curve.y) if abs(y - final) > half]
    if curve.style != "line" or not outside or outside[-1] + 1 >= len(curve.x):
        return [band]
    time = _crossing(curve, outside[-1], final, half)
    return [band, DrawnCurve("t_{s}", "guide", (time, time), (final, 0.0))]


def _crossing(curve: DrawnCurve, last: int, final: float, half: float) -> float:
    """Return where the curve enters the band after a point."""
    (x0, x1), (y0, y1) = curve.x[last : last + 2], curve.y[last : last + 2]
    edge = final + half if y0 > final else final - half
    return x0 + (x1 - x0) * (edge - y0) / (y1 - y0)


def window_of(plot: Plot, curves: Sequence[DrawnCurve], marks: Sequence[Mark]) -> tuple[float, float, float, float]:
    """Return x_min, x_max, y_min, y_max: as the plot says, else fitted."""
    if plot.window is not None:
        x_min, x_max, y_min, y_max = map(number, plot.window)
        return x_min, x_max, y_min, y_max
    return window_around(curves, marks, equal=plot.equal)


def window_around(
    curves: Sequence[DrawnCurve], marks: Sequence[Mark], *, equal: bool = False
) -> tuple[float, float, float, float]:
    """Return the window that holds curves and marks, with a margin above and below; if equal on all sides."""
    xs = np.concatenate([*(each.x for each in curves), [mark.x for mark in marks]])
    ys = np.concatenate([*(each.y for each in curves), [mark.y for mark in marks], [0.0]])
    x_margin = 0.0 if not equal else 0.05 * _span(xs)
    below, above = 0.07 * _span(ys), (0.16 if any(mark.label for mark in marks) else 0.07) * _span(ys)
    low, high = (float(xs.min()), float(xs.max())) if len(xs) else (0.0, 1.0)
    return low - x_margin, high + x_margin, float(ys.min()) - below, float(ys.max()) + above


def _span(values: Any) -> float:
    span = float(np.max(values) - np.min(values)) if len(values) else 0.0
    return span or 1.0
