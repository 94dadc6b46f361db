"""PID controllers in discrete time: against scipy, the sums themselves, corruptions, usual mistakes, bad questions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import cont2discrete, lfilter

from solver.derivation import Status
from solver.engine import solve_problem
from solver.exact import Gains, discrete_pid
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict

z, T, K_p, K_i, K_d = sp.Symbol("z"), sp.Symbol("T", positive=True), *sp.symbols("K_p K_i K_d", real=True)
NOTHING = system(sp.zeros(0, 0))
METHODS = ("backward", "forward", "tustin")
SCIPY = {"backward": "backward_diff", "forward": "euler", "tustin": "bilinear"}
R = sp.Rational


def coefficients(F):
    top, bottom = (np.array(sp.Poly(part, z).all_coeffs(), dtype=float) for part in sp.fraction(sp.cancel(F)))
    return np.concatenate([np.zeros(len(bottom) - len(top)), top]), bottom


@pytest.mark.parametrize("method", METHODS)
def test_the_pi_part_is_scipys(method):
    """Without a derivative the whole controller is mapped by one rule."""
    ours = ask("pid_discretization", NOTHING, method, K_p=R(2), K_i=R(3), sample_time=R(1, 10))
    assert ours.status is Status.VERIFIED
    top, bottom, _ = cont2discrete(([2, 3], [1, 0]), 0.1, method=SCIPY[method])
    for point in (2.0, -3.0, 0.5 + 1j):
        wanted = np.polyval(np.ravel(top), point) / np.polyval(bottom, point)
        assert np.isclose(complex(ours.answers["controller"].subs(z, point)), wanted)


gains = st.fractions(min_value=-4, max_value=4, max_denominator=5).map(lambda f: R(f.numerator, f.denominator))


@settings(max_examples=12)
@given(gains, gains, gains, st.sampled_from([R(1, 10), R(1, 2), R(3)]), st.sampled_from(METHODS))
def test_both_forms_give_the_sums(p, i, d, period, method):
    if p == i == d == 0:
        return
    result = ask("pid_discretization", NOTHING, method, K_p=p, K_i=i, K_d=d, sample_time=period)
    assert result.status is Status.VERIFIED
    e = np.array([1, -2, 3, 0.5, 4, -1, 2, 2])
    before, h = np.concatenate([[0], e[:-1]]), float(period)
    heights = {"backward": e, "forward": before, "tustin": (e + before) / 2}[method]
    wanted = float(p) * e + float(i) * h * np.cumsum(heights) + float(d) * (e - before) / h
    assert np.allclose(lfilter(*coefficients(result.answers["controller"]), e), wanted)
    q = np.array(result.answers["coefficients"], dtype=float)
    assert np.allclose(lfilter(q, [1, -1], e), wanted)


def test_symbols_and_steps():
    result = ask("pid_discretization", NOTHING, "backward", sample_time=T)
    assert [step.kind for step in result.steps] == ["law", "integral", "derivative", "position", "velocity"]
    wanted = [K_p + K_i * T + K_d / T, -K_p - 2 * K_d / T, K_d / T]
    assert all(sp.expand(own - each) == 0 for own, each in zip(result.answers["coefficients"], wanted, strict=True))
    D = K_p + K_i * T * z / (z - 1) + K_d * (z - 1) / (T * z)
    assert sp.cancel(result.answers["controller"] - D) == 0
    tustin = ask("pid_discretization", NOTHING, "tustin", sample_time=T).answers["coefficients"]
    assert sp.expand(tustin[1] - (-K_p + K_i * T / 2 - 2 * K_d / T)) == 0
    assert [step.kind for step in ask("pid_discretization", NOTHING, K_p=R(3), sample_time=T).steps] == [
        "law", "position", "velocity",
    ]  # fmt: skip


def test_corrupted_answers_are_rejected():
    options = {"K_p": R(2), "K_i": R(1), "K_d": R(1, 2), "sample_time": R(1, 10)}
    found = ask("pid_discretization", NOTHING, "backward", **options).answers
    D, q = found["controller"], found["coefficients"]
    assert not rejected("pid_discretization", NOTHING, {"controller": sp.cancel(D), "coefficients": q}, **options)
    in_delays = (q[0] + q[1] / z + q[2] / z**2) / (1 - 1 / z)
    assert not rejected("pid_discretization", NOTHING, {"controller": in_delays}, **options)
    for wrong in (-D, D / z, D + 1, D.subs(z, 1 / z), D * (z + 1) / (z + 2), 1 / D):
        assert rejected("pid_discretization", NOTHING, {"controller": wrong}, **options), wrong
    for wrong in ([q[0], -q[1], q[2]], q[::-1], [*q, R(1)], q[:2], [2 * each for each in q]):
        assert rejected("pid_discretization", NOTHING, {"coefficients": wrong}, **options), wrong
    for rule in ("forward", "tustin"):
        other = discrete_pid(Gains(R(2), R(1), R(1, 2)), R(1, 10), rule, z)
        assert rejected("pid_discretization", NOTHING, {"controller": other.controller}, **options)


MARKED = "find: {a: {task: pid_discretization, method: backward, K_p: 2, K_i: 3, K_d: 1/2, sample_time: 1/10}}"


@pytest.mark.parametrize(
    ("name", "value", "found"),
    [
        ("controller", "2 + 0.3z/(z - 1) + 5(z - 1)/z", ("correct", None)),
        ("controller", "(7.3 - 12z^-1 + 5z^-2)/(1 - z^-1)", ("correct", None)),
        ("coefficients", "[7.3, -12, 5]", ("correct", None)),
        ("coefficients", "[10, -12, 5]", ("wrong", "without_T")),
        ("coefficients", "[7, -11.7, 5]", ("wrong", "other_rule")),
        ("coefficients", "[7.3, -5, 0]", ("wrong", "position_for_velocity")),
        ("controller", "2 + 0.3z/(z - 1) + 0.05(z - 1)/z", ("wrong", "derivative_times_T")),
    ],
)
def test_marking(name, value, found):
    told = verdict(MARKED, "a", name, value)
    assert (told.verdict, told.mistake or None) == found


def refused(text):
    with pytest.raises(InputError) as found:
        solve_problem(read_problem(Source("problem.yaml", text), catalogue()))
    return str(found.value)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("K_p: 2", "sampling period is not given"),
        ("K_p: 2, sample_time: -1", "sample_time must be positive"),
        ("K_p: 0, K_i: 0, sample_time: T", "all gains are zero"),
        ("K_p: 2, sample_time: T, method: euler", "euler"),
    ],
)
def test_bad_questions_are_told(options, words):
    assert words in refused(f"find: {{a: {{task: pid_discretization, {options}}}}}")
