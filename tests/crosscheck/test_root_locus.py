"""Root loci against python-control and numpy on generated loops: branches, meetings, crossings, stability."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from solver import exact
from solver.derivation.parameter_figures import Locus
from solver.figures.loci import on_locus

control = pytest.importorskip("control")
s = sp.Symbol("s")

factors = st.one_of(
    st.integers(-5, 2).map(lambda a: s - a),
    st.tuples(st.integers(-3, 1), st.integers(1, 4)).map(lambda pair: sp.expand((s - pair[0]) ** 2 + pair[1] ** 2)),
)
loops = st.tuples(
    st.lists(factors, max_size=2).map(sp.prod),
    st.lists(factors, min_size=1, max_size=4).map(sp.prod),
    st.sampled_from([1, 3, -1]),
).filter(lambda loop: sp.degree(loop[0], s) <= sp.degree(loop[1], s) and not sp.cancel(loop[1] / loop[0]).is_number)


def equation_of(loop):
    N, D, lead = loop
    return exact.locus_equation(sp.expand(lead * N), sp.expand(D), s)


def plant_of(equation):
    return control.tf(*([float(c) for c in p.all_coeffs()] for p in (equation.numerator, equation.denominator)))


def figure_of(equation):
    lines = exact.asymptotes(equation)
    return Locus(
        "", tuple(equation.numerator.all_coeffs()), tuple(equation.denominator.all_coeffs()), "K",
        lines.centroid if lines else None, lines.angles if lines else (),
        tuple((each.point.value, each.gain) for each in exact.meetings(equation) if each.belongs and each.gain),
        tuple((each.point, each.gain) for each in exact.crossings(equation)),
    )  # fmt: skip


@settings(max_examples=25, deadline=None)
@given(loops)
def test_branches_pass_through_the_roots_of_python_control(loop):
    equation = equation_of(loop)
    assume(equation.denominator.degree() > 0)
    plot = on_locus(figure_of(equation))
    side = plot.window[1] - plot.window[0]
    pieces = [np.array(c.x) + 1j * np.array(c.y) for c in plot.curves if "branches" in c.label]
    dense = np.concatenate([np.interp(np.linspace(0, len(p) - 1, 40 * len(p)), range(len(p)), p) for p in pieces])
    gains = np.geomspace(1e-2, 1e3, 60)
    loci = control.root_locus_map(plant_of(equation), gains=gains).loci
    inside = [
        z for z in loci.flatten()
        if plot.window[0] < z.real < plot.window[1] and plot.window[2] < z.imag < plot.window[3]
    ]  # fmt: skip
    assert all(np.min(np.abs(dense - z)) < 0.01 * side for z in inside)


@settings(max_examples=25, deadline=None)
@given(loops)
def test_stability_is_that_of_the_closed_loops_of_python_control(loop):
    equation = equation_of(loop)
    assume(equation.denominator.degree() > 0 and equation.common.degree() == 0)
    plant = plant_of(equation)
    for each in exact.stable_gains(equation):
        low = float(each.low)
        gain = low + 0.37 * ((float(each.high) if each.high != sp.oo else low + 2) - low)
        poles = control.feedback(gain * plant).poles()
        assert np.sum(poles.real > 1e-5) == each.outside
        assert np.sum(np.abs(poles.real) <= 1e-5) == each.on


@settings(max_examples=25, deadline=None)
@given(loops)
def test_closed_loops_have_multiple_poles_where_branches_meet(loop):
    equation = equation_of(loop)
    assume(equation.denominator.degree() > 0)
    N, D = (np.array([float(c) for c in p.all_coeffs()]) for p in (equation.numerator, equation.denominator))
    for each in exact.meetings(equation):
        if each.belongs:
            roots = np.roots(np.polyadd(D, float(each.gain) * N))
            near = np.sort(np.abs(roots - complex(each.point.value)))
            assert near[each.branches - 1] < 10 * 1e-15 ** (1 / each.branches) * (10 + abs(roots).max())


@settings(max_examples=25, deadline=None)
@given(loops)
def test_gain_margins_of_python_control_are_critical_gains(loop):
    equation = equation_of(loop)
    assume(equation.denominator.degree() > 0 and not exact.on_boundary(equation).eliminated.is_zero)
    corners = [
        complex(each)
        for p in (equation.numerator, equation.denominator)
        for each in np.roots([float(c) for c in p.all_coeffs()])
    ]
    assume(all(abs(each.real) > 1e-6 for each in corners if each.imag))  # it takes poles on the axis for crossings
    margins, _, _, frequencies, _, _ = control.stability_margins(plant_of(equation), returnall=True)
    ours = [(float(sp.im(each.point)), float(each.gain)) for each in exact.crossings(equation)]
    for gain, omega in zip(margins, frequencies, strict=True):
        if np.isfinite(gain) and gain > 1e-6 and omega > 1e-6:
            assert any(abs(w - omega) < 1e-4 * (1 + w) and abs(k - gain) < 1e-3 * (1 + k) for w, k in ours)
