"""Poles from specifications: simulated step responses, exact values, refusals, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.problem.systems import NOTHING
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.tried import tried

R = sp.Rational
s = sp.Symbol("s")
NAMES = ("overshoot", "settling_time", "peak_time", "rise_time", "damping_ratio", "natural_frequency")
PAIRS = [(a, b) for i, a in enumerate(NAMES) for b in NAMES[i + 1 :] if {a, b} != {"overshoot", "damping_ratio"}]


def properties(zeta, omega):
    """What a simulation of the step response shows (settling time by its formula)."""
    t = np.linspace(0, 12 / (zeta * omega), 400_001)
    damped = omega * np.sqrt(1 - zeta**2)
    y = 1 - np.exp(-zeta * omega * t) * (np.cos(damped * t) + zeta * omega / damped * np.sin(damped * t))
    peak = int(np.argmax(y))
    return {
        "overshoot": y[peak] - 1,
        "peak_time": t[peak],
        "rise_time": t[int(np.argmax(y >= 1))],
        "settling_time": 4 / (zeta * omega),
        "damping_ratio": zeta,
        "natural_frequency": omega,
    }


@tried(6)
@given(st.floats(0.2, 0.8), st.floats(0.5, 5))
def test_every_pair_gives_the_system_whose_simulated_response_has_these_values(zeta, omega):
    seen = properties(zeta, omega)
    for pair in PAIRS:
        result = ask("desired_poles", NOTHING, **{name: R(str(round(seen[name], 9))) for name in pair})
        assert result.status is Status.VERIFIED, (pair, result.reason)
        assert float(result.answers["damping_ratio"]) == pytest.approx(zeta, abs=2e-3)
        assert float(result.answers["natural_frequency"]) == pytest.approx(omega, rel=5e-3)


def test_settling_and_peak_time_keep_pi_exact():
    answers = ask("desired_poles", NOTHING, settling_time=sp.S(4), peak_time=sp.pi / sp.sqrt(3)).answers
    assert sp.expand(answers["polynomial"] - (s**2 + 2 * s + 4)) == 0
    assert {sp.expand(pole) for pole in answers["poles"]} == {-1 + sp.sqrt(3) * sp.I, -1 - sp.sqrt(3) * sp.I}
    answers = ask("desired_poles", NOTHING, settling_time=sp.S(4), peak_time=R(1813, 1000)).answers
    assert not answers["polynomial"].has(sp.Float)


def test_the_band_of_five_percent():
    answers = ask("desired_poles", NOTHING, damping_ratio=R(1, 2), settling_time=sp.S(3), settling_band="5%").answers
    assert answers["natural_frequency"] == 2


def test_overshoot_gives_decimals_of_twelve_digits_and_more():
    zeta = ask("desired_poles", NOTHING, overshoot=R(14, 100), rise_time=R(5, 4)).answers["damping_ratio"]
    assert abs(zeta - sp.N(-sp.log(R(14, 100)) / sp.sqrt(sp.pi**2 + sp.log(R(14, 100)) ** 2), 30)) < sp.Float(
        "1e-25", 30
    )


def test_symbols_stay_symbols():
    zeta, omega = sp.symbols("zeta omega", positive=True)
    result = ask("desired_poles", NOTHING, damping_ratio=zeta, natural_frequency=omega)
    assert result.status is Status.VERIFIED, result.reason
    assert sp.expand(result.answers["polynomial"] - (s**2 + 2 * zeta * omega * s + omega**2)) == 0


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({}, "none is given"),
        ({"overshoot": R(1, 7)}, "only the overshoot"),
        ({"overshoot": R(1, 7), "damping_ratio": R(1, 2)}, "not fixed"),
        ({"overshoot": sp.S(14), "settling_time": sp.S(1)}, "less than 1"),
        ({"peak_time": sp.S(3), "rise_time": sp.S(1)}, "damping"),
        ({"natural_frequency": sp.S(3), "peak_time": sp.S(1)}, "longer"),
        ({"natural_frequency": sp.S(1), "rise_time": sp.S(1)}, "longer"),
        ({"settling_time": sp.S(-1), "rise_time": sp.S(1)}, "positive"),
        ({"damping_ratio": R(1, 2), "settling_time": sp.S(4), "overshoot": R(3, 10)}, "give the overshoot"),
        ({"damping_ratio": sp.S(2), "peak_time": sp.S(4)}, "no peak"),
    ],
)
def test_specifications_that_cannot_be_met_are_refused_in_words(options, says):
    assert any(says in str(message) for _, message in catalogue()["desired_poles"].refused(NOTHING, options))
    assert ask("desired_poles", NOTHING, **options, settling_band="2%").status is Status.UNSOLVED


def test_a_third_specification_that_agrees_is_no_fault():
    options = {"damping_ratio": R(1, 2), "settling_time": sp.S(4), "overshoot": R(163, 1000)}
    assert not list(catalogue()["desired_poles"].refused(NOTHING, options))
    assert ask("desired_poles", NOTHING, **options).status is Status.VERIFIED


OPTIONS = {"settling_time": sp.S(4), "overshoot": R(14, 100)}
CORRUPTIONS = {
    "damping_ratio": [lambda v: -v, lambda v: v * R(1001, 1000), lambda v: 1 / v],
    "natural_frequency": [lambda v: -v, lambda v: v * R(1001, 1000), lambda v: v**2],
    "poles": [lambda v: [-p for p in v], lambda v: v[:1], lambda v: [p + R(1, 1000) for p in v], lambda v: [*v, v[0]]],
    "polynomial": [lambda v: v + R(1, 1000), lambda v: v + s / 1000, lambda v: 2 * v, lambda v: v * s],
}


@pytest.mark.parametrize("name", CORRUPTIONS)
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answer = ask("desired_poles", NOTHING, **OPTIONS).answers[name]
    assert not rejected("desired_poles", NOTHING, {name: answer}, **OPTIONS)
    for corrupt in CORRUPTIONS[name]:
        assert rejected("desired_poles", NOTHING, {name: corrupt(answer)}, **OPTIONS)


def test_without_overshoot_the_damping_ratio_is_one():
    for speed in ({"settling_time": R(2)}, {"natural_frequency": R(2)}):
        result = ask("desired_poles", NOTHING, overshoot=R(0), **speed)
        assert result.status is Status.VERIFIED
        assert result.answers["damping_ratio"] == 1
        assert result.answers["poles"] == [-2, -2]


@pytest.mark.parametrize("other", [{"natural_frequency": R(2)}, {"damping_ratio": R(2)}])
def test_a_settling_time_of_two_real_poles_has_no_formula(other):
    result = ask("desired_poles", NOTHING, settling_time=R(1), **other)
    assert result.status is Status.UNSOLVED
    assert "settling" in str(result.reason)
    assert not result.answers


@pytest.mark.parametrize("third", [{"overshoot": R(135, 1000)}, {"damping_ratio": R(54, 100), "peak_time": None}])
def test_rounded_specifications_that_agree_are_met(third):
    asked = {"settling_time": R(2), "peak_time": R(1), **third}
    result = ask("desired_poles", NOTHING, **{name: value for name, value in asked.items() if value is not None})
    assert result.status is Status.VERIFIED
