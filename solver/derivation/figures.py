"""Figures as data: what a step wants drawn. They are drawn only where a page shows them.

Labels are LaTeX without dollar signs, captions are Markdown with `$math$`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any


@dataclass(frozen=True, slots=True)
class Curve:
    """One curve of a plot: `x` and `y` are expressions in the plot's variable; `x` None is the variable itself.

    `style` is "line", "dashed", "samples" (values at whole numbers, for discrete time) or "arrow" (a trajectory with
    an arrowhead in its middle).
    """

    y: Any
    label: str = ""
    x: Any = None
    style: str = "line"


@dataclass(frozen=True, slots=True)
class Mark:
    """A point of a plot worth naming: a peak, an equilibrium."""

    x: Any
    y: Any
    label: str = ""


@dataclass(frozen=True, slots=True)
class Plot:
    """Curves over `variable` from `start` to `stop`, numbers all; only the variable may be free in the expressions.

    `equal` gives both axes the same scale (a phase plane); `window` is (x_min, x_max, y_min, y_max), None fits the
    curves.
    """

    caption: str
    x_label: str
    y_label: str
    variable: Any
    start: Any
    stop: Any
    curves: tuple[Curve, ...]
    marks: tuple[Mark, ...] = ()
    equal: bool = False
    window: tuple[Any, Any, Any, Any] | None = None


@dataclass(frozen=True, slots=True)
class Diagram:
    """A block diagram known by name (`solver/figures`), with the LaTeX to write into its blocks and at its arrows."""

    caption: str
    name: str
    labels: Mapping[str, str] = field(default_factory=dict)


Figure = Plot | Diagram


@dataclass(frozen=True, slots=True)
class DrawnCurve:
    """A curve as numbers: `x` and `y` of the same length, without gaps."""

    label: str
    style: str
    x: tuple[float, ...]
    y: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class DrawnPlot:
    """A plot as numbers, made from a `Plot`: what pages draw. `window` is (x_min, x_max, y_min, y_max)."""

    caption: str
    x_label: str
    y_label: str
    curves: tuple[DrawnCurve, ...]
    marks: tuple[Mark, ...]
    equal: bool
    window: tuple[float, float, float, float]


GAINS = {"K": r"\sym{K}", "L": r"\sym{L}"}
"""What stands in the blocks of the gains where a diagram says nothing else."""


def worded_figure(figure: Figure, say: Callable[[str], str]) -> Figure:
    """Return a figure with its words and symbols as a page says them."""
    if isinstance(figure, Diagram):
        labels = {name: say(label) for name, label in {**GAINS, **figure.labels}.items()}
        return replace(figure, caption=say(figure.caption), labels=labels)
    curves = tuple(replace(curve, label=say(curve.label)) for curve in figure.curves)
    marks = tuple(replace(mark, label=say(mark.label)) for mark in figure.marks)
    caption, x_label, y_label = map(say, (figure.caption, figure.x_label, figure.y_label))
    return replace(figure, caption=caption, x_label=x_label, y_label=y_label, curves=curves, marks=marks)


Drawing = DrawnPlot | Diagram
"""A figure without expressions."""
