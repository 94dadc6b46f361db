"""Compensators and PID controllers on generated loops: margins and closed loops by python-control."""

import warnings

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask
from tests.helpers.tried import tried
from tests.tasks.test_model_matching import plant

s = sp.Symbol("s")
TIME_CONSTANTS = st.lists(st.fractions(1, 8, max_denominator=4), min_size=1, max_size=3)


def transfer(expression):
    """A transfer function of python-control."""
    above, below = sp.fraction(sp.together(expression))
    return control.tf(*([float(c) for c in sp.Poly(p, s).all_coeffs()] for p in (above, below)))


def margins(C, G):
    """Gain margin, phase margin, crossovers of C G, and whether the loop is stable, by python-control."""
    L = transfer(C * G.matrix[0, 0])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        _, pm, _, wg = control.margin(L)
    return pm, wg, bool(np.all(control.feedback(L, 1).poles().real < 0))


def loop(poles, gain):
    G = sp.Integer(gain) / (s * sp.Mul(*(s + sp.Rational(p) for p in poles)))
    return plant(*sp.fraction(sp.together(G)))


@pytest.mark.parametrize("task", ["lead_compensator", "lag_compensator", "lead_lag_compensator"])
@tried(10)
@given(poles=TIME_CONSTANTS, gain=st.integers(1, 20), constant=st.integers(1, 30), wanted=st.integers(30, 60))
def test_what_is_asked_is_so_by_python_control(task, poles, gain, constant, wanted):
    G = loop(poles, gain)
    result = ask(task, G, velocity_constant=sp.Integer(constant), phase_margin=sp.Integer(wanted))
    assert result.status is not Status.FAILED
    if result.status is Status.UNSOLVED:
        return
    C = result.answers["controller"]
    pm, wg, stable = margins(C, G)
    assert stable
    assert pm == pytest.approx(float(result.answers["phase_margin"]), abs=1e-4)
    assert wg == pytest.approx(float(result.answers["gain_crossover"]), rel=1e-5)
    assert pm >= wanted - 1e-6
    assert abs(control.dcgain(transfer(s * C * G.matrix[0, 0])) - constant) < 1e-8 * constant


@tried(12)
@given(poles=st.lists(st.integers(1, 6), min_size=3, max_size=4), gain=st.integers(1, 6))
def test_the_ultimate_gain_is_the_gain_margin(poles, gain):
    D = sp.Mul(*(s + p for p in poles))
    result = ask("pid_tuning", plant(sp.Integer(gain), D), "ziegler_nichols_ultimate", controller_type="PID")
    assert result.status is Status.VERIFIED, result.reason
    gm, _, wp, _ = control.margin(transfer(gain / D))
    assert float(result.answers["K_u"]) == pytest.approx(gm, rel=1e-6)
    assert float(result.answers["T_u"]) == pytest.approx(2 * np.pi / wp, rel=1e-6)


@tried(10)
@given(poles=st.lists(st.integers(1, 5), min_size=2, max_size=4), gain=st.integers(1, 6))
def test_the_tangent_is_that_of_a_simulated_step_response(poles, gain):
    D = sp.Mul(*(s + p for p in poles))
    result = ask("pid_tuning", plant(sp.Integer(gain), D), "ziegler_nichols_step", controller_type="PID")
    assert result.status is Status.VERIFIED, result.reason
    t, y = control.step_response(transfer(gain / D), np.linspace(0, 12, 60_001))
    slope = np.gradient(y, t)
    i = int(np.argmax(slope))
    L = t[i] - y[i] / slope[i]
    assert float(result.answers["K_p"]) == pytest.approx(1.2 / (slope[i] * L), rel=2e-3)
    assert float(result.answers["K_p"] / result.answers["K_i"]) == pytest.approx(2 * L, rel=2e-3)
