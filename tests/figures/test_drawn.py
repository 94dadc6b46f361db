"""What stands in the drawings, on the screen and on paper: each item of a layout, each curve, in its place and look."""

import io
import re
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from matplotlib import _mathtext
from matplotlib.colors import to_hex
from matplotlib.figure import Figure as Canvas
from matplotlib.patches import Circle, Rectangle
from matplotlib.text import Annotation

from solver import figures
from solver.derivation.figures import Curve, Diagram, DrawnCurve, DrawnPlot, Mark, Plot
from solver.figures import plot_svg
from solver.figures.axis_marks import mark
from solver.figures.drawing import drawing_of
from solver.figures.layout import HEIGHT, RADIUS, Block, Dot, Label, Layout, Sum, Wire
from solver.figures.layouts import LAYOUTS
from solver.figures.palette import dark_style
from solver.figures.plot_svg import middle
from solver.figures.sampling import sampled

t, k = sp.symbols("t k")
NUMBER = r"(-?[\d.e+-]+)"
POINT = rf"\({NUMBER},{NUMBER}\)"


@pytest.fixture
def axes_of(monkeypatch):
    """The axes on which a figure is drawn, with the size of the canvas."""

    def of(figure):
        seen = []
        monkeypatch.setattr(Canvas, "draw", lambda canvas, _: seen.append(canvas))
        figures.svg(figure if isinstance(figure, DrawnPlot) else drawing_of(figure))
        (canvas,) = seen
        (axes,) = canvas.axes
        return axes, canvas.get_size_inches()

    return of


def items(layout, kind):
    return [item for item in layout.items if isinstance(item, kind)]


@pytest.mark.parametrize("name", LAYOUTS)
def test_everything_in_a_layout_is_drawn_where_it_is(name, axes_of):
    layout = LAYOUTS[name]({})
    axes, (width, height) = axes_of(Diagram("", name))
    x_min, x_max, y_min, y_max = layout.bounds
    assert (*axes.get_xlim(), *axes.get_ylim()) == layout.bounds
    assert width / height == pytest.approx((x_max - x_min) / (y_max - y_min))
    boxes = [
        (*each.get_center(), each.get_width(), each.get_height()) for each in axes.patches if type(each) is Rectangle
    ]
    assert boxes == pytest.approx(np.array([(b.x, b.y, b.width, b.height) for b in items(layout, Block)]))
    rings = {(*map(float, each.center), each.radius) for each in axes.patches if isinstance(each, Circle)}
    small = {radius for *_, radius in rings} - {RADIUS}
    assert {(x, y) for x, y, radius in rings if radius == RADIUS} == {(s.x, s.y) for s in items(layout, Sum)}
    assert {(x, y) for x, y, radius in rings if radius in small} == {(d.x, d.y) for d in items(layout, Dot)}
    assert all(radius < RADIUS / 2 for radius in small)
    wires = items(layout, Wire)
    assert [[tuple(map(float, p)) for p in line.get_xydata()] for line in axes.lines] == [list(w.points) for w in wires]
    names = [text.get_text() for text in axes.texts if text.get_text()]
    assert sorted(names) == sorted(f"${i.text}$" for i in items(layout, (Block, Label)) if i.text)
    inside = [(text.get_text(), text._x, text._y) for text in axes.texts]
    assert {(f"${each.text}$", each.x, each.y) for each in items(layout, Block)} <= set(inside)
    for label in (item for item in items(layout, Label) if item.text):
        near = [text for text in axes.texts if text.get_text() == f"${label.text}$"]
        assert min(np.hypot(text._x - label.x, text._y - label.y) for text in near) < 0.1
    assert max(line.zorder for line in axes.lines) < min(each.zorder for each in axes.patches)
    assert max(each.zorder for each in axes.patches) < min(text.zorder for text in axes.texts if text.get_text())


@pytest.mark.parametrize("name", LAYOUTS)
def test_an_arrowhead_lies_on_the_end_of_its_wire_and_points_along_it(name, axes_of):
    axes, _ = axes_of(Diagram("", name))
    heads = [text for text in axes.texts if not text.get_text()]
    wires = [wire for wire in items(LAYOUTS[name]({}), Wire) if wire.arrow]
    assert [tuple(head.xy) for head in heads] == [wire.points[-1] for wire in wires]
    for head, wire in zip(heads, wires, strict=True):
        (x0, y0), (x1, y1) = wire.points[-2:]
        along, back = np.array([x1 - x0, y1 - y0]), np.array([x1 - head.xyann[0], y1 - head.xyann[1]])
        assert along @ back == pytest.approx(np.linalg.norm(along) * np.linalg.norm(back))
        assert np.linalg.norm(back) == pytest.approx(min(0.3, np.linalg.norm(along)))


