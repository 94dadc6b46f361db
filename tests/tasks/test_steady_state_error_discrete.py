"""What remains of errors of discrete loops: textbook values, recursions in fractions, corruptions, marking."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Status
from solver.derivation.conversion import composed, converted
from solver.engine import yield_into
from solver.options.signal import period
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import TransferFunction
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict

z, k, K, T = sp.symbols("z k K T")
ONE, HALF = sp.Integer(1), sp.Rational(1, 2)
RAMP, PARABOLA = k * period(), (k * period()) ** 2 / 2
CONSTANTS = ("system_type", "position_constant", "velocity_constant", "acceleration_constant")


def plant(G, sample_time=None):
    top, bottom = (sp.Poly(each, z).as_expr() for each in sp.fraction(sp.together(G)))
    matrix = sp.ImmutableMatrix([[sp.cancel(G)]])
    return TransferFunction(matrix, ((top,),), ((bottom,),), z, discrete=True, sample_time=sample_time)


def error(G, reference=ONE, method="final_value", sample_time=None, **options):
    asked = {"reference": reference, "feedback": ONE, **options}
    return ask("steady_state_error", plant(G, sample_time), method, **asked)


@pytest.mark.parametrize(
    ("G", "reference", "wanted", "constants"),
    [
        # Ogata, Discrete-Time Control Systems, section 4-4: ZOH of 1/(s(s + 1)), T = 1, with K = 1 in decimals
        ((368 * z + 264) / ((z - 1) * (1000 * z - 368)), RAMP, ONE, (1, sp.oo, 1, 0)),
        (HALF / (z - HALF), ONE, HALF, (0, 1, 0, 0)),
        (HALF / (z - HALF), RAMP, sp.oo, (0, 1, 0, 0)),
        (HALF / (z - 1), RAMP, sp.Rational(2), (1, sp.oo, HALF, 0)),
        (HALF / (z - 1), PARABOLA, sp.oo, (1, sp.oo, HALF, 0)),
        ((3 * z - 2) / (4 * (z - 1) ** 2), PARABOLA, sp.Integer(4), (2, sp.oo, sp.oo, sp.Rational(1, 4))),
        ((z - HALF) / (z * (z - 1)), ONE, 0, (1, sp.oo, HALF, 0)),
    ],
)
@pytest.mark.parametrize("method", ["final_value", "error_constants"])
def test_errors_of_the_textbooks(G, reference, wanted, constants, method):
    result = error(G, reference, method, ONE)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["error"] == wanted
    assert tuple(result.answers[name] for name in CONSTANTS) == constants


def test_the_sampling_period_is_in_the_constants_and_in_the_ramp():
    for sample_time, wanted in ((sp.Rational(1, 10), sp.Rational(1, 5)), (T, 2 * T)):
        result = error(HALF / (z - 1), RAMP, "error_constants", sample_time)
        assert result.status is Status.VERIFIED, result.reason
        assert result.answers["error"] == wanted
        assert result.answers["velocity_constant"] == 1 / wanted
    by_samples = error(HALF / (z - 1), k, sample_time=sp.Rational(1, 10))
    assert by_samples.answers["error"] == 2


def test_without_a_sampling_period_what_needs_it_is_left_out():
    result = error(HALF / (z - 1), k)
    assert result.status is Status.VERIFIED
    assert result.answers["error"] == 2
    assert set(result.answers) == {"error", "system_type", "position_constant", "acceleration_constant"}
    refused = error(HALF / (z - 1), k, "error_constants")
    assert refused.status is Status.UNSOLVED
    assert "sampling period" in str(refused.reason)
    assert error(HALF / (z - 1), ONE, "error_constants").status is Status.VERIFIED


def test_the_steps():
    G = 3 / ((4 * z - 1) * (z - HALF) * (2 * z + 1))
    kinds = [step.kind for step in error(G).steps]
    assert kinds == [
        "open_loop", "characteristic", "bilinear", "first_rows", "row", "row", "array", "stable",
        "signals", "unity", "final_value", "constants",
    ]  # fmt: skip
    second = error(HALF * (z + 1) / ((z - 1) * (z - HALF)), controller=K).steps
    (tests,) = (step for step in second if step.kind == "at_both_ends")
    assert [sp.expand(claim.right / 2) for claim in tests.claims.values()] == [K, 3, HALF - K / 2]
    (stable,) = (step for step in second if step.kind == "stable")
    assert stable.values["condition"] == sp.And(K > 0, K < 1)


@pytest.mark.parametrize(
    ("G", "reference", "said"),
    [
        (10 / (2 * z - 1), ONE, "1 root outside the unit circle"),
        (2 / (z - 1), ONE, "1 root on the unit circle"),
        (1 / (z**3 + z**2), ONE, "1 root outside the unit circle"),
        (-HALF / (z**2 * (z - HALF)), ONE, "on the unit circle"),
        (HALF / (z - HALF), sp.cos(k), "no limit"),
        (HALF / (z - HALF), (-1) ** k, "no limit"),
        (HALF / (z - HALF), 2**k, "no limit"),
    ],
)
def test_where_nothing_remains_the_reason_is_said(G, reference, said):
    result = error(G, reference)
    assert result.status is Status.UNSOLVED
    assert said in str(result.reason), result.reason


def test_what_is_in_the_loop_counts_though_it_cancels():
    result = error(1 / (z - 2), controller=(z - 2) / (2 * z))
    assert result.status is Status.UNSOLVED
    assert "1 root outside" in str(result.reason)


def test_disturbances_feedback_and_open_paths():
    G = 1 / (z - 1)
    both = error(G, 1 + k / 2, controller=sp.Rational(3, 10), disturbance=ONE)
    assert both.answers["error"] == -sp.Rational(5, 3)
    assert error(1 / (4 * z - 2), feedback=1 / z).answers["error"] == sp.Rational(2, 3)
    assert error(1 / (4 * z - 1), feedback=None).answers["error"] == sp.Rational(2, 3)
    assert error(1 / ((z - 1) * (2 * z + 1)), k, feedback=None).answers["error"] == -sp.oo
    late = error(1 / (z * (2 * z - 1)), sp.Heaviside(k - 3, 1) + sp.DiracDelta(k))
    assert late.status is Status.VERIFIED
    assert late.answers["error"] == HALF


def simulated(bottom, top, r, samples):
    """R − y of unity feedback by the recursion in fractions: y(k) a₀ = Σ b e − Σ a y, the textbook's way."""
    a, b = (list(map(Fraction, each)) for each in (bottom, [0] * (len(bottom) - len(top)) + list(top)))
    e, y = [], []
    for i in range(samples):
        past = sum(b[j] * e[i - j] - a[j] * y[i - j] for j in range(1, len(a)) if i >= j)
        y.append((past + b[0] * r(i)) / (a[0] + b[0]))
        e.append(Fraction(r(i)) - y[i])
        if i > 60:
            e[i], y[i] = e[i].limit_denominator(10**12), y[i].limit_denominator(10**12)
    return float(e[-1])


