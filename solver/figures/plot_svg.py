"""Plots as SVG, by matplotlib; no date, no random names: the same bytes for the same plot."""

from __future__ import annotations

import io
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure as Canvas

from solver.derivation.figures import DrawnCurve, DrawnPlot

COLOURS = ("#1f5fa8", "#c2410c", "#15803d", "#7e22ce", "#a16207", "#0e7490", "#be123c", "#4d4d4d")
"""Dark enough on white to be told apart; each curve also has its label at its end."""

DASHES = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (6, 2, 1.5, 2)))
WIDTH, HEIGHT, SQUARE = 6.4, 3.6, 5.0
SETTINGS: Any = {
    "svg.hashsalt": "solve",
    "svg.fonttype": "path",
    "font.size": 10.5,
    "mathtext.fontset": "stix",
    "font.family": "STIXGeneral",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e3e3e3",
    "grid.linewidth": 0.7,
    "axes.axisbelow": True,
}


def drawn(plot: DrawnPlot) -> str:
    """Return the plot as an SVG document."""
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=(SQUARE, SQUARE) if plot.equal else (WIDTH, HEIGHT), layout="constrained")
        axes = canvas.add_subplot()
        x_min, x_max, y_min, y_max = plot.window
        named = _draw_curves(axes, plot.curves)
        for mark in plot.marks:
            axes.plot([mark.x], [mark.y], "o", color="#111111", markersize=4.5, zorder=4)
            if mark.label:
                axes.annotate(_math(mark.label), (mark.x, mark.y), textcoords="offset points", xytext=(6, 6))
        axes.set_xlim(x_min, x_max)
        axes.set_ylim(y_min, y_max)
        if plot.equal:
            axes.set_aspect("equal", adjustable="box")
        if y_min < 0 < y_max:
            axes.axhline(0, color="#777777", linewidth=0.8, zorder=1)
        if x_min < 0 < x_max:
            axes.axvline(0, color="#777777", linewidth=0.8, zorder=1)
        axes.set_xlabel(_math(plot.x_label))
        axes.set_ylabel(_math(plot.y_label))
        if named:
            axes.legend(frameon=False, loc="best")
        return _svg(canvas)


def _draw_curves(axes: Any, curves: tuple[DrawnCurve, ...]) -> bool:
    """Draw the curves, each named one in a colour and dash of its own; return whether any has a name."""
    names = list(dict.fromkeys(each.label for each in curves if each.label))
    for each in curves:
        place = names.index(each.label) if each.label else 0
        colour = COLOURS[place % len(COLOURS)] if each.label else "#5b7083"
        dash = DASHES[place % len(DASHES)] if each.label else "-"
        first = each.label and each is next(c for c in curves if c.label == each.label)
        label = _math(each.label) if first else None
        if each.style == "samples":
            axes.vlines(each.x, 0, each.y, color=colour, linewidth=0.9)
            axes.plot(each.x, each.y, "osD^"[place % 4], color=colour, markersize=4.5, label=label)
            continue
        line = (0, (4, 3)) if each.style == "dashed" else dash
        axes.plot(each.x, each.y, linestyle=line, color=colour, linewidth=1.6, label=label)
        if each.style == "arrow" and len(each.x) > 1:
            _arrowhead(axes, each, colour)
    return bool(names)


def _arrowhead(axes: Any, each: DrawnCurve, colour: str) -> None:
    """An arrowhead half way along the curve, in the direction of rising parameter."""
    tip = middle(each)
    axes.annotate(
        "",
        xy=(each.x[tip], each.y[tip]),
        xytext=(each.x[tip - 1], each.y[tip - 1]),
        arrowprops={"arrowstyle": "-|>", "color": colour, "mutation_scale": 11, "shrinkA": 0, "shrinkB": 0},
    )


def middle(curve: DrawnCurve) -> int:
    """Return the index of the point half way along a curve, where an arrowhead stands."""
    steps = np.hypot(np.diff(curve.x), np.diff(curve.y))
    way = np.concatenate([[0.0], np.cumsum(steps)])
    return max(int(np.searchsorted(way, way[-1] / 2)), 1)


def _math(latex: str) -> str:
    return f"${latex}$" if latex else ""


def _svg(canvas: Canvas) -> str:
    content = io.StringIO()
    canvas.savefig(content, format="svg", metadata={"Date": None, "Creator": None})
    return trimmed(content.getvalue())


def trimmed(document: str) -> str:
    """Return an SVG document without what stands before its element, and without empty descriptions."""
    return document[document.index("<svg") :]