@pytest.mark.parametrize("name", LAYOUTS)
def test_everything_in_a_layout_is_on_paper_where_it_is(name):
    layout, text = LAYOUTS[name]({}), figures.tikz(Diagram("", name))

    def found(pattern, size):
        return np.array([[float(x) for x in each if x] for each in re.findall(pattern, text)]).reshape(-1, size)

    def placed(kind, *of):
        return np.array([[getattr(item, name) for name in of] for item in items(layout, kind)]).reshape(-1, len(of))

    block = rf"minimum width={NUMBER}cm, minimum height={NUMBER}cm, inner sep=0pt\] at {POINT}"
    assert np.allclose(found(block, 4), placed(Block, "width", "height", "x", "y"))
    ring = rf"circle, fill=white, minimum size={NUMBER}cm, inner sep=0pt\] at {POINT}"
    assert np.allclose(found(ring, 3)[:, 1:], placed(Sum, "x", "y"))
    assert np.allclose(found(ring, 3)[:, 0], 2 * RADIUS)
    assert np.allclose(found(rf"\\fill {POINT} circle", 2), placed(Dot, "x", "y"))
    drawn = re.findall(r"\\draw(\[->\])? (.*);", text)
    points = [tuple((float(x), float(y)) for x, y in re.findall(POINT, path)) for _, path in drawn]
    assert [(p, bool(arrow)) for p, (arrow, _) in zip(points, drawn, strict=True)] == [
        (pytest.approx(np.array(wire.points)), wire.arrow) for wire in items(layout, Wire)
    ]
    for label in items(layout, Label):
        assert f"\\node[{label.anchor}, inner sep=2pt] at ({label.x:g},{label.y:g}) {{${label.text}$}};" in text


def test_a_box_that_only_groups_is_dashed_and_has_no_name(monkeypatch, axes_of):
    boxes = Layout([Block(0, 0, "G", 4.0, 2.0, dashed=True), Block(0, 0, "A")])
    monkeypatch.setitem(LAYOUTS, "grouped", lambda _: boxes)
    axes, _ = axes_of(Diagram("", "grouped"))
    assert [patch.get_linestyle() for patch in axes.patches] == ["--", "-"]
    assert [patch.get_fill() and patch.get_facecolor()[3] > 0 for patch in axes.patches] == [False, True]
    first, second = figures.tikz(Diagram("", "grouped")).split("\n")[1:3]
    assert ("dashed" in first, "fill=" in first, "$" in first) == (True, False, False)
    assert ("dashed" in second, "fill=" in second, "$A$" in second) == (False, True, True)
    assert f"minimum height={HEIGHT:g}cm" in second


class Every(dict):
    """Labels that name each thing by its key."""

    def get(self, key, default):
        return f"<{key}>" if default is not None else None


@pytest.mark.parametrize("name", [name for name in LAYOUTS if name != "state_feedback_reference"])
def test_every_label_can_be_given_by_the_name_of_what_it_stands_for(name):
    shown = {item.text for item in items(LAYOUTS[name](Every()), (Block, Label))} - {"+", "-"}
    assert all(re.fullmatch(r"<\w+>", text) for text in shown)
    known = {
        "A",
        "B",
        "C",
        "J",
        "K",
        "L",
        "M",
        "N",
        "x",
        "y",
        "u",
        "r",
        "k_I",
        "xi",
        "v",
        "w",
        "xidot",
        "xdot",
        "xhat",
        "yhat",
    }
    assert {text[1:-1] for text in shown} <= known | {
        "integrator",
        "error_integrator",
        "plant",
        "compensator",
        "omega",
        "estimate",
    }


GROWTH = Plot(
    "", "t", "y", t, 0, 4,
    (Curve(t, "a"), Curve(2 * t, "b", style="dashed"), Curve(3 * t, "a"), Curve(4 * t), Curve(-t, "c", style="arrow")),
    (Mark(1, 2, "p"), Mark(3, 3)),
)  # fmt: skip


def test_curves_of_one_name_look_alike_and_others_do_not(axes_of):
    axes, _ = axes_of(GROWTH)
    lines = {line.get_ydata()[-1]: line for line in axes.lines if line.get_xdata()[-1] == 4}
    colours = {end: to_hex(line.get_color()) for end, line in lines.items()}
    assert sorted(lines) == [-4, 4, 8, 12, 16]
    assert colours[4] == colours[12]
    assert len(set(colours.values())) == 4
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["$a$", "$b$", "$c$"]
    styles = {end: line._dash_pattern for end, line in lines.items()}
    assert styles[4] == styles[12] == styles[16]
    assert len({styles[end][1] and tuple(styles[end][1]) for end in (4, 8, -4)}) == 3
    text = figures.tikz(drawing_of(GROWTH))
    assert re.findall(r"\\addlegendentry\{\$(\w)\$\}", text) == ["a", "b", "c"]
    every = re.findall(r"\\addplot\[(.*?)\] coordinates \{(.*?)\}", text)
    plots = [(style, points) for style, points in every if not style.startswith("black!40")]
    inks = [style.partition(",")[0] for style, _ in plots]
    assert inks[:6] == ["curve0", "curve1", "curve0", "black!60", "curve2", "curve2"]
    assert ["forget plot" in style for style, _ in plots] == [False, False, True, True, False, True, True, True]
    assert ["-latex" in style for style, _ in plots].index(True) == 5


