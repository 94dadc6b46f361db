"""Plots as pgfplots axes, from the same numbers as the SVG."""

from __future__ import annotations

from solver.derivation.figures import DrawnCurve, DrawnPanels, DrawnPlot, Mark
from solver.figures.palette import COLOURS, SIGNS
from solver.figures.plot_svg import ARROWS, halfway, middle, names_of, side_of, ticks

DASHES = (
    "solid",
    "dash pattern=on 6pt off 2pt",
    "dash pattern=on 2pt off 1.5pt",
    "dash pattern=on 6pt off 2pt on 1pt off 2pt",
)
LINES = {"dashed": "dashed", "dashed arrow": "dashed", "arc": "densely dotted"}
MARKS = ("*", "square*", "diamond*", "triangle*")
ROOTS = {"cross": "x", "ring": "o", "square": "square", "diamond": "diamond"}
SIZE = {True: "width=8cm, height=8cm, axis equal image", False: "width=11cm, height=6.4cm"}
LOW = 4.4
"""The height of a panel, in centimetres."""


def drawn(plot: DrawnPlot) -> str:
    """Return the plot as a tikzpicture."""
    return _picture(_axis(plot, [SIZE[plot.equal]]))


def drawn_panels(panels: DrawnPanels) -> str:
    """Return plots below each other as one tikzpicture."""
    size = f"width=11cm, height={LOW}cm"
    last = len(panels.plots) - 1
    axes = [
        _axis(plot, [size, f"at={{(0cm,{-i * (LOW - 0.7):g}cm)}}"], named=i == last)
        for i, plot in enumerate(panels.plots)
    ]
    return _picture("\n".join(axes))


def _picture(body: str) -> str:
    colours = "\n".join(rf"\definecolor{{curve{i}}}{{HTML}}{{{c[1:].upper()}}}" for i, c in enumerate(COLOURS))
    return f"\\begin{{tikzpicture}}\n{colours}\n{body}\n\\end{{tikzpicture}}"


def _axis(plot: DrawnPlot, place: list[str], *, named: bool = True) -> str:
    x_min, x_max, y_min, y_max = plot.window
    signs = any(each.style in SIGNS for each in plot.curves)
    options = [
        f"xmin={x_min:.6g}, xmax={x_max:.6g}, ymin={y_min:.6g}, ymax={y_max:.6g}",
        f"xlabel={{{f'${plot.x_label}$' if named else ''}}}, ylabel={{{f'${plot.y_label}$' if plot.y_label else ''}}}",
        *place,
        "axis lines=left, grid=major, grid style={black!12}",
        "legend cell align=left",
        # Below the label of the abscissa, however low the axes are.
        "legend style={draw=none, fill=none, at={(xticklabel cs:0.5,1.7em)}, anchor=north}" if signs
        else "legend pos=south west, legend style={draw=none, fill=none}" if plot.logarithmic
        else "legend pos=outer north east, legend style={draw=none, fill=none}",
        "scaled ticks=false, tick label style={/pgf/number format/fixed}",
        "clip=false" if _all_inside(plot) else "clip mode=individual",
    ]  # fmt: skip
    if plot.logarithmic:
        options += ["xmode=log", "xminorgrids=true", "minor grid style={black!6}"]
    if plot.y_step:
        options.append(f"ytick={{{','.join(f'{each:g}' for each in ticks(plot))}}}")
    names = names_of(plot.curves)
    seen = {""} if names != [plot.y_label] else {"", plot.y_label}
    lines = [*_zero_lines(plot), *(line for each in plot.curves for line in _curve(each, names, seen, plot))]
    lines += [_mark(mark, plot) for mark in plot.marks]
    body = "\n".join(lines)
    return f"\\begin{{axis}}[{', '.join(options)}]\n{body}\n\\end{{axis}}"


