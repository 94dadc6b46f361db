"""Frequency responses: scipy's values, textbook formulas, simulated steady states, corruptions, marking, refusals."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import signal

from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_stability_margins import loop_of, plant

s, t, omega = sp.symbols("s t omega")
TWO = sp.Integer(2)


def asked(G, delay=0, **options):
    return ask("frequency_response", plant(G, delay), **(options or {"frequency": None}))


def test_functions_resonance_and_bandwidth_of_second_order():
    zeta, natural = sp.Rational(1, 4), sp.Integer(2)
    result = asked(natural**2 / (s**2 + 2 * zeta * natural * s + natural**2))
    assert result.status is Status.VERIFIED
    found = result.answers
    assert found["resonant_frequency"] == sp.sqrtdenest(natural * sp.sqrt(1 - 2 * zeta**2))
    assert sp.simplify(found["resonant_peak"] - 1 / (2 * zeta * sp.sqrt(1 - zeta**2))) == 0
    wanted = natural * sp.sqrt(1 - 2 * zeta**2 + sp.sqrt(4 * zeta**4 - 4 * zeta**2 + 2))
    assert abs(float(found["bandwidth"] - wanted)) < 1e-12
    assert {step.kind for step in result.steps} >= {"on_axis", "functions", "resonance", "bandwidth", "picture"}


@settings(max_examples=12, deadline=None)
@given(st.lists(st.integers(1, 8), min_size=1, max_size=3), st.integers(1, 9), st.integers(1, 20))
def test_values_are_scipys(poles, gain, at):
    D = sp.prod(s + p for p in poles) * (s**2 + s + 3)
    result = asked(gain / D, frequency=sp.Rational(at, 3))
    assert result.status is Status.VERIFIED
    _, value = signal.freqresp(([gain], [float(c) for c in sp.Poly(sp.expand(D), s).all_coeffs()]), w=[at / 3])
    assert abs(float(result.answers["magnitude"]) - abs(value[0])) < 1e-9 * abs(value[0])
    assert abs(float(result.answers["phase"]) - np.angle(value[0], deg=True)) % 360 < 1e-6


def test_the_steady_answer_is_that_of_a_simulation():
    result = asked(4 / (s**2 + s + 4), input=2 * sp.cos(4 * t))
    assert result.status is Status.VERIFIED
    times = np.linspace(0, 60, 6001)
    _, y, _ = signal.lsim(([4], [1, 1, 4]), 2 * np.cos(4 * times), times)
    steady = sp.lambdify(t, result.answers["y_steady_state"])(times)
    assert np.max(np.abs(y - steady)[-500:]) < 1e-3
    assert asked(1 / (s + 1), input=sp.sin(t)).answers["phase"] == -45


def test_closed_loops_and_dead_times():
    closed = ask("frequency_response", plant(10 / (s * (s + 2))), feedback=sp.Integer(1), frequency=TWO)
    assert closed.answers["magnitude"] == sp.sqrt(sp.Rational(100, 36 + 16))
    late = asked(1 / (s + 1), 1)
    assert late.status is Status.VERIFIED
    assert late.answers["bandwidth"] == 1
    at = late.answers["phase"].subs(omega, 3.0)
    assert abs((float(at) + np.degrees(np.arctan(3) + 3)) % 360) % 360 < 1e-6


@pytest.mark.parametrize(
    ("options", "kind"),
    [
        ({"input": t * sp.cos(t)}, "no_sinusoid"),
        ({"input": sp.exp(t)}, "no_sinusoid"),
        ({"frequency": sp.Symbol("a")}, "sign_not_known"),
    ],
)
def test_what_has_no_answer(options, kind):
    result = asked(1 / (s + 1), **options)
    assert result.status is Status.UNSOLVED
    assert kind in result.reason.kind


def test_unstable_systems_have_no_steady_state_and_poles_no_value():
    assert "never_steady" in asked(1 / (s - 1), input=sp.cos(t)).reason.kind
    assert "pole_at" in asked(1 / (s**2 + 4), frequency=TWO).reason.kind
    assert "zero_at" in asked((s**2 + 4) / (s + 1) ** 2, frequency=TWO).reason.kind
    late = ask("frequency_response", plant(1 / s, 1), feedback=sp.Integer(1), controller=None)
    assert "closed_with_dead_time" in late.reason.kind


@pytest.mark.parametrize("options", [{}, {"frequency": TWO}, {"input": 2 * sp.cos(4 * t) + sp.sin(4 * t)}])
def test_corrupted_answers_are_rejected(options):
    G = 4 / (s**2 + s + 4)
    found, loop = asked(G, **options).answers, loop_of(G)
    assert not rejected("frequency_response", loop, dict(found), **options)
    for name, value in found.items():
        for each in (value * sp.Rational(1001, 1000), -value, value + 1):
            assert rejected("frequency_response", loop, {name: each}, **options), (name, each)


PROBLEM = """
system: {transfer_function: 4/(s^2 + s + 4)}
find: {a: {task: frequency_response, frequency: 4}, b: frequency_response}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "right", "words"),
    [
        ("a", "magnitude", "0.3162", True, ""),
        ("a", "phase", "-161.57", True, ""),
        ("a", "phase", "198.43", True, ""),
        ("a", "phase", "-2.8198", False, "radians"),
        ("a", "phase", "161.57", False, "sign"),
        ("a", "magnitude", "-10.00", False, ""),
        ("a", "magnitude", "0.1", False, "T|^2"),
        ("b", "magnitude", "4/sqrt(omega^4 - 7omega^2 + 16)", True, ""),
        ("b", "magnitude", "4/sqrt((4 - omega^2)^2 + omega^2)", True, ""),
        ("b", "resonant_frequency", "sqrt(3.5)", True, ""),
        ("b", "bandwidth", "0.47253", False, "Hz"),
    ],
)
def test_marking(part, name, value, right, words):
    sheet = verdict(PROBLEM, part, name, value)
    assert (sheet.verdict == "correct") is right
    assert words in sheet.reason
