"""The block diagrams of the course, each from one layout, as SVG (by matplotlib) and as TikZ."""

from __future__ import annotations

from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas
from matplotlib.patches import Circle, Rectangle

from solver.derivation.figures import Chains, Diagram, Parts
from solver.derivation.flow_figures import FlowGraph
from solver.figures.laid_out import layout_of
from solver.figures.layout import RADIUS, Block, Dot, Item, Label, Sum, Wire
from solver.figures.matrices import LINE, entries_of, widths_of
from solver.figures.palette import FILL, INK, PAPER
from solver.figures.plot_svg import SETTINGS, svg_of

CM = 1 / 2.54
SCALE = 1.15
EDGE: dict[str, Any] = {"edgecolor": INK, "linewidth": 1.1}


def svg(diagram: Diagram | Chains | Parts | FlowGraph) -> str:
    """Return the diagram as an SVG document, the same bytes for the same labels."""
    layout = layout_of(diagram)
    x_min, x_max, y_min, y_max = layout.bounds
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=((x_max - x_min) * CM * SCALE, (y_max - y_min) * CM * SCALE))
        axes = canvas.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_xlim(x_min, x_max)
        axes.set_ylim(y_min, y_max)
        axes.axis("off")
        for item in layout.items:
            _draw(axes, item)
        return svg_of(canvas)


SHIFT = {
    "above": (0, 0.08, "center", "bottom"),
    "below": (0, -0.08, "center", "top"),
    "left": (-0.08, 0, "right", "center"),
    "right": (0.08, 0, "left", "center"),
    "above left": (-0.06, 0.06, "right", "bottom"),
    "above right": (0.06, 0.06, "left", "bottom"),
    "below left": (-0.06, -0.06, "right", "top"),
    "below right": (0.06, -0.06, "left", "top"),
}


def _draw(axes: Any, item: Item) -> None:
    """Draw one item of the layout."""
    match item:
        case Block():
            corner = (item.x - item.width / 2, item.y - item.height / 2)
            style = "--" if item.dashed else "-"
            fill = "none" if item.dashed else FILL
            axes.add_patch(
                Rectangle(corner, item.width, item.height, facecolor=fill, linestyle=style, zorder=2, **EDGE)
            )
            if entries := entries_of(item.text):
                _matrix(axes, item, entries)
            elif item.text:
                axes.text(item.x, item.y, f"${item.text}$", ha="center", va="center", zorder=3)
        case Sum():
            axes.add_patch(Circle((item.x, item.y), RADIUS, facecolor=PAPER, zorder=2, **EDGE))
        case Dot():
            axes.add_patch(Circle((item.x, item.y), 0.06, color=INK, zorder=2))
        case Label() if item.text:
            dx, dy, ha, va = SHIFT[item.anchor]
            axes.text(item.x + dx, item.y + dy, f"${item.text}$", ha=ha, va=va, zorder=3)
        case Wire():
            xs, ys = zip(*item.points, strict=True)
            axes.plot(xs, ys, color=INK, linewidth=1.1, zorder=1, solid_capstyle="butt", solid_joinstyle="miter")
            if item.arrow:
                arrow = {"arrowstyle": "-|>", "color": INK, "mutation_scale": 10, "shrinkA": 0, "shrinkB": 0}
                axes.annotate("", xy=item.points[-1], xytext=_before(item.points), arrowprops=arrow)


def _matrix(axes: Any, block: Block, entries: list[list[str]]) -> None:
    """Write a matrix into a box, between brackets."""
    widths = widths_of(entries)
    left, top = block.x - sum(widths) / 2, block.y + LINE * len(entries) / 2
    for i, row in enumerate(entries):
        for j, entry in enumerate(row):
            x = left + sum(widths[:j]) + widths[j] / 2
            axes.text(x, top - LINE * (i + 0.5), f"${entry}$", ha="center", va="center", zorder=3)
    for side in (1, -1):
        x, foot = block.x + side * sum(widths) / 2, block.y - LINE * len(entries) / 2
        xs, ys = (x - 0.08 * side, x, x, x - 0.08 * side), (top, top, foot, foot)
        axes.plot(xs, ys, color=INK, linewidth=0.9, zorder=3)


def _before(points: tuple[tuple[float, float], ...]) -> tuple[float, float]:
    """A point shortly before the end of a wire."""
    (x0, y0), (x1, y1) = points[-2:]
    length = max(abs(x1 - x0) + abs(y1 - y0), 1e-9)
    near = min(1.0, 0.3 / length)
    return (x1 - (x1 - x0) * near, y1 - (y1 - y0) * near)


def tikz(diagram: Diagram | Chains | Parts | FlowGraph) -> str:
    """Return the diagram as a tikzpicture."""
    lines = [_line(item) for item in layout_of(diagram).items]
    return "\n".join([r"\begin{tikzpicture}[>=latex, line width=0.6pt]", *lines, r"\end{tikzpicture}"])


def _line(item: Item) -> str:
    match item:
        case Block():
            dashed, fill = (", dashed", "") if item.dashed else ("", ", fill=black!4")
            text = "" if item.dashed else f"${item.text}$"
            size = f"minimum width={item.width:g}cm, minimum height={item.height:g}cm, inner sep=0pt"
            return rf"\node[draw{dashed}{fill}, {size}] at ({item.x:g},{item.y:g}) {{{text}}};"
        case Sum():
            size = f"minimum size={2 * RADIUS:g}cm, inner sep=0pt"
            return rf"\node[draw, circle, fill=white, {size}] at ({item.x:g},{item.y:g}) {{}};"
        case Dot():
            return rf"\fill ({item.x:g},{item.y:g}) circle (0.06);"
        case Label():
            return rf"\node[{item.anchor}, inner sep=2pt] at ({item.x:g},{item.y:g}) {{${item.text}$}};"
        case _:
            path = " -- ".join(f"({x:g},{y:g})" for x, y in item.points)
            return rf"\draw{'[->]' if item.arrow else ''} {path};"
