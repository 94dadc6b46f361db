"""Drawings made of strokes as SVG (by matplotlib) and as TikZ."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas
from matplotlib.patches import Circle, Polygon

from solver.derivation.mechanisms import Place
from solver.figures.diagrams import CM, EDGE, SCALE, SHIFT
from solver.figures.layout import Dot, Label
from solver.figures.palette import FILL, INK, PAPER, SOFT
from solver.figures.plot_svg import SETTINGS, math, svg_of
from solver.figures.strokes import Line, Ring, Shape, Stroke, bounds_of, direction, moved

LOOKS: dict[str, dict[str, Any]] = {
    "ink": {"color": INK, "linewidth": 1.1},
    "thin": {"color": SOFT, "linewidth": 0.8},
    "rod": {"color": INK, "linewidth": 2.2},
    "dashed": {"color": SOFT, "linewidth": 0.9, "linestyle": (0, (4, 3))},
}
DOT = 0.06
TIKZ = {"ink": "", "thin": "gray, line width=0.4pt", "rod": "line width=1.2pt", "dashed": "gray, dashed"}


def svg(strokes: Sequence[Stroke]) -> str:
    """Return strokes as an SVG document, the same bytes for the same strokes."""
    x_min, x_max, y_min, y_max = bounds_of(strokes)
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=((x_max - x_min) * CM * SCALE, (y_max - y_min) * CM * SCALE))
        axes = canvas.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_xlim(x_min, x_max)
        axes.set_ylim(y_min, y_max)
        axes.axis("off")
        for number, stroke in enumerate(strokes):
            _draw(axes, stroke, 2 + number / len(strokes))
        return svg_of(canvas)


def _draw(axes: Any, stroke: Stroke, order: float) -> None:
    """Draw one stroke above those before it."""
    match stroke:
        case Shape():
            axes.add_patch(Polygon(stroke.points, facecolor=FILL, zorder=order, **EDGE))
        case Ring():
            fill = PAPER if stroke.joint else FILL
            axes.add_patch(Circle(stroke.place, stroke.radius, facecolor=fill, zorder=order, **EDGE))
        case Dot():
            axes.add_patch(Circle((stroke.x, stroke.y), DOT, color=INK, zorder=order))
        case Label() if stroke.text:
            dx, dy, ha, va = SHIFT.get(stroke.anchor, (0, 0, "center", "center"))
            axes.text(stroke.x + dx, stroke.y + dy, math(stroke.text), ha=ha, va=va, zorder=5)
        case Line():
            look = LOOKS[stroke.style]
            xs, ys = zip(*stroke.points, strict=True)
            axes.plot(xs, ys, zorder=order, solid_capstyle="butt", solid_joinstyle="round", **look)
            ends = [stroke.points[::-1]] * (stroke.arrow == "both") + [stroke.points] * bool(stroke.arrow)
            for points in ends:
                back = moved(points[-1], (-0.3, direction(points[-2], points[-1])))
                arrow = {"arrowstyle": "-|>", "color": look["color"], "mutation_scale": 9, "shrinkA": 0, "shrinkB": 0}
                axes.annotate("", xy=points[-1], xytext=back, arrowprops=arrow, zorder=order)


def tikz(strokes: Sequence[Stroke], look: str = "") -> str:
    """Return strokes as a tikzpicture, with options of its own."""
    lines = [_line(stroke) for stroke in strokes]
    begin = rf"\begin{{tikzpicture}}[>=latex, line width=0.6pt{', ' * bool(look)}{look}]"
    return "\n".join([begin, *filter(None, lines), r"\end{tikzpicture}"])


def _line(stroke: Stroke) -> str:
    match stroke:
        case Shape():
            return rf"\draw[fill=black!4] {' -- '.join(map(_at, stroke.points))} -- cycle;"
        case Ring():
            fill = "white" if stroke.joint else "black!4"
            return rf"\draw[fill={fill}] {_at(stroke.place)} circle ({stroke.radius:g});"
        case Dot():
            return rf"\fill {_at((stroke.x, stroke.y))} circle ({DOT:g});"
        case Label():
            side = f"{stroke.anchor}, " if stroke.anchor in SHIFT else ""
            at = _at((stroke.x, stroke.y))
            return rf"\node[{side}inner sep=3pt] at {at} {{${stroke.text}$}};" if stroke.text else ""
        case _:
            head = {"": "", "end": "->", "both": "<->"}[stroke.arrow]
            look = ", ".join(filter(None, (head, TIKZ[stroke.style])))
            return rf"\draw[{look}] {' -- '.join(map(_at, stroke.points))};"


def _at(place: Place) -> str:
    x, y = (round(each, 3) + 0.0 for each in place)
    return f"({x:g},{y:g})"