def _all_inside(plot: DrawnPlot) -> bool:
    """Whether nothing has to be cut off, so that names may stand at the edge."""
    x_min, x_max, y_min, y_max = plot.window
    return all(
        x_min <= x <= x_max and y_min <= y <= y_max for each in plot.curves for x, y in zip(each.x, each.y, strict=True)
    )


def _zero_lines(plot: DrawnPlot) -> list[str]:
    """The axes through the origin, where it is inside."""
    x_min, x_max, y_min, y_max = plot.window
    ends = []
    if y_min < 0 < y_max:
        ends.append(f"{_point(x_min, 0)} {_point(x_max, 0)}")
    if x_min < 0 < x_max:
        ends.append(f"{_point(0, y_min)} {_point(0, y_max)}")
    return [rf"\addplot[black!40, thin, forget plot] coordinates {{{each}}};" for each in ends]


def _mark(mark: Mark, plot: DrawnPlot) -> str:
    dots = "only marks, mark size=2pt" if mark.sign == "dot" else "draw=none"
    name = rf" node[{_side(mark.x, mark.y, plot)}] {{${mark.label}$}};" if mark.label else ";"
    return rf"\addplot[{dots}, forget plot] coordinates {{{_point(mark.x, mark.y)}}}{name}"


def _side(x: float, y: float, plot: DrawnPlot) -> str:
    right, up = side_of(x, y, plot)
    return f"{'above' if up > 0 else 'below'} {'right' if right > 0 else 'left'}"


def _point(x: float, y: float) -> str:
    return f"({x:.5g},{y:.5g})"


def _curve(each: DrawnCurve, names: list[str], seen: set[str], plot: DrawnPlot) -> list[str]:
    """Return the lines of one curve; the first of those with the same name enters the legend."""
    label = each.label
    coordinates = " ".join(_point(x, y) for x, y in zip(each.x, each.y, strict=True))
    if each.style == "area":
        return [rf"\addplot[draw=none, fill=black!8, forget plot] coordinates {{{coordinates}}} \closedcycle;"]
    if each.style == "guide":
        name = rf" node[{_side(each.x[-1], each.y[-1], plot)}] {{${label}$}};" if label else ";"
        return [rf"\addplot[black!55, thin, densely dashed, forget plot] coordinates {{{coordinates}}}{name}"]
    if each.style == "span":
        (x, y), side = halfway(each), _side(*halfway(each), plot)
        name = rf"\addplot[draw=none, forget plot] coordinates {{{_point(x, y)}}} node[{side}] {{${label}$}};"
        return [rf"\addplot[curve1, line width=1.6pt, forget plot] coordinates {{{coordinates}}};", name]
    place = names.index(label) if label else 0
    colour = f"curve{place % len(COLOURS)}" if label else "black!60"
    arrow = []
    if each.style in ROOTS:
        outline = "mark size=3.5pt, mark options={line width=1.2pt, fill=none}"
        style = f"{colour}, only marks, mark={ROOTS[each.style]}, {outline}"
    elif each.style == "samples":
        style = f"{colour}, ycomb, mark={MARKS[place % 4]}, mark size=1.6pt"
    elif each.style == "jumps":
        style = f"{colour}, very thin, mark=*, mark size=1.3pt"
    else:
        line = LINES.get(each.style) or (DASHES[place % 4] if label else "solid")
        style = f"{colour}, {'thin' if each.style == 'arc' else 'thick'}, {line}"
    if each.style in ARROWS and len(each.x) > 1:
        at = middle(each)
        head = f"{_point(each.x[at - 1], each.y[at - 1])} {_point(each.x[at], each.y[at])}"
        arrow = [rf"\addplot[{colour}, thick, -latex, forget plot] coordinates {{{head}}};"]
    entry = rf"\addlegendentry{{${label}$}}" if label not in seen else ""
    kept = "" if entry else ", forget plot"
    seen.add(label)
    return [rf"\addplot[{style}{kept}] coordinates {{{coordinates}}};{entry}", *arrow]
