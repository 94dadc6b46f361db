"""Circuits as SVG (by schemdraw on matplotlib) and as TikZ (by circuitikz), from one layout."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure as Canvas

from solver.derivation.figures import Schematic
from solver.figures.circuit_layout import layout_of
from solver.figures.laid_circuits import Amplifier, CircuitLayout, Placed, Point
from solver.figures.palette import INK, SOFT
from solver.figures.plot_svg import SETTINGS, svg_of

SCALE = 0.42
"""Inches a unit."""
BESIDE = 0.34
"""How far from its axis the label of a component stands."""
WIDE = 0.26
"""What a source or a capacitor is wider."""
SHAPES = {
    "R": "Resistor", "L": "Inductor", "C": "Capacitor", "V": "SourceV", "I": "SourceI",
    "E": "SourceControlledV", "H": "SourceControlledV", "G": "SourceControlledI", "F": "SourceControlledI",
}  # fmt: skip
TIKZ = {
    "R": "R", "L": "L", "C": "C", "V": "american voltage source", "I": "american current source",
    "E": "american controlled voltage source", "H": "american controlled voltage source",
    "G": "american controlled current source", "F": "american controlled current source",
}  # fmt: skip


def svg(schematic: Schematic) -> str:
    """Return the circuit as an SVG document, the same bytes for the same circuit; empty where it has no layout."""
    layout = layout_of(schematic)
    if layout is None:
        return ""
    x_min, x_max, y_min, y_max = bounds_of(layout)
    with mpl.rc_context(SETTINGS):
        canvas = Canvas(figsize=((x_max - x_min) * SCALE, (y_max - y_min) * SCALE))
        axes = canvas.add_axes((0.0, 0.0, 1.0, 1.0))
        _draw(axes, layout)
        axes.set_xlim(x_min, x_max)
        axes.set_ylim(y_min, y_max)
        axes.set_aspect("equal")
        axes.axis("off")
        return svg_of(canvas)


def bounds_of(layout: CircuitLayout) -> tuple[float, float, float, float]:
    """Return x_min, x_max, y_min, y_max of the drawing, with room for labels."""
    points = [p for each in layout.placed for p in (each.start, each.end)]
    points += [p for wire in layout.wires for p in wire] + [each.output for each in layout.amplifiers]
    xs, ys = zip(*points, strict=True)
    return min(xs) - 1.2, max(xs) + 1.9, min(ys) - 0.9, max(ys) + 1.1


def _draw(axes: Any, layout: CircuitLayout) -> None:
    """Draw everything on matplotlib's axes."""
    from schemdraw import Drawing, elements  # noqa: PLC0415 - only where a circuit is drawn

    drawing = Drawing(canvas=axes, show=False)
    drawing.config(color=INK, lw=1.1, fontsize=10.5, unit=2.0)
    for each in layout.placed:
        shape = getattr(elements, SHAPES[each.component.letter])
        ends = (each.end, each.start) if each.component.letter in "VEH" else (each.start, each.end)
        drawing.add(shape().endpoints(*ends))  # of a source of voltage the plus is at the end
    for wire in layout.wires:
        for start, end in pairwise(wire):
            drawing.add(elements.Line().at(start).to(end))
    for dot in layout.dots:
        drawing.add(elements.Dot(radius=0.06).at(dot))
    for ground in layout.grounds:
        drawing.add(elements.Ground().at(ground))
    for terminal in layout.terminals:
        drawing.add(elements.Dot(radius=0.09, open=True).at(terminal.place))
    drawing.draw(show=False)
    for amplifier in layout.amplifiers:
        _triangle(axes, amplifier)
    for place, anchor, text, colour in labels_of(layout):
        horizontal, vertical = {"above": ("center", "bottom"), "right": ("left", "center"), "left": ("right", "bottom"),
                                "centre": ("center", "center"), "before": ("right", "center"),
                                "behind": ("left", "bottom")}[anchor]  # fmt: skip
        axes.text(*place, f"${text}$", ha=horizontal, va=vertical, color=INK if colour else SOFT,
                  fontsize=10.5 if colour else 8.5)  # fmt: skip


