"""Loops around a dead time: what remains of errors, sensitivity, what cancels in L, against simulation and by hand."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Status
from solver.lazy import Call, exact
from solver.postconditions import check_calls
from solver.systems import DeadTime, OpenLoop, TransferFunction
from tests.helpers.asking import ask, rejected

s, t, K, a = sp.symbols("s t K a")
T = sp.Symbol("T", positive=True)
ONE = sp.Integer(1)
LAG = 1 / (s + 1)


def plant(G, delay=ONE):
    top, bottom = (sp.Poly(each, s).as_expr() for each in sp.fraction(sp.together(G)))
    return DeadTime(TransferFunction(sp.ImmutableMatrix([[sp.cancel(G)]]), ((top,),), ((bottom,),), s), sp.S(delay))


def loop(G, feedback=ONE):
    rational = plant(G).rational
    return OpenLoop(rational, rational, ONE, ONE, sp.cancel(G), ONE, closed=feedback is not None)


def error(G, delay=ONE, method="final_value", **options):
    return ask("steady_state_error", plant(G, delay), method, **{"reference": ONE, "feedback": ONE, **options})


@pytest.mark.parametrize(
    ("G", "delay", "options", "wanted"),
    [
        (2 * LAG, 1, {}, sp.Rational(1, 3)),
        (sp.Rational(1, 2) / s, 1, {"reference": t}, 2),
        (sp.Rational(1, 2) / s, 1, {"reference": t, "disturbance": ONE}, 1),
        (LAG, 1, {"reference": t}, sp.oo),
        (LAG, 1, {"reference": t, "feedback": None}, 2),  # the dead time adds itself to the error of the ramp
        (2 / (s - 1), sp.Rational(1, 10), {}, -1),  # unstable without feedback
        (LAG, 1, {"feedback": 2 / (s + 3)}, sp.Rational(2, 5)),
        (LAG, 1, {"reference": 1 + sp.exp(-t)}, sp.Rational(1, 2)),
        (1 / s, sp.pi / 4, {"reference": t}, 1),
    ],
)
def test_errors_of_late_loops(G, delay, options, wanted):
    result = error(G, delay, **options)
    assert result.status is Status.VERIFIED
    assert not any(check.status.value == "skipped" for check in result.checks)
    assert result.answers["error"] == wanted


def test_the_steps_and_both_methods():
    result = error(2 * LAG)
    kinds = [step.kind for step in result.steps]
    assert kinds == ["open_loop", "characteristic", "on_axis", "late_crossovers", "counted", "signals", "unity",
                     "final_value", "constants"]  # fmt: skip
    assert error(2 * LAG, method="error_constants").answers == result.answers


def test_errors_with_letters_without_feedback():
    positive = sp.Symbol("a", positive=True)
    result = error(positive / (s + positive), T, reference=t, feedback=None)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["error"] - (T + 1 / positive)) == 0


GAIN, FALLING = sp.Symbol("K", positive=True), sp.Symbol("K", negative=True)


@pytest.mark.parametrize(
    ("G", "delay", "options", "wanted", "low", "high"),
    [
        (GAIN / s, 1, {"reference": t}, 1 / GAIN, 0, math.pi / 2),
        (GAIN * LAG, 1, {}, 1 / (1 + GAIN), 0, 2.26182633411465),  # tan ω = −ω, K² = 1 + ω²
        (FALLING * LAG, 1, {}, 1 / (1 + FALLING), -1, 0),
        (GAIN / (s - 1), sp.Rational(1, 2), {}, 1 / (1 - GAIN), 1, 2.53655898923060),  # tan(ω/2) = ω
    ],
)
def test_errors_of_late_loops_with_a_gain(G, delay, options, wanted, low, high):
    result = error(G, delay, **options)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["error"] - wanted) == 0
    condition = next(step for step in result.steps if step.kind == "for_gains").values["found"].condition
    (K,) = G.free_symbols - {s}
    edges = [(low, high - low, (-0.01, 0.01)), (high, high - low, (0.01, -0.01))]
    for edge, width, (outside, inside) in edges:
        if edge:
            assert condition.subs(K, edge + inside * width) == sp.true
            assert condition.subs(K, edge + outside * width) == sp.false


def test_a_late_loop_that_no_gain_makes_stable_says_so():
    result = error(GAIN * (s + 2) / (s**2 + 1), 3)
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == "loops/unstable_late"
    assert error(sp.Symbol("K", real=True) * LAG).reason.kind == "frequency/sign_not_known"
    assert error(GAIN / (s + T)).reason.kind == "frequency/parameters"


def test_what_must_hold_of_gains_of_late_loops():
    arguments = (GAIN, s + 1, s, ONE)
    found = exact.late_gains(*arguments)
    less = replace(found, critical=(replace(found.critical[0], poles=1),))
    for wrong in (None, replace(found, small=1), replace(found, condition=GAIN < 3), replace(found, condition=GAIN < 2),
                  less):  # fmt: skip
        calls = [Call("late_gains", arguments, {}, wrong or found, 1)]
        failed = CheckStatus.FAILED in {check.status for check in check_calls(calls, [])}
        assert failed == (wrong is not None)


def test_an_unstable_late_loop_has_no_error():
    result = error(3 * LAG)
    assert result.status is Status.UNSOLVED
    assert "2 of its poles lie in the right half plane" in str(result.reason)
    assert "passes through" in str(error(2 / s, sp.pi / 4).reason)
    assert "no limit" in str(error(LAG, reference=sp.sin(t)).reason)


def test_corrupted_errors_of_late_loops_are_rejected():
    asked = {"reference": ONE, "feedback": ONE}
    assert not rejected("steady_state_error", loop(2 * LAG), {"error": sp.Rational(1, 3)}, **asked)
    for wrong in (sp.Rational(1, 2), sp.S.Zero, sp.oo, sp.Rational(33, 100)):
        assert rejected("steady_state_error", loop(2 * LAG), {"error": wrong}, **asked)
    ramp = {"reference": t, "feedback": None}
    for wrong in (sp.S.Zero, ONE, sp.oo):
        assert rejected("steady_state_error", loop(LAG, None), {"error": wrong}, **ramp)


def test_what_cancels_in_a_late_loop_stays_a_pole_of_it():
    for hidden, stable in ((s, False), (s**2 + 1, False), (s - 1, False), (s + 2, True)):
        G = TransferFunction(sp.ImmutableMatrix([[LAG / 2]]), ((hidden / 2,),), ((sp.expand(hidden * (s + 1)),),), s)
        for task in ("stability_margins", "nyquist"):
            result = ask(task, DeadTime(G, ONE))
            assert result.status is Status.VERIFIED
            assert result.answers["stable"] is stable


def test_the_sensitivity_is_written_with_the_dead_time_above():
    result = ask("sensitivity", plant(LAG), feedback=ONE)
    assert str(result.answers["S"]) == "(s + 1)/(s + 1 + exp(-s))"
    of_K = ask("sensitivity", plant(K * LAG), feedback=ONE, parameter="K")
    assert of_K.status is Status.VERIFIED
    assert of_K.answers["S"] == (s + 1) / (K * sp.exp(-s) + s + 1)


def test_multiple_poles_and_sharp_tops_are_judged():
    assert ask("bode", plant((1 + s / 10) / (s * (1 + s) ** 3), sp.Rational(1, 10))).status is Status.VERIFIED
    sharp = ask("frequency_response", plant(1 / (s * (s + 1)), 0).rational, controller=sp.Integer(10), feedback=ONE)
    assert sharp.status is Status.VERIFIED
    assert sharp.answers["resonant_frequency"] == sp.sqrt(38) / 2


@pytest.mark.parametrize(
    ("C", "H", "wanted", "says"),
    [
        (sp.Integer(2), ONE, sp.Rational(2, 3), "is stable"),
        (sp.Integer(3), ONE, sp.Rational(3, 4), "is not stable"),
        (1 / (4 * s), sp.Integer(3), sp.Rational(1, 3), "is stable"),
        (K, ONE, K / (K + 1), "Where the loop is stable"),
    ],
)
def test_the_dc_gain_of_a_late_loop(C, H, wanted, says):
    result = ask("dc_gain", plant(LAG), controller=C, feedback=H)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["dc_gain"] - wanted) == 0
    stable = next(step for step in result.steps if step.kind == "late_meaning").values["stable"]
    assert {True: "is stable", False: "is not stable", None: "Where the loop is stable"}[stable] == says


def test_a_controller_before_a_dead_time_is_a_path():
    after = ask("response", plant(LAG), kind="zero_state", input=(ONE,), controller=sp.Integer(2))
    assert after.status is Status.VERIFIED
    assert after.answers["y_final"] == 2
    form = ask("pole_zero_form", plant(LAG), controller=(s + 2) / s)
    assert form.status is Status.VERIFIED
    assert sorted(form.answers["poles"]) == [-1, 0]
    assert form.answers["zeros"] == [-2]


@pytest.mark.parametrize("task", ["time_constants", "step_specifications", "pole_zero_form", "response"])
def test_what_a_late_loop_cannot_be_asked_names_what_can(task):
    options = {"kind": "zero_state", "input": (ONE,)} if task == "response" else {}
    result = ask(task, plant(LAG), controller=ONE, feedback=ONE, **options)
    assert result.status is Status.UNSOLVED
    assert all(name in str(result.reason) for name in ("stability_margins", "dc_gain", "steady_state_error"))


@pytest.mark.parametrize(("C", "H"), [(sp.Integer(2), ONE), (ONE, 1 / (s + 2)), (1 / (4 * s), sp.Integer(3))])
def test_the_frequency_response_of_a_late_loop_at_a_frequency(C, H):
    result = ask("frequency_response", plant(LAG), controller=C, feedback=H, frequency=sp.Integer(2))
    assert result.status is Status.VERIFIED
    F = complex((C * LAG * sp.exp(-s)).subs(s, 2j))
    T = F / (1 + F * complex(sp.S(H).subs(s, 2j)))
    assert float(result.answers["magnitude"]) == pytest.approx(abs(T))
    assert float(result.answers["phase"]) == pytest.approx(math.degrees(cmath.phase(T)))


def test_the_steady_answer_of_a_late_loop_to_a_sinusoid():
    asked = {"controller": sp.Integer(2), "feedback": ONE, "input": 3 * sp.sin(t)}
    result = ask("frequency_response", plant(LAG), **asked)
    assert result.status is Status.VERIFIED
    assert "late_crossovers" in [step.kind for step in result.steps]
    y, T = result.answers["y_steady_state"], 2 * cmath.exp(-1j) / (1 + 1j + 2 * cmath.exp(-1j))
    for at in (0.0, 1.3):
        assert float(y.subs(t, at)) == pytest.approx((3 * T * cmath.exp(1j * at)).imag)
    unstable = ask("frequency_response", plant(LAG), **{**asked, "controller": sp.Integer(3)})
    assert "never_steady_late" in unstable.reason.kind
