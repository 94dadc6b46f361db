"""The numbers of a plot: curves sampled, the window chosen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.derivation.figures import Curve, Drawing, DrawnCurve, DrawnPlot, Figure, Mark, Plot
from solver.lazy import numeric

POINTS = 301
REACH = 1e6
"""Values beyond this are not drawn: no reader can tell them from infinity."""

Array = np.ndarray[Any, np.dtype[np.float64]]


def drawing_of(figure: Figure) -> Drawing:
    """Return a figure without expressions: a plot as numbers, a diagram as it is."""
    return sampled(figure) if isinstance(figure, Plot) else figure


def sampled(plot: Plot) -> DrawnPlot:
    """Return a plot as numbers; points where a curve has no finite real value are left out."""
    start, stop = _number(plot.start), _number(plot.stop)
    smooth = np.linspace(start, stop, POINTS)
    whole = np.arange(np.ceil(start), np.floor(stop) + 1)
    curves = tuple(_curve(curve, plot.variable, whole if curve.style == "samples" else smooth) for curve in plot.curves)
    marks = tuple(Mark(_number(mark.x), _number(mark.y), mark.label) for mark in plot.marks)
    window = _window(plot, curves, marks)
    return DrawnPlot(plot.caption, plot.x_label, plot.y_label, curves, marks, plot.equal, window)


def _number(value: Any) -> float:
    return float(numeric.evaluate(value, {}).real)


def _curve(curve: Curve, variable: Any, at: Array) -> DrawnCurve:
    y = numeric.values_at(curve.y, variable, at)
    x = at if curve.x is None else numeric.values_at(curve.x, variable, at)
    seen = np.isfinite(x) & np.isfinite(y) & (np.abs(y) < REACH) & (np.abs(x) < REACH)
    return DrawnCurve(curve.label, curve.style, tuple(x[seen].tolist()), tuple(y[seen].tolist()))


def _window(plot: Plot, curves: Sequence[DrawnCurve], marks: Sequence[Mark]) -> tuple[float, float, float, float]:
    """Return x_min, x_max, y_min, y_max: as the plot says, else fitted to the curves and marks with a margin."""
    if plot.window is not None:
        x_min, x_max, y_min, y_max = map(_number, plot.window)
        return x_min, x_max, y_min, y_max
    xs = np.concatenate([*(each.x for each in curves), [mark.x for mark in marks]])
    ys = np.concatenate([*(each.y for each in curves), [mark.y for mark in marks], [0.0]])
    x_margin = 0.0 if not plot.equal else 0.05 * _span(xs)
    y_margin = 0.07 * _span(ys)
    low, high = (float(xs.min()), float(xs.max())) if len(xs) else (0.0, 1.0)
    return low - x_margin, high + x_margin, float(ys.min()) - y_margin, float(ys.max()) + y_margin


def _span(values: Array) -> float:
    span = float(values.max() - values.min()) if len(values) else 0.0
    return span or 1.0
