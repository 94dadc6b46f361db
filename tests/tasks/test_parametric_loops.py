"""Nyquist's criterion and margins of loops with letters: textbook formulas, the poles in numbers, corruptions."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from solver.derivation import CheckStatus, Status
from solver.lazy import Call, exact
from solver.postconditions import check_calls
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.tasks.test_stability_margins import loop_of, plant

s = sp.Symbol("s")
K, a, b, T = sp.symbols("K a b T", positive=True)
u = sp.Symbol("u", real=True)
LOOPS = [
    (K / (s * (s + 1) * (s + a)), a * (a + 1) > K),
    (K / (s + a) ** 3, 8 * a**3 > K),
    (K / (s - a), a < K),
    (K * (s + 1) / (s * (s - 1)), K > 1),
    (K / ((s - 1) * (s + 2) * (s + 3)), (K > 6) & (K < 10)),
    (K * (s + 2) ** 2 / s**3, K > 1),
    (K * (1 - a * s) / ((s + 1) * (s + 2)), 3 / a > K),
    (K * (s - 1) / (s + 1), K < 1),
    (K / (s * (s + 1) ** 2 * (T * s + 1)), K < 2 * (T + 1) ** 2 / (2 * T + 1) ** 2),
    (K * (s + 5) * (s + 40) / (s**3 * (s + 200) * (s + 1000)), None),
    (K / (s * (s**2 + 1)), sp.false),
    (K * (s + 1) / (s * (s**2 + 4)), sp.false),
    (K * (s + 1) / (a**2 + s**2), sp.true),
    (K * (s + b) / s**2, sp.true),
    (K / (s * (T * s + 1)), sp.true),
]


def values_of(formula):
    """Some values of its letters, of several sizes."""
    letters = sorted(formula.free_symbols - {s}, key=str)
    generator = np.random.default_rng(7)
    for _ in range(12):
        yield {x: sp.Rational(int(generator.integers(1, 999)), int(generator.choice([10, 100, 300]))) for x in letters}


@pytest.mark.parametrize(("L", "condition"), LOOPS)
def test_the_cases_count_the_poles_of_the_loop(L, condition):
    N, D = sp.fraction(sp.together(L))
    N, D = sp.expand(N), sp.expand(D)
    found = exact.parametric_turns(N, D, s)
    for at in values_of(L):
        roots = np.roots([float(c) for c in sp.Poly((N + D).subs(at), s).all_coeffs()])
        holding = [case for case in found.cases if sp.S.true in (case.condition, sp.sympify(case.condition).subs(at))]
        assert [case.closed_loop for case in holding] == [sum(root.real > 1e-9 for root in roots)]
    if condition is not None:
        both = sp.sympify(found.condition), condition
        assert all(both[0].subs(at) == both[1].subs(at) for at in values_of(L))


@pytest.mark.parametrize(("L", "condition"), LOOPS)
def test_both_tasks_are_verified_and_agree(L, condition):
    results = [ask(task, plant(L), feedback=None) for task in ("nyquist", "stability_margins")]
    assert [each.status for each in results] == [Status.VERIFIED] * 2
    conditions = [each.answers["condition"] for each in results]
    assert all(conditions[0].subs(at) == conditions[1].subs(at) for at in values_of(L))
    if condition in (sp.true, sp.false):
        assert [each.answers["stable"] for each in results] == [bool(condition)] * 2


@pytest.mark.parametrize("hidden", [s - 1, s**2 + 1])
def test_what_cancels_stays_a_pole_of_the_loop(hidden):
    found = exact.parametric_turns(sp.expand(K * hidden), sp.expand(s * (T * s + 1) * hidden), s)
    assert found.condition == sp.false


def test_margins_are_those_of_a_first_course():
    found = ask("stability_margins", plant(LOOPS[0][0]), feedback=None).answers
    assert found["phase_crossover"] == sp.sqrt(a)
    assert sp.cancel(found["gain_margin"] - a * (a + 1) / K) == 0
    assert "gain_crossover" not in found
    assert "phase_margin" not in found
    found = ask("stability_margins", plant(K / (s * (T * s + 1))), feedback=None).answers
    at = {K: 6, T: sp.Rational(1, 3)}
    crossover = float(found["gain_crossover"].subs(at))
    assert abs(6 / (1j * crossover * (1j * crossover / 3 + 1))) == pytest.approx(1)
    assert float(found["phase_margin"].subs(at)) == pytest.approx(90 - np.degrees(np.arctan(crossover / 3)))
    assert found["gain_margin"] == sp.oo


def test_the_phase_margin_of_an_unstable_loop_is_in_the_right_turn():
    found = ask("stability_margins", plant(K / (s * (s - a))), feedback=None).answers
    at = {K: 2, a: 3}
    crossover = float(found["gain_crossover"].subs(at))
    value = 2 / (1j * crossover * (1j * crossover - 3))
    assert float(found["phase_margin"].subs(at)) == pytest.approx(np.degrees(np.angle(value)) - 180)


@pytest.mark.parametrize(
    ("L", "reason"),
    [
        (u / (s * (s + 1)), "sign_not_known"),
        (K * (s + 1) / (s**2 * (s + a)), "sign_not_known"),
        (K / (s * (s + 1) * (s + u)), "stability_not_known"),
        (K / s**2, "real_with_parameters"),
        (K / (s**7 + a * s**6 + s**5 + b * s**4 + s**3 + s**2 + s + 1), "stability_not_known"),
    ],
)
def test_what_is_not_decided_says_what_is_missing(L, reason):
    result = ask("nyquist", plant(L), feedback=None)
    assert result.status is Status.UNSOLVED
    assert reason in result.reason.kind


def test_wrong_answers_are_seen():
    asked, right = plant(LOOPS[0][0]), ask("nyquist", plant(LOOPS[0][0]), feedback=None).answers
    assert not rejected("nyquist", loop_of(LOOPS[0][0]), dict(right))
    for wrong in ({"condition": a > K}, {"condition": a * (a + 1) + sp.Rational(1, 100) > K},
                  {"open_loop_unstable_poles": sp.Integer(1)}, {"real_axis_crossings": [-K / a]}):  # fmt: skip
        assert rejected("nyquist", loop_of(LOOPS[0][0]), {**right, **wrong})
    right = ask("stability_margins", asked, feedback=None).answers
    for wrong in ({"gain_margin": a * (a + 1)}, {"phase_crossover": a}, {"condition": a * (a + 1) < K}):
        assert rejected("stability_margins", loop_of(LOOPS[0][0]), {**right, **wrong})


PROBLEM = """
assume: {K: positive, a: positive}
system: {transfer_function: "K/(s(s + 1)(s + a))"}
find: {n: nyquist, m: stability_margins}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "right"),
    [
        ("n", "condition", "'K < a^2 + a'", True),
        ("n", "condition", "'0 < K and K < a(1 + a)'", True),
        ("n", "condition", "'K < a'", False),
        ("m", "gain_margin", "(a^2 + a)/K", True),
        ("m", "phase_crossover", "a", False),
        ("n", "real_axis_crossings", "[-K/(a + a^2)]", True),
    ],
)
def test_answers_with_letters_are_marked(part, name, value, right):
    assert verdict(PROBLEM, part, name, value).verdict.name == ("CORRECT" if right else "WRONG")


