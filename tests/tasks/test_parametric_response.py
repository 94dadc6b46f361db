"""Frequency responses with parameters and to sums of sinusoids: textbook formulas, numbers put in, corruptions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy import signal

from solver.derivation import Status
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_stability_margins import loop_of, plant

s, t, k, omega = sp.symbols("s t k omega")
R, C, K, tau, zeta, natural, late = sp.symbols("R C K tau zeta omega_n T_d", positive=True)
u = sp.Symbol("u")
ONE = sp.Integer(1)
RC = 1 / (R * C * s + 1)
SERVO = K / (s * (tau * s + 1))
SECOND = natural**2 / (s**2 + 2 * zeta * natural * s + natural**2)
UNSTABLE = "never_steady"


def asked(G, delay=0, **options):
    return ask("frequency_response", plant(G, delay), **(options or {"frequency": None}))


@pytest.mark.parametrize(
    ("G", "magnitude", "degrees"),
    [
        (RC, 1 / sp.sqrt(1 + (R * C * omega) ** 2), -180 / sp.pi * sp.atan(R * C * omega)),
        (SERVO, K / (omega * sp.sqrt(1 + (tau * omega) ** 2)), -90 - 180 / sp.pi * sp.atan(tau * omega)),
        ((1 - tau * s) / (1 + tau * s), 1, -360 / sp.pi * sp.atan(tau * omega)),
        (SECOND, natural**2 / sp.sqrt((natural**2 - omega**2) ** 2 + (2 * zeta * natural * omega) ** 2),
         -180 / sp.pi * sp.atan2(2 * zeta * natural * omega, natural**2 - omega**2)),
    ],
)  # fmt: skip
def test_functions_are_those_of_a_first_course(G, magnitude, degrees):
    result = asked(G)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["magnitude"] ** 2 - magnitude**2) == 0
    assert sp.cancel(sp.expand(result.answers["phase"] - degrees)) == 0
    assert {step.kind for step in result.steps} >= {"factors", "together"}


def test_at_the_corner_they_are_numbers():
    found = asked(RC, frequency=1 / (R * C)).answers
    assert (found["magnitude"], found["phase"]) == (sp.sqrt(2) / 2, -45)
    found = asked(SERVO, frequency=1 / tau).answers
    assert (found["magnitude"], found["phase"]) == (sp.sqrt(2) * K * tau / 2, -135)
    found = asked(SECOND, frequency=natural).answers
    assert (found["magnitude"], found["phase"]) == (1 / (2 * zeta), -90)


def test_bandwidths():
    assert asked(RC).answers["bandwidth"] == 1 / (R * C)
    closed = ask("frequency_response", plant(K / s), feedback=ONE)
    assert closed.status is Status.VERIFIED
    assert closed.answers["bandwidth"] == K
    wanted = natural * sp.sqrt(1 - 2 * zeta**2 + sp.sqrt(4 * zeta**4 - 4 * zeta**2 + 2))
    at = {natural: 1.7, zeta: 0.3}
    assert abs(float((asked(SECOND).answers["bandwidth"] - wanted).subs(at))) < 1e-12


def test_a_dead_time_turns_only():
    result = asked(1 / (tau * s + 1), late)
    assert result.status is Status.VERIFIED
    assert result.answers["magnitude"] == 1 / sp.sqrt(1 + tau**2 * omega**2)
    assert sp.expand(result.answers["phase"] + 180 / sp.pi * (sp.atan(tau * omega) + late * omega)) == 0


@pytest.mark.parametrize(
    ("G", "options", "says"),
    [
        (u / (s + 1), {}, "the sign of $u$"),
        (RC, {"frequency": u}, "the sign of $u$"),
        (1 / (s + u), {"input": sp.sin(t)}, "the sign of $u$"),
        (1 / (s - K), {"input": sp.sin(t)}, "not stable"),
        (1 / (s**2 + K**2), {"frequency": K}, "pole"),
        ((s**2 + K**2) / (s + 1) ** 2, {"frequency": K}, "zero"),
        (K / s, {"delay": late, "feedback": ONE, "frequency": ONE}, "no value"),
    ],
)
def test_what_is_open_says_what_must_be_assumed(G, options, says):
    result = asked(G, **{"frequency": None, **options}) if "delay" not in options else asked(
        G, options["delay"], feedback=ONE, frequency=ONE)  # fmt: skip
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


@pytest.mark.parametrize(
    "options", [{}, {"frequency": 1 / (R * C)}, {"input": 2 * sp.sin(3 * t)}, {"input": 1 + sp.cos(t) + sp.sin(2 * t)}]
)
def test_corrupted_answers_with_parameters_are_rejected(options):
    found, loop = asked(RC, **options).answers, loop_of(RC)
    options = options or {"frequency": None}
    assert not rejected("frequency_response", loop, dict(found), **options)
    for name, value in found.items():
        for each in (value * sp.Rational(1001, 1000), -value, value + 1, value.subs(R, 2 * R) * (1 + R)):
            assert rejected("frequency_response", loop, {name: each}, **options), (name, each)


def test_sums_of_sinusoids_pass_part_by_part():
    G, wave = 4 / (s**2 + s + 4), 3 + 2 * sp.cos(4 * t) - sp.sin(t)
    result = asked(G, input=wave)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps][-5:] == ["apart", "rest", "value", "value", "steady_state"]
    times = np.linspace(0, 60, 6001)
    _, y, _ = signal.lsim(([4], [1, 1, 4]), sp.lambdify(t, wave)(times), times)
    steady = sp.lambdify(t, result.answers["y_steady_state"])(times)
    assert np.max(np.abs(y - steady)[-500:]) < 1e-3


@pytest.mark.parametrize("wave", [1 + sp.sin(t), sp.sin(t) ** 2, sp.cos(t) + sp.cos(2 * t), sp.sin(t) * sp.cos(3 * t)])
def test_sums_are_verified_and_corrupted_ones_rejected(wave):
    G = (s**2 + 4) / (s + 1) ** 3  # blocks ω = 2
    result = asked(G, input=wave)
    assert result.status is Status.VERIFIED
    y = result.answers["y_steady_state"]
    for each in (y + sp.Rational(1, 100), 2 * y + sp.Rational(1, 9), y.subs(t, t + 1) + sp.sin(t)):
        assert rejected("frequency_response", loop_of(G), {"y_steady_state": each}, input=wave)


PROBLEM = """
assume: {R: positive, C: positive}
system: {transfer_function: 1/(R C s + 1)}
find:
  a: frequency_response
  b: {task: frequency_response, frequency: 1/(R C)}
  c: {task: frequency_response, input: 1 + sin(t), system: {transfer_function: 2/(s + 1)}}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "right"),
    [
        ("a", "magnitude", "1/sqrt(1 + (omega R C)^2)", True),
        ("a", "magnitude", "1/sqrt(1 + omega R C)", False),
        ("a", "phase", "-180/pi atan(omega R C)", True),
        ("a", "phase", "180/pi atan(omega R C)", False),
        ("a", "bandwidth", "1/(R C)", True),
        ("a", "bandwidth", "R C", False),
        ("b", "magnitude", "0.7071", True),
        ("b", "phase", "315", True),
        ("c", "y_steady_state", "2 + sqrt(2) sin(t - pi/4)", True),
        ("c", "y_steady_state", "2 + 1.414 sin(t - 0.7854)", True),
        ("c", "y_steady_state", "1 + sqrt(2) sin(t - pi/4)", False),
    ],
)
def test_marking(part, name, value, right):
    judged = verdict(PROBLEM, part, name, value)
    assert (judged.verdict == "correct") is right, judged.reason
