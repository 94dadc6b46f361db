"""Plots as SVG, by matplotlib; no date, no random names: the same bytes for the same plot."""

from __future__ import annotations

import io
import re
from itertools import pairwise
from math import ceil, floor, log, log10
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_svg import RendererSVG
from matplotlib.figure import Figure as Canvas
from matplotlib.textpath import text_to_path

from solver.derivation.figures import DrawnCurve, DrawnPanels, DrawnPlot, Mark
from solver.figures.axis_marks import mark
from solver.figures.palette import AREA, COLOURS, GRID, INK, PAPER, SIGNS, SOFT, dark_style
from solver.figures.room import BELOW, POINTS, give_room

DASHES = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (6, 2, 1.5, 2)))
LINES: dict[str, Any] = {"dashed": (0, (4, 3)), "dashed arrow": (0, (4, 3)), "arc": (0, (1, 1.5))}
ARROWS = {"arrow", "dashed arrow", "arc", "jumps"}
UNNAMED = {"guide", "area", "span"}
"""What is not in the legend."""

WORDS, NUMBER = re.compile(r"\\text\{([^{}\\$]*)\}"), re.compile(r"-?\d+(?:\.\d+)?")

PLAIN = 4
"""Powers of ten up to this one are written out."""

WIDTH, HEIGHT, SQUARE, LOW = 6.4, 3.6, 4.6, 2.3
SETTINGS: Any = {
    "svg.hashsalt": "solve",
    "svg.fonttype": "path",
    "figure.dpi": 72,  # that of SVG: texts are measured once
    "font.size": 10.5,
    "mathtext.fontset": "stix",
    "font.family": "STIXGeneral",
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "figure.facecolor": PAPER,
    "axes.facecolor": PAPER,
    "axes.spines.top": False,
    "axes.spines.right": False,
}


def drawn(plot: DrawnPlot) -> str:
    """Return the plot as an SVG document."""
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=(SQUARE, SQUARE) if plot.equal else (WIDTH, HEIGHT))
        axes = canvas.add_subplot()
        give_room(canvas, [_draw(axes, plot)])
        mark([axes])
        return svg_of(canvas)


def drawn_panels(panels: DrawnPanels) -> str:
    """Return plots below each other as an SVG document; their abscissas are one above the other."""
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=(WIDTH, LOW * len(panels.plots)))
        every = canvas.subplots(len(panels.plots), 1, sharex=True, squeeze=False)[:, 0]
        legends = [_draw(axes, plot) for axes, plot in zip(every, panels.plots, strict=True)]
        for upper, _ in pairwise(every):
            upper.set_xlabel("")
        give_room(canvas, legends)
        mark(list(every))
        return svg_of(canvas)


def _draw(axes: Any, plot: DrawnPlot) -> str:
    """Draw a plot; return where its legend is: "below" the axes, "beside" or within them ("")."""
    x_min, x_max, y_min, y_max = plot.window
    if y_min < 0 < y_max:
        axes.axhline(0, color=SOFT, linewidth=0.8, zorder=1)
    if x_min < 0 < x_max:
        axes.axvline(0, color=SOFT, linewidth=0.8, zorder=1)
    named = _draw_curves(axes, plot)
    for each in plot.marks:
        if each.sign == "dot":
            axes.plot([each.x], [each.y], "o", color=INK, markersize=4.5, zorder=4)
        _name(axes, each, plot)
    if plot.logarithmic:
        _logarithmic(axes, plot)
    if plot.y_step:
        axes.set_yticks(ticks(plot))
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(y_min, y_max)
    if plot.equal:
        axes.set_aspect("equal", adjustable="box")
    axes.set_xlabel(math(plot.x_label))
    axes.set_ylabel(math(plot.y_label))
    if named and any(each.style in SIGNS for each in plot.curves):
        axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=min(BELOW, named))
        return "below"
    if plot.logarithmic and named:
        axes.legend(frameon=False, loc="lower left")
    elif named > 1 or (named and names_of(plot.curves) != [plot.y_label]):
        axes.legend(frameon=False, loc="center left", bbox_to_anchor=(1.0, 0.5))
        return "beside"
    return ""


def _logarithmic(axes: Any, plot: DrawnPlot) -> None:
    """A logarithmic abscissa with a tick for each decade, and finer lines between."""
    axes.set_xscale("log")
    first, last = round(log10(plot.window[0])), round(log10(plot.window[1]))
    every = range(first, last + 1)
    axes.set_xticks([10.0**k for k in every], [f"{10.0**k:g}" if abs(k) <= PLAIN else f"$10^{{{k}}}$" for k in every])
    axes.set_xticks([], minor=True)
    fine = [i * 10.0**k for k in every[:-1] for i in range(2, 10)]
    axes.vlines(fine, 0, 1, transform=axes.get_xaxis_transform(), color=GRID, linewidth=0.35, zorder=0.4)


