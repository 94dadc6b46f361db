"""Diagrams of Bode and Nyquist: values, steep and lightly damped curves, SVG and TikZ alike, told in words."""

import numpy as np
import pytest
import sympy as sp

from solver import exact, figures
from solver.figures.drawing import drawing_of
from solver.figures.responses import factors_at
from solver.messages import Messages
from solver.tasks.frequency.figures import bode_figure, nyquist_figures, response_of

s = sp.Symbol("s")
say = Messages().say


def on_axis(N, D, T=0):
    return exact.on_axis(sp.expand(sp.sympify(N)), sp.expand(D), s, sp.sympify(T))


LOOPS = [
    on_axis(10, s * (s + 1) * (s + 5)),
    on_axis(5 * (s**2 + 4), s * (s + 1) * (s**2 + 9)),
    on_axis(3, s + 1, 2),
    on_axis(2000 * (s + 1), s**2 * (s + 20) * (s**2 + s / 5 + 100)),
    on_axis(10**6, s * (s + 1) * (s + 1000)),
]


@pytest.mark.parametrize("L", LOOPS)
def test_curves_are_those_of_the_loop(L):
    (figure,) = bode_figure("A diagram.", ("L", L), margins=exact.margins_of(L), asymptotes=True)
    magnitudes, phases = drawing_of(figure, say).plots
    assert magnitudes.logarithmic
    assert phases.logarithmic
    curve = next(each for each in magnitudes.curves if each.label == "L")
    value = sp.lambdify(s, L.N.as_expr() / L.D.as_expr(), "numpy")
    wanted = 20 * np.log10(np.abs(value(1j * np.array(curve.x))))
    assert np.allclose(curve.y, wanted, atol=1e-6)


def test_a_sharp_resonance_is_seen():
    L = LOOPS[3]
    (figure,) = bode_figure("A diagram.", ("L", L))
    magnitudes, _ = drawing_of(figure, say).plots
    (curve,) = (each for each in magnitudes.curves if each.style == "line")
    near = [y for x, y in zip(curve.x, curve.y, strict=True) if 9 < x < 11]
    top = 20 * np.log10(abs(complex(L.N.as_expr().subs(s, 10j) / L.D.as_expr().subs(s, 10j))))
    assert abs(max(near) - top) < 0.3


def test_curves_break_at_poles_on_the_axis():
    (figure,) = bode_figure("A diagram.", ("L", LOOPS[1]))
    _, phases = drawing_of(figure, say).plots
    lines = [each for each in phases.curves if each.style == "line"]
    assert len(lines) == 3  # a zero at 2, a pole at 3
    assert lines[0].x[-1] < 2 < lines[1].x[0] < lines[1].x[-1] < 3 < lines[2].x[0]


def test_half_turns_at_infinity_are_drawn():
    (figure,) = nyquist_figures("A diagram.", "Near.", LOOPS[3], [])
    plot = drawing_of(figure, say)
    (arc,) = (each for each in plot.curves if each.style == "arc")
    angle = np.unwrap(np.arctan2(arc.y, arc.x))
    assert abs(angle[-1] - angle[0] + 2 * np.pi) < 1e-9  # two half turns, clockwise
    assert any(each.style == "cross" and each.x == (-1.0,) for each in plot.curves)


def test_curves_far_from_minus_one_are_shown_near_it_too():
    L = on_axis(50, (s + 1) ** 3)
    crossings = [value for _, value in exact.phase_crossovers(L).real_axis]
    assert len(nyquist_figures("A diagram.", "Near.", L, crossings)) == 2
    assert len(nyquist_figures("A diagram.", "Near.", LOOPS[0], [sp.Rational(-1, 3)])) == 1


@pytest.mark.parametrize("L", LOOPS)
def test_both_formats_are_drawn_alike_each_time_and_told(L):
    crossings = [value for _, value in exact.phase_crossovers(L).real_axis]
    made = (*bode_figure("B.", ("L", L), margins=exact.margins_of(L)), *nyquist_figures("N.", "Near.", L, crossings))
    for figure in made:
        drawing = drawing_of(figure, say)
        assert figures.svg(drawing) == figures.svg(drawing)
        assert r"\begin{axis}" in figures.tikz(drawing)
        assert "marked: ω = " in drawing.alt.lower() or "mirror image" in drawing.alt
        assert "nan" not in figures.tikz(drawing)


def test_phases_are_continuous_beyond_half_a_turn():
    _, angle = factors_at(response_of(LOOPS[0]), np.array([1e-3, 1e3]))
    assert abs(angle[0] + 90) < 1
    assert abs(angle[1] + 270) < 1