def statuses(name, arguments, result):
    return {check.status for check in check_calls([Call(name, arguments, {}, result, 1)], [])}


def test_what_must_hold_of_the_kernels_holds_of_right_results_only():
    L = exact.parametric_factors(K, sp.expand(s * (s + 1) * (s + a)), s)
    axis = exact.parametric_axis(L)
    crossings = exact.parametric_real_axis(axis)
    turns = exact.parametric_turns(K, sp.expand(s * (s + 1) * (s + a)), s)
    arguments = (K, sp.expand(s * (s + 1) * (s + a)), s)
    short = exact.parametric_axis(exact.parametric_factors(K, s * (T * s + 1), s))
    gains = exact.parametric_gain_crossovers(short)
    margin = (exact.parametric_factors(K, s * (T * s + 1), s), gains[0][0])
    right = exact.margin_in_turn(*margin)
    cases = (replace(turns.cases[0], closed_loop=2), turns.cases[1])
    for name, given, found, wrong in [
        ("parametric_axis", (L,), axis, exact.parametric_axis(exact.parametric_factors(2 * K, s * (s + 1), s))),
        ("parametric_real_axis", (axis,), crossings, (replace(crossings[0], turn=-1),)),
        ("parametric_real_axis", (axis,), crossings, (replace(crossings[0], value=-K / a),)),
        ("parametric_real_axis", (axis,), crossings, ()),
        ("parametric_turns", arguments, turns, replace(turns, cases=cases)),
        ("parametric_turns", arguments, turns, replace(turns, open_loop=1)),
        ("parametric_gain_crossovers", (short,), gains, ()),
        ("parametric_gain_crossovers", (short,), gains, ((2 * gains[0][0], gains[0][1]),)),
        ("margin_in_turn", margin, right, right - 360),
        ("margin_in_turn", margin, right, right + 1),
    ]:  # fmt: skip
        assert statuses(name, given, found) == {CheckStatus.PASSED}
        assert CheckStatus.FAILED in statuses(name, given, wrong)
