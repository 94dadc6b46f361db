"""Frequency responses of discrete systems: scipy's and numpy's values, recursions, corruptions, marking, refusals."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.signal
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import OpenLoop, TransferFunction
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

z, k, omega = sp.symbols("z k omega")
R = sp.Rational


def plant(numerator, denominator, sample_time=1):
    N, D = sp.expand(sp.sympify(numerator)), sp.expand(denominator)
    matrix = sp.ImmutableMatrix([[sp.cancel(N / D)]])
    period = None if sample_time is None else sp.sympify(sample_time)
    return TransferFunction(matrix, ((N,),), ((D,),), z, discrete=True, sample_time=period)


def loop_of(*given_):
    """The loop as the task gets it."""
    rational = plant(*given_)
    one = sp.Integer(1)
    return OpenLoop(rational, rational, sp.Integer(0), one, rational.matrix[0, 0], one)


def response(found, **options):
    return ask("frequency_response", plant(*found), **options)


LOWPASS = (R(1, 5) * z, z - R(4, 5), R(1, 10))


def test_a_low_pass_filter_in_exact_numbers():
    result = ask("frequency_response", plant(*LOWPASS))
    assert result.status is Status.VERIFIED
    assert result.answers["bandwidth"] == 10 * sp.acos(R(39, 40))
    assert "resonant_frequency" not in result.answers
    w = np.linspace(0.1, 31, 40)
    _, wanted = scipy.signal.freqz([0.2, 0], [1, -0.8], worN=w * 0.1)
    size, angle = (sp.lambdify(omega, result.answers[name], "numpy")(w) for name in ("magnitude", "phase"))
    assert np.allclose(size, np.abs(wanted))
    assert np.allclose(np.cos(np.radians(angle) - np.angle(wanted)), 1)


def test_values_at_frequencies_below_and_beyond_that_of_nyquist():
    for at in (4, 60):
        result = response(LOWPASS, frequency=sp.Integer(at))
        _, (wanted,) = scipy.signal.freqz([0.2, 0], [1, -0.8], worN=[at * 0.1])
        assert abs(float(result.answers["magnitude"]) - abs(wanted)) < 1e-12
        assert abs(float(result.answers["phase"]) - np.degrees(np.angle(wanted))) < 1e-9
    assert abs(float(result.steps[-1].values["alias"]) - (20 * np.pi - 60)) < 1e-9


def test_what_is_left_of_a_sinusoid_is_what_the_recursion_gives():
    for u in (2 * sp.cos(4 * sp.Symbol("t")), 2 * sp.cos(R(2, 5) * k)):
        y = response(LOWPASS, input=u).answers["y_steady_state"]
        left = scipy.signal.lfilter([0.2, 0], [1, -0.8], 2 * np.cos(0.4 * np.arange(400)))[-20:]
        assert np.allclose([float(y.subs(k, n)) for n in range(380, 400)], left, atol=1e-12)


def test_a_sequence_needs_no_period():
    answers = response((1, z - R(1, 2), None), input=3 * sp.sin(sp.pi * k / 2)).answers
    assert answers["magnitude"] == 2 * sp.sqrt(5) / 5
    assert answers["y_steady_state"].subs(k, 0).equals(-12 * sp.sqrt(5) / 5 / sp.sqrt(5))


def test_a_resonance_inside_and_one_at_the_frequency_of_nyquist():
    inside = response((z + 1, 4 * (z - 1) * (z - R(1, 2)), R(1, 2)), feedback=sp.Integer(1)).answers
    assert inside["resonant_frequency"] == 2 * sp.acos(sp.sqrt(3) - 1)
    at_the_end = response((z - 1, 2 * z))
    assert at_the_end.status is Status.VERIFIED
    assert at_the_end.answers["resonant_frequency"] == sp.pi
    assert (at_the_end.answers["resonant_peak"], at_the_end.answers["resonant_phase"]) == (1, 0)


factors = st.sampled_from([z - R(1, 2), z - R(9, 10), z, z + R(1, 2), z**2 - z + R(1, 2), z**2 + R(4, 5)])
above = st.sampled_from([sp.Integer(1), z - R(1, 3), z + 1, z + 2, z**2 - z + 1])
filters = st.tuples(
    above, st.lists(factors, min_size=1, max_size=3).map(sp.prod), st.sampled_from([1, R(1, 5)])
).filter(lambda each: sp.degree(each[0], z) <= sp.degree(each[1], z))


@settings(max_examples=10, deadline=None)
@given(filters)
def test_generated_responses_are_verified_and_numpys(found):
    result = ask("frequency_response", plant(*found))
    assert result.status is Status.VERIFIED
    N, D = (np.array(sp.Poly(p, z).all_coeffs(), dtype=float) for p in found[:2])
    theta = np.linspace(1e-6, np.pi, 100_001)
    sizes = np.abs(np.polyval(N, np.exp(1j * theta)) / np.polyval(D, np.exp(1j * theta)))
    peak = result.answers.get("resonant_peak")
    assert abs((sizes[0] if peak is None else float(peak)) - np.max(sizes)) < 1e-6 * np.max(sizes)


@pytest.mark.parametrize(
    ("name", "wrong", "options"),
    [
        ("magnitude", R(1, 2), {"frequency": sp.Integer(4)}),
        ("phase", sp.Integer(49), {"frequency": sp.Integer(4)}),
        ("magnitude", R(1, 5) / sp.sqrt(R(41, 25) - R(8, 5) * sp.cos(omega)), {}),  # T is missing
        ("bandwidth", sp.acos(R(39, 40)), {}),
        ("y_steady_state", 2 * sp.cos(2 * k / 5), {"input": 2 * sp.cos(2 * k / 5)}),
    ],
)
def test_corrupted_answers_are_rejected(name, wrong, options):
    right = response(LOWPASS, **options).answers[name]
    assert not rejected("frequency_response", loop_of(*LOWPASS), {name: right}, **options)
    assert rejected("frequency_response", loop_of(*LOWPASS), {name: wrong}, **options)


@pytest.mark.parametrize(
    ("found", "options", "says"),
    [
        ((1, z - 2), {"input": sp.cos(k)}, "unit circle"),
        ((1, z - R(1, 2)), {"input": k}, "no sinusoid"),
        ((z + 1, z), {"frequency": sp.pi}, "zero"),
    ],
)
def test_what_cannot_be_answered_says_why(found, options, says):
    result = response(found, **options)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


PROBLEM = """
title: R
system: {time: discrete, sample_time: 1/10, transfer_function: z/(5z - 4)}
find:
  a: {task: frequency_response, frequency: 4}
"""


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("magnitude", "0.4904", ""),
        ("magnitude", "0.12204", "T is missing"),
        ("magnitude", "0.19612", "jω is put in for z"),
        ("phase", "49.81", "sign"),
    ],
)
def test_mistakes_have_names(name, value, says):
    sheet = verdict(PROBLEM, "a", name, value)
    assert (sheet.verdict == "correct") is (says == "")
    assert says in sheet.reason
