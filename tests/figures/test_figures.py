"""Figures: the numbers they draw, the same bytes each time, names told apart, and documents that hold them."""

import re
import subprocess
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
import sympy as sp

from solver import figures
from solver.derivation import Step
from solver.derivation.figures import (
    Chains,
    Curve,
    Diagram,
    Mark,
    Motion,
    Panels,
    Parts,
    Plane,
    Plot,
    Region,
    Roots,
    Signals,
)
from solver.derivation.figures import Part as Box
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.figures import drawing as worded
from solver.figures.layout import Block, Dot, Label, Layout
from solver.figures.layouts import LAYOUTS
from solver.figures.plot_svg import middle
from solver.figures.sampling import sampled
from solver.messages import Messages
from solver.problem.model import Part, Problem
from solver.render import pdf
from solver.render.latex_document import latex_document
from solver.render.markdown import markdown_of
from solver.render.page import render_page
from solver.systems import StateSpace

drawing_of = partial(worded.drawing_of, say=Messages().say)
t, k = sp.symbols("t k")
DECAY = Plot("A decay.", "t", "x(t)", t, 0, 4, (Curve(sp.exp(-t), "x_1"), Curve(1 - sp.exp(-2 * t), r"\dot{x}_2")))
SPIRAL = Plot(
    "A spiral.", "x_1", "x_2", t, -1, 2,
    (Curve(sp.exp(-t) * sp.sin(t), x=sp.exp(-t) * sp.cos(t), style="arrow"),), (Mark(0, 0, "0"),), equal=True,
)  # fmt: skip
SAMPLES = Plot("Samples.", "k", "x(k)", k, 0, 6, (Curve(sp.Rational(1, 2) ** k, "x", style="samples"),))
PULSE = Plot("A pulse.", "t", "u", t, 0, 4, (Curve(sp.Heaviside(t - 1) - sp.Heaviside(t - 2), "u"),), settles=1)
PANELS = Panels("Two panels.", (DECAY, PULSE))
MOTION = Motion(
    "A motion.", sp.Matrix([[0, 1], [-2, -2]]), sp.Matrix([1, 0]), drive=sp.Matrix([0, 2]),
    panels=(
        Signals("y", ("y",), sp.Matrix([[1, 0]]), level=("r", sp.Integer(1))),
        Signals("x", ("x_1", "x_2"), sp.eye(2)),
    ),
)  # fmt: skip
PLANE = Plane("Poles.", (Roots("poles", (-1 + sp.I, -1 - sp.I, -2, -2)), Roots("zeros", (3,), "ring")), stable=True)
REGION = Plane("Region.", (Roots("poles", (-1 + sp.I,), "square"),), region=Region(sp.Rational(1, 2), 1, 2, 1))
CIRCLE = Plane("Circle.", (Roots("poles", (sp.Rational(1, 2),), "diamond"),), discrete=True, stable=True)
CHAIN = Chains("Chain.", ((1, 0),), (("", "1"), ("-2", "-3")), ("", "1"), ("1", "4"), r"\frac{1}{2}")
PARTS = Parts("Parts.", (Box("seen", ("-1",), (0, 0), True, True, (1,)), Box("hidden", ("2",), (0, 1), True, False)))
NUMBERS = Diagram("Numbers.", "observer", {"A": r"\begin{bmatrix}0 & 1\\-2 & -3\end{bmatrix}"})
NEW = {
    "pulse": PULSE, "panels": PANELS, "motion": MOTION, "plane": PLANE, "region": REGION, "circle": CIRCLE,
    "chain": CHAIN, "parts": PARTS, "numbers": NUMBERS,
}  # fmt: skip
ALL = [DECAY, SPIRAL, SAMPLES, *(Diagram("A diagram.", name) for name in LAYOUTS), *NEW.values()]


def test_curves_are_sampled_where_they_are():
    first, second = sampled(DECAY).curves
    assert np.allclose(first.y, np.exp(-np.array(first.x)))
    assert np.allclose(second.y, 1 - np.exp(-2 * np.array(second.x)))
    assert (first.x[0], first.x[-1]) == (0, 4)
    (samples,) = sampled(SAMPLES).curves
    assert list(samples.x) == [0, 1, 2, 3, 4, 5, 6]
    assert np.allclose(samples.y, 0.5 ** np.array(samples.x))


def test_a_curve_is_left_out_where_it_has_no_value():
    (curve,) = sampled(Plot("", "t", "x", t, -1, 1, (Curve(1 / t),))).curves
    assert np.all(np.isfinite(curve.y))
    assert 0.0 not in curve.x


def test_the_window_holds_curves_and_marks():
    plot = Plot("", "t", "x", t, 0, 1, (Curve(t),), (Mark(2, 5),))
    x_min, x_max, y_min, y_max = sampled(plot).window
    assert x_min <= 0 < 2 <= x_max
    assert y_min < 0 < 5 < y_max


def test_an_arrow_stands_half_way_and_points_onward():
    (curve,) = sampled(Plot("", "x", "y", t, 0, 2, (Curve(0 * t, x=t, style="arrow"),))).curves
    assert curve.x[middle(curve)] == pytest.approx(1, abs=0.02)
    assert curve.x[middle(curve)] > curve.x[middle(curve) - 1]