def ticks(plot: DrawnPlot) -> list[float]:
    """Return the multiples of the step of the ordinate within the window."""
    _, _, low, high = plot.window
    return [plot.y_step * k for k in range(ceil(low / plot.y_step), floor(high / plot.y_step) + 1)]


def _name(axes: Any, mark: Mark, plot: DrawnPlot) -> None:
    """Write the name of a point beside it, on the side where there is room."""
    if mark.label:
        right, up = side_of(mark.x, mark.y, plot)
        axes.annotate(
            math(mark.label), (mark.x, mark.y), textcoords="offset points", xytext=(6 * right, 6 * up),
            ha="left" if right > 0 else "right", va="bottom" if up > 0 else "top", zorder=5,
        )  # fmt: skip


def side_of(x: float, y: float, plot: DrawnPlot) -> tuple[int, int]:
    """Return on which side of a point its name has room: 1 or −1 for right or left, above or below."""
    x_min, x_max, y_min, y_max = plot.window
    if plot.logarithmic:
        x, x_min, x_max = log(x), log(x_min), log(x_max)
    return (-1 if x - x_min > 0.8 * (x_max - x_min) else 1), (-1 if y - y_min > 0.9 * (y_max - y_min) else 1)


def names_of(curves: tuple[DrawnCurve, ...]) -> list[str]:
    """Return the names in the legend, in order."""
    return list(dict.fromkeys(each.label for each in curves if each.label and each.style not in UNNAMED))


def _draw_curves(axes: Any, plot: DrawnPlot) -> int:
    """Draw the curves, each named one in a colour and dash of its own; return how many have a name."""
    names = names_of(plot.curves)
    for each in plot.curves:
        if each.style == "area":
            axes.fill(each.x, each.y, facecolor=AREA, edgecolor="none", zorder=0.5)
        elif each.style == "guide":
            axes.plot(each.x, each.y, linestyle=(0, (4, 3)), color=SOFT, linewidth=0.9, zorder=1.5)
            _name(axes, Mark(each.x[-1], each.y[-1], each.label), plot)
        elif each.style == "span":
            axes.plot(each.x, each.y, color=COLOURS[1], linewidth=2.2, solid_capstyle="butt", zorder=3)
            _name(axes, Mark(*halfway(each), each.label), plot)
        else:
            _draw_curve(axes, each, names, first=each is next(c for c in plot.curves if c.label == each.label))
    return len(names)


def _draw_curve(axes: Any, each: DrawnCurve, names: list[str], *, first: bool) -> None:
    place = names.index(each.label) if each.label else 0
    colour = COLOURS[place % len(COLOURS)] if each.label else SOFT
    label = math(each.label) if first and each.label else None
    if each.style in SIGNS:
        hollow = {
            "markerfacecolor": "none",
            "markeredgewidth": 1.8,
            "markersize": 8.5 if each.style != "square" else 10,
        }
        axes.plot(each.x, each.y, SIGNS[each.style], color=colour, label=label, zorder=3, **hollow)
    elif each.style == "samples":
        axes.vlines(each.x, 0, each.y, color=colour, linewidth=0.9)
        axes.plot(each.x, each.y, "osD^"[place % 4], color=colour, markersize=4.5, label=label)
    else:
        line = LINES.get(each.style) or (DASHES[place % len(DASHES)] if each.label else "-")
        width = 0.8 if each.style == "jumps" else 1.0 if each.style == "arc" else 1.6
        axes.plot(each.x, each.y, linestyle=line, color=colour, linewidth=width, label=label)
        if each.style == "jumps":
            axes.plot(each.x, each.y, "o", color=colour, markersize=4)
        if each.style in ARROWS and len(each.x) > 1:
            _arrowhead(axes, each, colour)


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


def halfway(curve: DrawnCurve) -> tuple[float, float]:
    """Return the middle of a stretch."""
    return (curve.x[0] + curve.x[-1]) / 2, (curve.y[0] + curve.y[-1]) / 2


def math(latex: str) -> str:
    """Return a label as matplotlib reads it; words and numbers alone are no formulas, which take long to be read."""
    if alone := WORDS.fullmatch(latex):
        return alone[1]
    if NUMBER.fullmatch(latex):
        return latex.replace("-", "−")
    return f"${latex}$" if latex else ""


def svg_of(canvas: Canvas) -> str:
    """Return a canvas as an SVG element, with its colours for the dark and without what stands before it."""
    content = io.StringIO()
    canvas.set_dpi(POINTS)
    width, height = (POINTS * side for side in canvas.get_size_inches())
    write: Any = RendererSVG
    renderer = write(width, height, content, metadata={"Date": None, "Creator": None})
    renderer._text2path = text_to_path  # which knows the formulas of earlier figures: to set them takes longest
    canvas.draw(renderer)
    renderer.finalize()
    document = content.getvalue()
    begin = document.index("<svg")
    end = document.find(">", begin) + 1
    return document[begin:end] + dark_style() + document[end:] if end else document[begin:]
