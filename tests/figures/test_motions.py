"""Motions and responses as drawn: numbers from scipy, breaks, equal curves, what is marked."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from solver.derivation.figures import Curve, Motion, Panels, Plot, Signals
from solver.figures.drawing import drawing_of
from solver.figures.motions import moved
from solver.figures.sampling import sampled
from tests.helpers.asking import ask, system

t = sp.Symbol("t")
A, B = sp.ImmutableMatrix([[0, 1], [-4, -2]]), sp.ImmutableMatrix([0, 4])
STATES = Signals("x", ("x_1", "x_2"), sp.eye(2))


def test_a_motion_is_that_of_an_integrator_by_steps():
    figure = Motion("", A, sp.ImmutableMatrix([1, -1]), (STATES,), drive=B)
    (panel,) = moved(figure).plots
    M, b = np.array(A, dtype=float), np.array(B, dtype=float)[:, 0]
    stop = panel.window[1]
    solved = solve_ivp(lambda _, z: M @ z + b, (0, stop), [1, -1], dense_output=True, rtol=1e-10, atol=1e-12)
    for i, curve in enumerate(panel.curves):
        assert np.allclose(curve.y, solved.sol(np.array(curve.x))[i], atol=1e-6)
        between = np.linspace(0, stop, 500)
        assert np.allclose(np.interp(between, curve.x, curve.y), solved.sol(between)[i], atol=2e-3)


def test_a_motion_in_discrete_time_has_its_samples():
    A = sp.ImmutableMatrix([[sp.Rational(1, 2), 1], [0, sp.Rational(-1, 4)]])
    (panel,) = moved(Motion("", A, sp.ImmutableMatrix([1, 1]), (STATES,), discrete=True)).plots
    x = np.array([1.0, 1.0])
    for k in range(10):
        assert [curve.y[k] for curve in panel.curves] == pytest.approx(list(x))
        x = np.array(A, dtype=float) @ x
    assert {curve.style for curve in panel.curves} == {"samples"}


def test_a_level_is_drawn_beside_the_curves():
    y = Signals("y", ("y",), sp.ImmutableMatrix([[1, 0]]), level=("r", sp.Integer(1)))
    panels = drawing_of(Motion("", A, sp.ImmutableMatrix([0, 0]), (y,), drive=B))
    level, curve = panels.plots[0].curves
    assert (level.style, level.label, set(level.y)) == ("guide", "r", {1.0})
    assert curve.y[-1] == pytest.approx(1, abs=0.02)
    assert "Marked: r = 1." in panels.alt


def test_the_edges_of_a_pulse_are_upright_and_its_kinks_exact():
    step = sp.Heaviside
    pulse, ramp = step(t - 1) - step(t - 3), (t - 1) * step(t - 1) - (t - 3) * step(t - 3)
    flat, bent = sampled(Plot("", "t", "u", t, 0, 4, (Curve(pulse, "u"), Curve(ramp, "r")))).curves
    assert np.allclose(list(zip(flat.x, flat.y, strict=True)), [(0, 0), (1, 0), (1, 1), (3, 1), (3, 0), (4, 0)])
    corners = dict(zip(bent.x, bent.y, strict=True))
    assert {1.0, 3.0} <= set(corners)
    assert np.interp(2.5, bent.x, bent.y) == pytest.approx(1.5)


def test_what_happens_quickly_is_not_lost():
    (curve,) = sampled(Plot("", "t", "y", t, 0, 10, (Curve(sp.exp(-2000 * t) - sp.exp(-t)),))).curves
    lowest = np.log(2000) / 1999
    assert min(curve.y) == pytest.approx(np.exp(-2000 * lowest) - np.exp(-lowest), abs=1e-3)
    assert curve.x[int(np.argmin(curve.y))] == pytest.approx(lowest, abs=1e-3)


def test_equal_curves_are_one_line_with_both_names():
    plot = sampled(Plot("", "t", "", t, 0, 1, (Curve(t, "x_1"), Curve(2 * t, "x_2"), Curve(2 * t, "y"))))
    assert [each.label for each in plot.curves] == ["x_1", "x_2 = y"]


@pytest.fixture(scope="module")
def output():
    """The panel of y in the step response of 4/(s\u00b2 + 2s + 4)."""
    result = ask("response", system(A, B=B, C=[[1, 0]]), kind="zero_state", input=(sp.Integer(1),))
    (figure,) = [each for step in result.steps for each in step.figures]
    assert isinstance(figure, Panels)
    return sampled(figure.plots[0])


def test_a_step_response_shows_its_final_value_its_peak_and_when_it_settles(output):
    marked = {each.label: each for each in output.curves if each.style == "guide"}
    assert set(marked[r"y_{\infty}"].y) == {1.0}
    assert marked[r"t_{\text{peak}}"].x[0] == pytest.approx(np.pi / np.sqrt(3))
    wd = np.sqrt(3)
    at = np.linspace(0, 8, 200001)
    y = 1 - np.exp(-at) * (np.cos(wd * at) + np.sin(wd * at) / wd)
    settled = at[np.nonzero(np.abs(y - 1) > 0.02)[0][-1]]
    assert marked["t_{s}"].x[0] == pytest.approx(settled, abs=0.01)
    (band,) = [each for each in output.curves if each.style == "area"]
    assert sorted(set(band.y)) == pytest.approx([0.98, 1.02])
    (peak,) = output.marks
    assert (peak.x, peak.y) == pytest.approx((np.pi / wd, 1 + np.exp(-np.pi / wd)))
    assert r"= 16.3\,\%" in peak.label