@pytest.mark.parametrize("figure", ALL, ids=lambda figure: getattr(figure, "name", figure.caption))
def test_the_same_data_give_the_same_drawing_without_a_date(figure):
    drawing = figures.svg(drawing_of(figure))
    assert drawing == figures.svg(drawing_of(figure))
    assert drawing.startswith("<svg")
    assert not re.search(r"dc:date|<script|matplotlib v", drawing)
    assert figures.tikz(drawing_of(figure)) == figures.tikz(drawing_of(figure))


@pytest.mark.parametrize("name", LAYOUTS)
def test_no_block_of_a_diagram_lies_on_another(name):
    blocks = [item for item in LAYOUTS[name]({}).items if isinstance(item, Block)]
    for i, a in enumerate(blocks):
        for b in blocks[i + 1 :]:
            apart = abs(a.x - b.x) >= (a.width + b.width) / 2 or abs(a.y - b.y) >= (a.height + b.height) / 2
            assert apart, (a, b)


@pytest.mark.parametrize("name", LAYOUTS)
def test_a_label_stands_on_the_side_that_its_anchor_says(name, monkeypatch):
    layout, written = LAYOUTS[name]({}), []
    monkeypatch.setattr("matplotlib.axes.Axes.text", lambda _, x, y, text, **__: written.append((x, y, text)))
    figures.svg(Diagram("", name))
    for label in (item for item in layout.items if isinstance(item, Label) and item.text):
        places = [(x - label.x, y - label.y) for x, y, text in written if text == f"${label.text}$"]
        right, above = min(places, key=lambda place: abs(place[0]) + abs(place[1]))
        assert (right > 0, right < 0) == ("right" in label.anchor, "left" in label.anchor)
        assert (above > 0, above < 0) == ("above" in label.anchor, "below" in label.anchor)


def test_the_bounds_leave_room_on_every_side():
    layout = Layout([Block(1, 2, "K", 3.0)])
    left, right, below, above = layout.bounds
    assert (left, right) == pytest.approx((1 - 1.5 - 0.15, 1 + 1.5 + 0.15))
    assert below == pytest.approx(4 - above)
    assert above > 2 + layout.items[0].height / 2
    layout.wire((5, 2), (7, -1))
    layout.add(Dot(-4, 6))
    assert layout.bounds == pytest.approx((-4.45, 7.15, -1.15, 6.55))


def test_labels_are_the_ones_given():
    items = LAYOUTS["state_feedback"]({"K": "K_1", "x": r"\xi"}).items
    assert "K_1" in {item.text for item in items if isinstance(item, Block)}
    assert r"\xi" in {item.text for item in items if isinstance(item, Label)}
    assert "$K_1$" in figures.tikz(Diagram("", "state_feedback", {"K": "K_1"}))


@pytest.mark.usefixtures("tex")
def test_the_drawings_compile(tmp_path):
    body = "\n\n".join(figures.tikz(drawing_of(figure)) for figure in ALL)
    head = r"\documentclass{article}\usepackage{amsmath,tikz,pgfplots}\pgfplotsset{compat=1.15}\begin{document}"
    (tmp_path / "all.tex").write_text(head + "\n" + body + "\n" + r"\end{document}", encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "all.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stdout[-2000:]


@pytest.fixture
def plain():
    part = Part("a", "eigenstructure", ("eigenstructure",), StateSpace(sp.ImmutableMatrix([[1, 2], [3, 4]])))
    return solve_problem(Problem("demo", "Demo", (part,)))


def illustrated(part):
    """The same result, with two figures at its last step."""
    last = part.steps[-1]
    step = Step(last.kind, claims=last.claims, figures=(DECAY, Diagram("Loop with $u$.", "servo")), **last.values)
    step.wording = last.wording
    return replace(part, steps=(*part.steps[:-1], step))


@pytest.mark.usefixtures("tex")
def test_a_solution_shows_the_figures_of_its_steps(plain):
    document = document_of(replace(plain, parts=tuple(illustrated(part) for part in plain.parts)))
    html, latex, markdown = render_page(document), latex_document(document), markdown_of(document)
    assert html.count("<figure>") == 2
    assert 'alt="A decay. x₁ from 1 at t = 0 to 0.01832 at t = 4. ẋ₂ from 0 at t = 0 to 0.9997 at t = 4."' in html
    assert 'alt="Loop with u. Boxes: ∫, k_I, B, ∫, A, C, K_f. Signals: r, ' in html
    assert latex.count(r"\begin{tikzpicture}") == 2
    assert r"\usepackage{pgfplots}" in latex
    assert r"\usepackage{tikz}" not in latex_document(document_of(plain))
    assert markdown.count("*Figure") == 2
    assert pdf.pdf_of(latex).startswith(b"%PDF")


def test_axes_have_scales_of_their_own_unless_they_are_to_be_equal():
    assert not Plot("a response", "t", "y", t, 0, 1, ()).equal
