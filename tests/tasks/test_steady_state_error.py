"""What remains of errors: textbook values, loops simulated by scipy, conditions, corruptions, marking, bad inputs."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import signal

from solver.derivation import Status
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

s, t, K = sp.symbols("s t K")
ONE, RAMP, PARABOLA = sp.Integer(1), t, t**2 / 2


def plant(G):
    top, bottom = (sp.Poly(each, s).as_expr() for each in sp.fraction(sp.together(G)))
    return TransferFunction(sp.ImmutableMatrix([[sp.cancel(G)]]), ((top,),), ((bottom,),), s)


def error(G, reference=ONE, method="final_value", **options):
    return ask("steady_state_error", plant(G), method, **{"reference": reference, "feedback": ONE, **options})


@pytest.mark.parametrize(
    ("G", "reference", "wanted", "constants"),
    [
        (10 / ((s + 1) * (s + 2)), ONE, sp.Rational(1, 6), (0, 5, 0, 0)),
        (10 / ((s + 1) * (s + 2)), RAMP, sp.oo, (0, 5, 0, 0)),
        (100 / (s * (s + 8)), RAMP, sp.Rational(2, 25), (1, sp.oo, sp.Rational(25, 2), 0)),
        (100 / (s * (s + 8)), PARABOLA, sp.oo, (1, sp.oo, sp.Rational(25, 2), 0)),
        (8 * (s + 1) / (s**2 * (s + 4)), PARABOLA, sp.Rational(1, 2), (2, sp.oo, sp.oo, 2)),
        (100 / (s * (s + 8)), ONE, 0, (1, sp.oo, sp.Rational(25, 2), 0)),
        (10 * (s + 1) / (s * (s - 1)), RAMP, -sp.Rational(1, 10), (1, -sp.oo, -10, 0)),
    ],
)
@pytest.mark.parametrize("method", ["final_value", "error_constants"])
def test_errors_of_the_textbooks(G, reference, wanted, constants, method):
    result = error(G, reference, method)
    assert result.status is Status.VERIFIED
    found = result.answers
    assert found["error"] == wanted
    names = ("system_type", "position_constant", "velocity_constant", "acceleration_constant")
    assert tuple(found[name] for name in names) == constants


def test_the_steps_by_both_methods():
    G = 10 * (s + 1) / (s * (s + 2) * (s + 5))
    assert [step.kind for step in error(G, RAMP).steps] == [
        "open_loop", "characteristic", "first_rows", "row", "row", "array", "stable",
        "signals", "unity", "final_value", "constants",
    ]  # fmt: skip
    assert [step.kind for step in error(G, RAMP, "error_constants").steps][-2:] == ["constants", "by_constants"]


def test_a_disturbance_adds_its_part_and_a_feedback_is_no_measure_of_the_error():
    G = 5 / (s * (s + 3))
    assert error(G, 3 + 2 * t, controller=sp.Integer(2), disturbance=ONE).answers["error"] == sp.Rational(1, 10)
    assert error(G, sp.Integer(0), controller=sp.Integer(2), disturbance=ONE).answers["error"] == -sp.Rational(1, 2)
    with_feedback = error(10 / ((s + 1) * (s + 2)), feedback=1 / (s + 3))
    assert with_feedback.answers["error"] == -sp.Rational(7, 8)
    assert with_feedback.answers["position_constant"] == sp.Rational(5, 3)


def test_without_feedback_the_error_is_one_less_the_gain():
    assert error(10 / ((s + 1) * (s + 2)), feedback=None).answers["error"] == -4
    assert error(1 / (s * (s + 2)), feedback=None).answers["error"] == -sp.oo


@pytest.mark.parametrize(
    ("G", "reference", "said"),
    [
        (10 / ((s + 1) ** 3), ONE, "2 roots in the right half plane"),
        (1 / (s**2 + 1), ONE, "on the imaginary axis"),
        (10 / ((s + 1) * (s + 2)), sp.sin(2 * t), "no limit"),
        (10 / ((s + 1) * (s + 2)), sp.exp(t), "no limit"),
    ],
)
def test_where_nothing_remains_the_reason_is_said(G, reference, said):
    result = error(G, reference)
    assert result.status is Status.UNSOLVED
    assert said in str(result.reason)


def test_a_hidden_unstable_pole_is_in_the_loop_all_the_same():
    result = error(1 / (s - 1), controller=(s - 1) / (s + 2))
    assert result.status is Status.UNSOLVED
    assert "1 root in the right half plane" in str(result.reason)


def test_an_internal_model_follows_a_sine_and_a_late_step_counts_from_where_it_begins():
    L = 4 * (s + 1) ** 2 / ((s**2 + 4) * (s + 3))
    assert error(L, sp.sin(2 * t)).answers["error"] == 0
    saturated = t - (t - 1) * sp.Heaviside(t - 1)
    assert error(10 / ((s + 1) * (s + 2)), saturated).answers["error"] == sp.Rational(1, 6)
    assert error(10 / ((s + 1) * (s + 2)), 1 - sp.exp(-t)).answers["error"] == sp.Rational(1, 6)


def test_error_constants_say_where_they_do_not_apply():
    G = 10 / ((s + 1) * (s + 2))
    for options, said in (
        ({"feedback": None}, "not closed"),
        ({"feedback": 1 / (s + 3)}, "unity"),
        ({"disturbance": ONE}, "disturbance"),
        ({"reference": sp.exp(-t)}, "none of these"),
    ):
        result = error(G, options.pop("reference", ONE), "error_constants", **options)
        assert result.status is Status.UNSOLVED
        assert said in str(result.reason)


def test_the_condition_on_a_gain_is_said():
    result = error(K / (s * (s + 1) * (s + 2)), RAMP)
    assert result.status is Status.VERIFIED
    assert result.answers["error"] == 2 / K
    (stable,) = (step for step in result.steps if step.kind == "stable")
    assert stable.values["condition"] == sp.And(K > 0, K < 6)


roots = st.lists(st.integers(1, 6), min_size=1, max_size=3)


@settings(max_examples=10)
@given(roots, st.lists(st.integers(1, 9), max_size=1), st.integers(0, 1), st.integers(1, 12))
def test_random_loops_settle_where_scipy_takes_them(poles, zeros, integrators, gain):
    if integrators + len(poles) <= len(zeros):
        return
    G = gain * sp.prod([s + z for z in zeros]) / (s**integrators * sp.prod([s + p for p in poles]))
    reference = RAMP if integrators else ONE
    result = error(G, reference)
    top, bottom = (np.array(sp.Poly(each, s).all_coeffs(), float) for each in sp.fraction(sp.together(G)))
    loop = np.polyadd(bottom, top)
    unstable = any(root.real >= -1e-9 for root in np.roots(loop))
    assert (result.status is Status.UNSOLVED) == unstable
    if not unstable:
        last = 45 / min(-np.roots(loop).real)
        times = np.linspace(0, last, 3000)
        r = times if integrators else np.ones_like(times)
        _, y, _ = signal.lsim((top, loop), r, times)
        assert result.status is Status.VERIFIED
        assert float(result.answers["error"]) == pytest.approx(float(r[-1] - y[-1]), rel=1e-6, abs=1e-6)


def test_corrupted_answers_are_rejected():
    G = plant(10 / ((s + 1) * (s + 2)))
    right = error(10 / ((s + 1) * (s + 2))).answers
    loop = open_loop(G)
    options = {"reference": ONE, "feedback": ONE}
    assert not rejected("steady_state_error", loop, dict(right), **options)
    wrong = {
        "error": [
            sp.Rational(5, 6),
            sp.Rational(1, 5),
            sp.oo,
            sp.Integer(0),
            sp.Rational(1, 6) + sp.Rational(1, 10**6),
        ],
        "system_type": [sp.Integer(1)],
        "position_constant": [sp.Integer(4), sp.oo],
        "velocity_constant": [sp.oo, sp.Integer(1)],
    }
    for name, values in wrong.items():
        for value in values:
            assert rejected("steady_state_error", loop, {name: value}, **options), (name, value)
    growing = {"reference": RAMP, "feedback": ONE}
    assert not rejected("steady_state_error", loop, {"error": sp.oo}, **growing)
    for value in (-sp.oo, sp.Integer(5), sp.Integer(0)):
        assert rejected("steady_state_error", loop, {"error": value}, **growing)


def open_loop(G):
    from solver.derivation.conversion import composed, converted  # noqa: PLC0415
    from solver.engine import yield_into  # noqa: PLC0415

    return yield_into([], converted(composed(G, {"controller": None, "feedback": ONE}), {"open_loop"}))


PAPER = """\
system: {transfer_function: 5/((s + 1)(s + 2))}
find:
  a: {task: steady_state_error, answers: [error, system_type, position_constant]}
  b: {task: steady_state_error, reference: ramp, controller: 1 + 1/s, answers: [error, velocity_constant, system_type]}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "verdict_", "named"),
    [
        ("a", "error", "0.2857", "correct", ""),
        ("a", "error", "-3/2", "wrong", "without feedback"),
        ("a", "error", "5/7", "wrong", "of the output"),
        ("a", "error", "2/5", "wrong", "is missing"),
        ("a", "error", "5/2", "wrong", "error constant"),
        ("b", "system_type", "1", "correct", ""),
        ("b", "system_type", "0", "wrong", "so many has the closed loop"),
        ("b", "velocity_constant", "5/2", "correct", ""),
        ("b", "error", "0.4", "correct", ""),
    ],
)
def test_marking(part, name, value, verdict_, named):
    found = verdict(PAPER, part, name, value)
    assert found.verdict == verdict_
    assert named in str(found.reason)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ("reference: rampp", "did you mean 'ramp'"),
        ("disturbance: steps", "did you mean 'step'"),
        ("feedback: open", "cannot stand for the feedback"),
        ("referense: ramp", "did you mean 'reference'"),
    ],
)
def test_bad_inputs_are_refused_at_their_place(options, said):
    text = f"system: {{transfer_function: 1/(s + 1)}}\nfind:\n  a: {{task: steady_state_error, {options}}}\n"
    with pytest.raises(InputError) as caught:
        read_problem(Source("a.yaml", text), catalogue())
    assert said in str(caught.value)
    assert "^" in str(caught.value)
