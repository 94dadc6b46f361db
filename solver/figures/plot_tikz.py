"""Plots as pgfplots axes, from the same numbers as the SVG."""

from __future__ import annotations

from solver.derivation.figures import DrawnCurve, DrawnPlot
from solver.figures.plot_svg import COLOURS, middle

DASHES = (
    "solid",
    "dash pattern=on 6pt off 2pt",
    "dash pattern=on 2pt off 1.5pt",
    "dash pattern=on 6pt off 2pt on 1pt off 2pt",
)
MARKS = ("*", "square*", "diamond*", "triangle*")
EVERY = 2
"""Paper needs fewer points than a screen that zooms."""


def drawn(plot: DrawnPlot) -> str:
    """Return the plot as a tikzpicture."""
    curves = plot.curves
    x_min, x_max, y_min, y_max = plot.window
    options = [
        f"xmin={x_min:.6g}, xmax={x_max:.6g}, ymin={y_min:.6g}, ymax={y_max:.6g}",
        f"xlabel={{${plot.x_label}$}}, ylabel={{${plot.y_label}$}}",
        "width=8cm, height=8cm, axis equal image" if plot.equal else "width=11cm, height=6.4cm",
        "axis lines=left, grid=major, grid style={black!12}",
        "legend pos=outer north east, legend style={draw=none, fill=none}",
        "scaled ticks=false, tick label style={/pgf/number format/fixed}",
    ]
    names = list(dict.fromkeys(each.label for each in curves if each.label))
    seen: set[str] = set()
    lines = [line for each in curves for line in _curve(each, names, seen)]
    lines += [
        rf"\addplot[only marks, mark size=2pt, forget plot] coordinates {{{_point(m.x, m.y)}}}"
        + (rf" node[above right] {{${m.label}$}};" if m.label else ";")
        for m in plot.marks
    ]
    body = "\n".join(lines)
    colours = "\n".join(rf"\definecolor{{curve{i}}}{{HTML}}{{{c[1:].upper()}}}" for i, c in enumerate(COLOURS))
    axis = f"\\begin{{axis}}[{', '.join(options)}]\n{body}\n\\end{{axis}}"
    return f"\\begin{{tikzpicture}}\n{colours}\n{axis}\n\\end{{tikzpicture}}"


def _point(x: float, y: float) -> str:
    return f"({x:.5g},{y:.5g})"


def _curve(each: DrawnCurve, names: list[str], seen: set[str]) -> list[str]:
    """Return the lines of one curve; the first of those with the same name enters the legend."""
    label = each.label
    place = names.index(label) if label else 0
    colour = f"curve{place % len(COLOURS)}" if label else "black!60"
    if each.style == "samples":
        style = f"{colour}, ycomb, mark={MARKS[place % 4]}, mark size=1.6pt"
    else:
        style = f"{colour}, thick, {'dashed' if each.style == 'dashed' else DASHES[place % 4] if label else 'solid'}"
    if each.style == "arrow" and len(each.x) > 1:
        at = middle(each)
        head = f"{_point(each.x[at - 1], each.y[at - 1])} {_point(each.x[at], each.y[at])}"
        arrow = [rf"\addplot[{colour}, thick, -latex, forget plot] coordinates {{{head}}};"]
    else:
        arrow = []
    points = range(0, len(each.x), 1 if each.style == "samples" else EVERY)
    coordinates = " ".join(_point(each.x[i], each.y[i]) for i in points)
    entry = rf"\addlegendentry{{${label}$}}" if label and label not in seen else ""
    kept = "" if entry else ", forget plot"
    seen.add(label)
    return [rf"\addplot[{style}{kept}] coordinates {{{coordinates}}};{entry}", *arrow]