@settings(max_examples=15)
@given(st.lists(st.integers(-3, 3), min_size=1, max_size=2), st.integers(-2, 2), st.integers(0, 1), st.integers(1, 8))
def test_random_loops_settle_where_their_recursion_does(poles, zero, integrators, gain):
    bottom = [4.0 * c for c in np.poly([*(p / 4 for p in poles), *[1.0] * integrators])]
    top = [gain / 4, -gain * zero / 16]
    G = sp.Rational(gain, 4) * (z - sp.Rational(zero, 4)) / (
        4 * (z - 1) ** integrators * sp.Mul(*(z - sp.Rational(p, 4) for p in poles))
    )  # fmt: skip
    result = error(G, k if integrators else ONE)
    sizes = abs(np.roots(np.polyadd(bottom, top)))
    if max(sizes) > 1 - 1e-9:
        assert result.status is Status.UNSOLVED
        return
    if max(sizes) > 0.9:
        return
    assert result.status is Status.VERIFIED, result.reason
    late = simulated(bottom, top, (lambda i: i) if integrators else (lambda _: 1), 300)
    assert float(result.answers["error"]) == pytest.approx(late, rel=1e-6, abs=1e-6)


def open_loop(G, sample_time=ONE):
    closing = {"controller": None, "feedback": ONE}
    return yield_into([], converted(composed(plant(G, sample_time), closing), {"open_loop"}))