def _triangle(axes: Any, amplifier: Amplifier) -> None:
    """The triangle of an amplifier with the signs of its inputs."""
    (x, top), (_, low), tip = amplifier.upper, amplifier.lower, amplifier.output
    xs, ys = [x, x, tip[0], x], [top + 0.5, low - 0.5, tip[1], top + 0.5]
    axes.plot(xs, ys, color=INK, linewidth=1.1, solid_joinstyle="miter")


def labels_of(layout: CircuitLayout) -> list[tuple[Point, str, str, bool]]:
    """Return the labels: where, on which side of that, what, and whether it is more than the name of a node."""
    found = [_label(each) for each in layout.placed]
    for each in layout.amplifiers:
        (x, top), (_, low), tip = each.upper, each.lower, each.output
        signs = ("-", "+") if each.minus_above else ("+", "-")
        found += [((x + 0.28, top), "centre", signs[0], True), ((x + 0.28, low), "centre", signs[1], True)]
        if each.component.label:
            found.append(((x + 0.85, tip[1]), "centre", each.component.label, True))
    found += [((x + (0.2 if each.right else -0.2), y), "right" if each.right else "before", each.label, True)
              for each in layout.terminals for x, y in [each.place]]  # fmt: skip
    found += [((x + 0.1, y + 0.12), "behind", label, True) for (x, y), label in layout.voltages]
    found += [((x - 0.1, y + 0.08), "left", name_of_node(name), False) for (x, y), name in layout.names]
    return found


def name_of_node(name: str) -> str:
    """Return the name of a node as LaTeX."""
    return name if name.isdigit() else r"\mathrm{" + name.replace("_", r"\_") + "}"


def _label(each: Placed) -> tuple[Point, str, str, bool]:
    (x0, y0), (x1, y1) = each.start, each.end
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    beside = BESIDE + (0 if each.component.letter in "RL" else WIDE)
    if y0 == y1:
        return (x, y + beside), "above", each.component.label, True
    return (x + beside, y), "right", each.component.label, True


def tikz(schematic: Schematic) -> str:
    """Return the circuit as a tikzpicture; empty where it has no layout."""
    layout = layout_of(schematic)
    if layout is None:
        return ""
    lines = [rf"\draw {_at(each.start)} to[{TIKZ[each.component.letter]}] {_at(each.end)};" for each in layout.placed]
    lines += [rf"\draw {' -- '.join(map(_at, wire))};" for wire in layout.wires]
    lines += [rf"\fill {_at(dot)} circle (0.06);" for dot in layout.dots]
    lines += [rf"\node[ground] at {_at(place)} {{}};" for place in layout.grounds]
    lines += [rf"\draw[fill=white] {_at(each.place)} circle (0.08);" for each in layout.terminals]
    for each in layout.amplifiers:
        (x, top), (_, low), tip = each.upper, each.lower, each.output
        corners = (x, top + 0.5), (x, low - 0.5), tip
        lines.append(rf"\draw {' -- '.join(map(_at, corners))} -- cycle;")
    for place, anchor, text, plain in labels_of(layout):
        side = {
            "above": "above, ",
            "right": "right, ",
            "left": "above left, ",
            "centre": "",
            "before": "left, ",
            "behind": "above right, ",
        }[anchor]
        size = "" if plain else ", gray, font=\\scriptsize"
        lines.append(rf"\node[{side}inner sep=1pt{size}] at {_at(place)} {{${text}$}};")
    return "\n".join([r"\begin{tikzpicture}[scale=0.85, line width=0.6pt]", *lines, r"\end{tikzpicture}"])


def _at(point: Point) -> str:
    return f"({point[0]:g},{point[1]:g})"
