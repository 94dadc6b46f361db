"""The numbers of a plot: curves sampled, the window chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from solver.derivation.figures import Curve, Plot
from solver.lazy import numeric

POINTS = 301
REACH = 1e6
"""Values beyond this are not drawn: no reader can tell them from infinity."""

Array = np.ndarray[Any, np.dtype[np.float64]]


@dataclass(frozen=True)
class Sampled:
    """A curve as numbers: `x` and `y` of the same length, without gaps."""

    curve: Curve
    x: Array
    y: Array

    @property
    def middle(self) -> int:
        """The index of the point half way along the curve, where an arrowhead stands."""
        steps = np.hypot(np.diff(self.x), np.diff(self.y))
        way = np.concatenate([[0.0], np.cumsum(steps)])
        return int(np.clip(np.searchsorted(way, way[-1] / 2), 1, max(len(way) - 1, 1)))


def sampled(plot: Plot) -> list[Sampled]:
    """Return the curves of a plot as numbers; points where a curve has no finite real value are left out."""
    start, stop = (float(numeric.evaluate(bound, {}).real) for bound in (plot.start, plot.stop))
    smooth = np.linspace(start, stop, POINTS)
    whole = np.arange(np.ceil(start), np.floor(stop) + 1)
    return [_curve(curve, plot.variable, whole if curve.style == "samples" else smooth) for curve in plot.curves]


def number(value: Any) -> float:
    """Return a value of a mark or a window as a float."""
    return float(numeric.evaluate(value, {}).real)


def _curve(curve: Curve, variable: Any, at: Array) -> Sampled:
    y = numeric.values_at(curve.y, variable, at)
    x = at if curve.x is None else numeric.values_at(curve.x, variable, at)
    seen = np.isfinite(x) & np.isfinite(y) & (np.abs(y) < REACH) & (np.abs(x) < REACH)
    return Sampled(curve, x[seen], y[seen])


def window(plot: Plot, curves: Sequence[Sampled]) -> tuple[float, float, float, float]:
    """Return x_min, x_max, y_min, y_max: as the plot says, else fitted to the curves and marks with a margin."""
    if plot.window is not None:
        return tuple(number(bound) for bound in plot.window)  # type: ignore[return-value]  # four of them
    xs = np.concatenate([*(each.x for each in curves), [number(mark.x) for mark in plot.marks]])
    ys = np.concatenate([*(each.y for each in curves), [number(mark.y) for mark in plot.marks], [0.0]])
    x_margin = 0.0 if not plot.equal else 0.05 * _span(xs)
    y_margin = 0.07 * _span(ys)
    low, high = (xs.min(), xs.max()) if len(xs) else (0.0, 1.0)
    return low - x_margin, high + x_margin, float(ys.min()) - y_margin, float(ys.max()) + y_margin


def _span(values: Array) -> float:
    span = float(values.max() - values.min()) if len(values) else 0.0
    return span or 1.0