def test_corrupted_answers_are_rejected():
    loop = open_loop(HALF / (z - HALF))
    options = {"reference": ONE, "feedback": ONE}
    right = dict(error(HALF / (z - HALF)).answers)
    assert not rejected("steady_state_error", loop, right, **options)
    wrong = {
        "error": [ONE, sp.S.Zero, sp.oo, sp.zoo, HALF + sp.Rational(1, 10**8)],
        "system_type": [ONE],
        "position_constant": [-ONE, sp.oo, sp.zoo],
        "velocity_constant": [HALF, sp.oo, -sp.oo],
        "acceleration_constant": [ONE],
    }
    for name, values in wrong.items():
        for value in values:
            assert rejected("steady_state_error", loop, {name: value}, **options), (name, value)
    growing = {"reference": RAMP, "feedback": ONE}
    assert not rejected("steady_state_error", loop, {"error": sp.oo}, **growing)
    for value in (-sp.oo, sp.Integer(5), sp.Integer(0)):
        assert rejected("steady_state_error", loop, {"error": value}, **growing)
    integrating = open_loop(HALF / (z - 1), sp.Rational(1, 10))
    for name, value in (("velocity_constant", HALF), ("error", sp.Integer(2)), ("velocity_constant", sp.S.Zero)):
        assert rejected("steady_state_error", integrating, {name: value}, **growing), (name, value)


@pytest.mark.parametrize(("option", "signal"), [("reference", RAMP), ("disturbance", PARABOLA)])
def test_a_ramp_without_a_sampling_period_is_refused(option, signal):
    options = {"reference": ONE, "feedback": ONE, option: signal}
    (refusal,) = catalogue()["steady_state_error"].refused(plant(1 / (2 * z + 1)), options)
    assert refusal[0] == option
    assert "needs the sampling period" in str(refusal[1])
    assert not list(catalogue()["steady_state_error"].refused(plant(1 / (2 * z + 1), T), options))


PAPER = """\
system: {time: discrete, sample_time: 1/5, transfer_function: 3/(10(z - 1/2))}
find:
  a: {task: steady_state_error, answers: [error, system_type, position_constant]}
  b: {task: steady_state_error, reference: ramp, controller: z/(z - 1), answers: [error, velocity_constant]}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "verdict_", "named"),
    [
        ("a", "error", "0.625", "correct", ""),
        ("a", "error", "5/2", "wrong", "for $z \\to 0$"),
        ("a", "position_constant", "-3/5", "wrong", "for $z \\to 0$"),
        ("a", "error", "3/8", "wrong", "of the output"),
        ("a", "error", "5/3", "wrong", "is missing"),
        ("b", "velocity_constant", "3", "correct", ""),
        ("b", "velocity_constant", "0.6", "wrong", "sampling period is missing"),
        ("b", "error", "5/3", "wrong", "sampling period is missing"),
        ("b", "error", "0.333", "correct", ""),
    ],
)
def test_marking(part, name, value, verdict_, named):
    found = verdict(PAPER, part, name, value)
    assert found.verdict == verdict_, found.reason
    assert named in str(found.reason)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ("reference: ramq", "did you mean 'ramp'"),
        ("reference: t", "k"),
        ("controller: 1/s", "written in z"),
    ],
)
def test_bad_inputs_are_refused_at_their_place(options, said):
    part = f"{{task: steady_state_error, {options}}}"
    text = f"system: {{time: discrete, transfer_function: 1/(2z + 1)}}\nfind: {{a: {part}}}\n"
    with pytest.raises(InputError) as caught:
        read_problem(Source("a.yaml", text), catalogue())
    assert said in str(caught.value)
    assert "^" in str(caught.value)
