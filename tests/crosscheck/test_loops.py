"""Errors of loops and step responses at samples against python-control and scipy: generated loops in s and in z.

python-control has no error constants: its loop is closed by `feedback` with every factor a system of its own, its
poles tell whether it is stable, and its simulation what remains.
"""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import TransferFunction
from tests.helpers.asking import ask
from tests.helpers.comparing import systems_tried

s, z, t, k = sp.symbols("s z t k")
ONE = sp.Integer(1)
T = sp.Rational(1, 4)
FRACTIONS = st.integers(-3, 3).map(lambda n: sp.Rational(n, 4))
GAINS = st.sampled_from([sp.Rational(n, d) for n in (1, 2, 3, 5) for d in (1, 2, 8)])
RATES = st.integers(1, 5)
TYPES = st.integers(0, 3)


def plant(G, x):
    top, bottom = (sp.Poly(each, x).as_expr() for each in sp.fraction(sp.together(G)))
    matrix = sp.ImmutableMatrix([[sp.cancel(G)]])
    discrete = x == z
    return TransferFunction(matrix, ((top,),), ((bottom,),), x, discrete=discrete, sample_time=T if discrete else None)


def theirs(element, x):
    """The same transfer function in python-control."""
    top, bottom = ([float(c) for c in sp.Poly(p, x).all_coeffs()] for p in sp.fraction(sp.together(element)))
    return control.tf(top, bottom, float(T)) if x == z else control.tf(top, bottom)


def closed(C, G, H, x):
    """From the reference and the disturbance to the output, nothing cancelled; None where the loop is ill-posed."""
    c, g, h = (theirs(each, x) for each in (C, G, H))
    if x == z and abs(1 + np.real((c * g * h)(1e12))) < 1e-6:
        return None
    return control.feedback(c * g, h), control.feedback(g, c * h)


def outermost(loop, discrete):
    """How far the slowest pole is from where it would not settle, positive inside."""
    poles = loop.poles()
    return min(1 - np.abs(poles)) if discrete else min(-poles.real)