def test_marks_axes_names_and_the_window_are_drawn(axes_of):
    axes, (width, height) = axes_of(GROWTH)
    x_min, x_max, y_min, y_max = sampled(GROWTH).window
    assert (*axes.get_xlim(), *axes.get_ylim()) == (x_min, x_max, y_min, y_max)
    marks = {tuple(line.get_xydata()[0]) for line in axes.lines if len(line.get_xdata()) == 1}
    assert marks == {(1, 2), (3, 3)}
    texts = [text for text in axes.texts if text.get_text()]
    assert {text.get_text(): text.xy for text in texts if isinstance(text, Annotation)} == {"$p$": (1, 2)}
    numbers = [text.get_text() for text in texts if not isinstance(text, Annotation)]
    assert "0" in numbers
    assert all(min(x_min, y_min) <= float(each.replace("−", "-")) <= max(x_max, y_max) for each in numbers)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("$t$", "$y$")
    assert any(list(line.get_ydata()) == [0, 0] for line in axes.lines)
    assert width > height
    text = figures.tikz(drawing_of(GROWTH))
    assert r"only marks, mark size=2pt, forget plot] coordinates {(1,2)} node[above right] {$p$};" in text
    assert r"coordinates {(3,3)};" in text
    window = dict(re.findall(rf"([xy]m(?:in|ax))={NUMBER}", text))
    assert [float(window[name]) for name in ("xmin", "xmax", "ymin", "ymax")] == pytest.approx(
        [x_min, x_max, y_min, y_max]
    )


def test_the_marks_of_axes_are_those_that_matplotlib_makes(monkeypatch):
    def seen_with(marking):
        drawn_axes = []
        monkeypatch.setattr(plot_svg, "mark", lambda every: (marking(every), drawn_axes.extend(every)))
        for plot in (GROWTH, Plot("", "t", "y", t, 0, 3, (Curve(12345678 + 1000 * t),))):
            plot_svg.drawn(sampled(plot))
        return drawn_axes

    own, theirs = seen_with(mark), seen_with(lambda _: None)
    for mine, plain in zip(own, theirs, strict=True):
        numbers = [each.get_text() for each in mine.texts if not isinstance(each, Annotation)]
        listed = [
            each.label1.get_text()
            for axis in (plain.xaxis, plain.yaxis)
            for each in axis.get_major_ticks()
            if axis.get_view_interval()[0] <= each.get_loc() <= axis.get_view_interval()[1]
        ]
        offsets = [axis.get_major_formatter().get_offset() for axis in (plain.xaxis, plain.yaxis)]
        assert sorted(numbers) == sorted([*listed, *filter(None, offsets)])
        for axis, other in ((mine.xaxis, plain.xaxis), (mine.yaxis, plain.yaxis)):
            place = axis.label.get_window_extent().p0
            assert place == pytest.approx(other.label.get_window_extent().p0, abs=0.6)  # points


@pytest.mark.parametrize(("low", "high", "axis"), [(-1, 1, True), (0, 1, False), (1, 2, False), (-2, 0, False)])
def test_the_axis_of_the_ordinate_is_drawn_where_it_is_inside(axes_of, low, high, axis):
    axes, _ = axes_of(Plot("", "t", "y", t, low, high, (Curve(t + 3),)))
    upright = [line for line in axes.lines if list(line.get_xdata()) == [0, 0]]
    assert bool(upright) is axis


def test_samples_stand_on_stems(axes_of):
    plot = Plot("", "k", "y", k, 0, 3, (Curve(k + 1, "a", style="samples"), Curve(-k, "b", style="samples")))
    axes, _ = axes_of(plot)
    assert [stem.tolist() for stem in axes.collections[0].get_segments()] == [[[i, 0], [i, i + 1]] for i in range(4)]
    assert len({line.get_marker() for line in axes.lines if len(line.get_xdata()) == 4}) == 2
    text = figures.tikz(drawing_of(plot))
    assert "coordinates {(0,1) (1,2) (2,3) (3,4)}" in text
    assert re.findall(r"ycomb, mark=([a-z*]+)", text) == ["*", "square*"]


def test_a_curve_through_states_has_one_scale_and_its_arrow_half_way(axes_of):
    plot = Plot("", "x", "y", t, 0, 3, (Curve(t**2, x=3 * t, style="arrow"),), equal=True)
    axes, (width, height) = axes_of(plot)
    (curve,) = sampled(plot).curves
    (head,) = [text for text in axes.texts if not text.get_text()]
    at = curve.x.index(head.xy[0])
    lengths = [np.hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(zip(curve.x, curve.y, strict=True))]
    assert sum(lengths[:at]) == pytest.approx(sum(lengths) / 2, abs=max(lengths))
    assert (head.xy, head.xyann) == ((curve.x[at], curve.y[at]), (curve.x[at - 1], curve.y[at - 1]))
    assert width == height
    assert axes.get_aspect() == 1
    text = figures.tikz(drawing_of(plot))
    assert "axis equal image" in text
    assert f"({curve.x[at - 1]:.5g},{curve.y[at - 1]:.5g}) ({curve.x[at]:.5g},{curve.y[at]:.5g})" in text


@pytest.mark.parametrize(("points", "heads"), [((1.0,), 0), ((1.0, 2.0), 1)])
def test_a_curve_needs_two_points_for_an_arrowhead(axes_of, points, heads):
    plot = DrawnPlot("", "x", "y", (DrawnCurve("a", "arrow", points, points),), (), False, (0.0, 3.0, 0.0, 3.0))
    axes, _ = axes_of(plot)
    assert len([text for text in axes.texts if not text.get_text()]) == heads
    assert figures.tikz(plot).count("-latex") == heads


@pytest.mark.parametrize(("x", "at"), [((0.0, 1.0), 1), ((0.0, 1.0, 9.0, 10.0), 2), ((3.0, 3.0, 3.0), 1)])
def test_the_middle_of_a_few_points_is_one_of_them(x, at):
    assert middle(DrawnCurve("", "arrow", x, tuple(0.0 for _ in x))) == at
    assert middle(DrawnCurve("", "arrow", tuple(0.0 for _ in x), x)) == at


@pytest.mark.parametrize(
    ("plot", "window"),
    [
        (Plot("", "t", "y", t, 0, 2, (Curve(t + 1),)), (0, 2, -0.21, 3.21)),
        (Plot("", "t", "y", t, 0, 2, (Curve(-t - 1),)), (0, 2, -3.21, 0.21)),
        (Plot("", "t", "y", t, 0, 2, (Curve(0 * t),)), (0, 2, -0.07, 0.07)),
        (Plot("", "x", "y", t, 0, 2, (Curve(t, x=10 * t),), equal=True), (-1, 21, -0.14, 2.14)),
        (Plot("", "x", "y", t, 0, 2, (Curve(t, x=0 * t),), equal=True), (-0.05, 0.05, -0.14, 2.14)),
        (Plot("", "t", "y", t, 0, 2, (), window=(0, 1, 2, 3)), (0, 1, 2, 3)),
        (Plot("", "t", "y", t, 0, 2, ()), (0, 1, -0.07, 0.07)),
    ],
)
def test_the_window_is_a_little_larger_than_what_is_in_it(plot, window):
    assert sampled(plot).window == pytest.approx(window)


def test_values_beyond_all_bounds_are_left_out():
    (curve,) = sampled(Plot("", "t", "y", t, 0, 2, (Curve(10**6 * t, x=t),))).curves
    assert 0 < max(curve.x) < 1
    (curve,) = sampled(Plot("", "t", "y", t, 0, 2, (Curve(t, x=-(10**6) * t),))).curves
    assert 0 < max(curve.y) < 1


def test_bounds_have_room_for_names():
    layout = Layout([Label(1, 2, "x")])
    assert layout.bounds == pytest.approx((1 - 0.45, 1 + 0.45, 2 - 0.55, 2 + 0.55))


def test_it_is_written_as_matplotlib_writes_it(monkeypatch):
    def saved(canvas):
        content = io.StringIO()
        canvas.savefig(content, format="svg", metadata={"Date": None, "Creator": None})
        return content.getvalue()

    drawn = drawing_of(Plot("", r"\omega", "y", t, 0, 3, (Curve(sp.sin(t), "a"), Curve(t, "b"))))
    ours = figures.svg(drawn)
    monkeypatch.setattr(plot_svg, "svg_of", saved)
    theirs = figures.svg(drawn)
    assert ours.replace(dark_style(), "") == theirs[theirs.index("<svg") :]


def test_formulas_are_set_once_for_all_figures(monkeypatch):
    drawn = drawing_of(Plot("", r"\alpha\ \text{of a wing}", "y", t, 0, 3, (Curve(sp.sin(t)),)))
    first = figures.svg(drawn)
    monkeypatch.setattr(_mathtext.Parser, "parse", lambda *_: pytest.fail("set anew"))
    assert figures.svg(drawn) == first