def remaining(loops, signals, discrete, rate):
    """R − y late in a simulation of both signals, and half way."""
    times = np.arange(int(60 / rate) + 40) * float(T) if discrete else np.linspace(0, 30 / rate, 6001)
    e = np.zeros(len(times))
    for number, (loop, power) in enumerate(zip(loops, signals, strict=True)):
        if power is not None:
            f = times**power / (2 if power == 2 else 1)
            e += (f if number == 0 else 0) - control.forced_response(loop, times, f).outputs
    return e[-1], e[len(e) // 2]


def constants(C, G, H, x):
    """Type, K_p, K_v, K_a by the values of L beside the point of constant signals."""
    point, unit = (1, float(T)) if x == z else (0, 1.0)
    L = theirs(C, x) * theirs(G, x) * theirs(H, x)
    near = 1e-4
    found = [np.real((near / unit) ** n * L(point + near)) for n in range(3)]
    nearer = [np.real((near / 2 / unit) ** n * L(point + near / 2)) for n in range(3)]
    return found, nearer


def compare(C, G, H, x, power, disturbed):
    """Ask for the error, and compare with the simulation."""
    discrete = x == z
    loops = closed(C, G, H, x)
    if loops is None:
        return
    margin = outermost(loops[0], discrete)
    if abs(margin) < (2e-3 if discrete else 2e-2):
        return
    kT = k * T if discrete else t
    result = ask(
        "steady_state_error", plant(G, x), "final_value", reference=kT**power / sp.factorial(power),
        disturbance=ONE if disturbed else None, controller=C, feedback=H,
    )  # fmt: skip
    assert (result.status is Status.VERIFIED) == (margin > 0), result.reason
    if margin < 0:
        assert "not stable" in str(result.reason)
        return
    late, half = remaining(loops, (power, 0 if disturbed else None), discrete, margin)
    e = result.answers["error"]
    if e in (sp.oo, -sp.oo):
        assert abs(late) > 1.3 * abs(half)
        assert (late > 0) == (e == sp.oo)
    else:
        assert late == pytest.approx(float(e), rel=1e-3, abs=1e-4)
    compare_constants(result.answers, constants(C, G, H, x))


def compare_constants(answers, values):
    """The constants beside the values of L near the point."""
    for n, name in enumerate(("position_constant", "velocity_constant", "acceleration_constant")):
        near, nearer = values[0][n], values[1][n]
        K = answers[name]
        assert (answers["system_type"] > n) == (K in (sp.oo, -sp.oo))
        if K in (sp.oo, -sp.oo):
            assert abs(nearer) > 1.5 * abs(near)
            assert (near > 0) == bool(K > 0)
        else:
            assert 2 * nearer - near == pytest.approx(float(K), rel=1e-2, abs=1e-2)


@systems_tried(40)
@given(
    st.lists(FRACTIONS, min_size=1, max_size=2),
    TYPES,
    st.lists(FRACTIONS, max_size=3),
    GAINS,
    st.sampled_from([ONE, 1 / z, sp.Rational(1, 2), (2 * z - 1) / (2 * z)]),
    st.integers(0, 2),
    st.booleans(),
)
def test_errors_of_discrete_loops(poles, integrators, zeros, gain, H, power, disturbed):
    """Types 0 to 3; with as many zeros near one as integrators, so that some are stable."""
    near = [sp.Rational(3, 4), sp.Rational(7, 8)][: max(integrators - 1, 0)]
    C = gain * sp.Mul(*(z - each for each in near)) / (z - 1) ** len(near)
    G = sp.Mul(*(z - each for each in zeros[: len(poles)])) / (sp.Mul(*(z - p for p in poles)))
    G = G / (z - 1) if integrators else G
    compare(sp.cancel(C) if not near else C, G, H, z, power, disturbed)


@systems_tried(40)
@given(
    st.lists(RATES, min_size=1, max_size=2),
    TYPES,
    st.lists(RATES, max_size=2),
    st.integers(1, 12),
    st.sampled_from([ONE, 1 / (s + 5), sp.Rational(1, 2), (s + 2) / (s + 3)]),
    st.integers(0, 2),
    st.booleans(),
)
def test_errors_of_continuous_loops(poles, integrators, zeros, gain, H, power, disturbed):
    """The same in s."""
    near = [sp.Rational(1, 2), sp.Rational(1, 3)][: max(integrators - 1, 0)]
    C = gain * sp.Mul(*(s + each for each in near)) / s ** len(near)
    G = sp.Mul(*(s + each for each in zeros[: len(poles) - 1])) / sp.Mul(*(s + p for p in poles))
    compare(C, G / s if integrators else G, H, s, power, disturbed)


@systems_tried(30)
@given(
    st.lists(FRACTIONS, min_size=1, max_size=3),
    st.lists(FRACTIONS, max_size=2),
    GAINS,
    st.sampled_from(["2%", "5%"]),
    st.booleans(),
)
def test_specifications_of_step_responses_at_samples(poles, zeros, gain, band, in_loop):
    """Python-control's peak is the largest |y|, its overshoot is counted in %."""
    G = gain * sp.Mul(*(z - each for each in zeros[: len(poles) - 1])) / sp.Mul(*(z - p for p in poles))
    options = {"settling_band": band, "rise": "10-90", "overshoot_in": "fraction"}
    path = sp.cancel(G / (1 + G)) if in_loop else G
    other = theirs(path, z)
    if min(1 - np.abs(other.poles())) < 0.02:
        return
    result = ask("step_specifications", plant(path, z), "response", **options)
    assert result.status is Status.VERIFIED, result.reason
    ours = {name: float(value) for name, value in result.answers.items()}
    times = np.arange(int(ours["settling_time"] / float(T)) * 3 + 60) * float(T)
    y = control.step_response(other, times).outputs
    final = ours["final_value"]
    info = control.step_info(
        y, times, yfinal=final, SettlingTimeThreshold=float(band[:-1]) / 100, RiseTimeLimits=(0.1, 0.9)
    )
    edges = abs(abs(y / final - 1) - float(band[:-1]) / 100)
    assert final == pytest.approx(float(np.real(control.dcgain(other))), rel=1e-9)
    assert info["Overshoot"] / 100 == pytest.approx(ours["overshoot"], abs=1e-9)
    if min(edges) > 1e-9:
        assert info["SettlingTime"] == pytest.approx(ours["settling_time"], abs=1e-9)
    levels = np.minimum(abs(y / final - 0.1), abs(y / final - 0.9))
    if min(levels) > 1e-9:
        assert info["RiseTime"] == pytest.approx(ours["rise_time"], abs=1e-9)
    if ours["overshoot"] > 1e-9 and y[np.argmax(np.abs(y))] * final > 0:
        assert info["PeakTime"] == pytest.approx(ours["peak_time"], abs=1e-9)


@systems_tried(20)
@given(st.lists(FRACTIONS, min_size=1, max_size=3), st.lists(FRACTIONS, max_size=2), GAINS)
def test_poles_zeros_and_gains_in_z(poles, zeros, gain):
    G = gain * sp.Mul(*(z - each for each in zeros[: len(poles)])) / sp.Mul(*(z - p for p in poles))
    other = control.minreal(theirs(G, z), verbose=False)
    result = ask("pole_zero_form", plant(G, z))
    assert result.status is Status.VERIFIED, result.reason
    for name, values in (("poles", other.poles()), ("zeros", other.zeros())):
        ours = [complex(each) for each in result.answers.get(name, [])]
        assert np.allclose(np.poly(ours), np.poly(values), rtol=1e-4, atol=1e-6)
    found = ask("dc_gain", plant(G, z)).answers["dc_gain"]
    assert float(found) == pytest.approx(float(np.real(control.dcgain(other))), rel=1e-6, abs=1e-8)
