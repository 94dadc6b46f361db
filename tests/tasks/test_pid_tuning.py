"""PID controllers: Ogata's examples, generated plants against numpy, refusals in words, corruptions, marking."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import given_of
from solver.problem.model import Part
from solver.systems import DeadTime, StateSpace
from solver.tasks import catalogue
from tests.helpers.asking import ask, system
from tests.helpers.tried import tried
from tests.tasks.test_model_matching import plant

s = sp.Symbol("s")
r = sp.Rational
ULTIMATE, STEP, PLACING = "ziegler_nichols_ultimate", "ziegler_nichols_step", "pole_placement"
OGATA = plant(sp.Integer(1), s * (s + 1) * (s + 5))


def tuned(G, method=ULTIMATE, **options):
    return ask("pid_tuning", G, method, **{"controller_type": "PID", **options})


def judged(G, method, answers, **options):
    """The statuses of the checks of some answers."""
    task = catalogue()["pid_tuning"]
    filled = {"controller_type": "PID", **options}
    given = given_of(Part("a", "pid_tuning", (method,), G, filled), method, {})
    return {check.status for check in task.verify(given, Answers(**answers))}


def test_ogatas_example_of_the_ultimate_gain():
    result = tuned(OGATA)
    assert result.status is Status.VERIFIED, result.reason
    assert [step.kind for step in result.steps] == [
        "polynomial", "axis", "crossings", "intervals", "period", "table", "controller", "closed_loop",
    ]  # fmt: skip
    answers = result.answers
    assert (answers["K_u"], answers["K_p"]) == (30, 18)
    assert answers["T_u"] == 2 * sp.sqrt(5) * sp.pi / 5
    assert float(answers["K_i"]) == pytest.approx(18 / 1.405, rel=1e-3)  # Ogata, example 8-1
    assert float(answers["K_d"]) == pytest.approx(18 * 0.35124, rel=1e-4)
    at_two = answers["controller"].subs(s, 2)
    assert float(at_two) == pytest.approx(float(18 + answers["K_i"] / 2 + 2 * answers["K_d"]))


@pytest.mark.parametrize(
    ("kind", "gain", "T_i", "T_d"), [("P", 0.5, None, 0), ("PI", 0.45, 1 / 1.2, 0), ("PID", 0.6, 0.5, 0.125)]
)
def test_the_table_of_the_ultimate_gain(kind, gain, T_i, T_d):
    answers = tuned(plant(sp.Integer(1), (s + 1) ** 3), controller_type=kind).answers
    K, T = 8, 2 * np.pi / np.sqrt(3)
    assert float(answers["K_p"]) == pytest.approx(gain * K)
    assert float(answers["K_i"]) == pytest.approx(gain * K / (T_i * T) if T_i else 0)
    assert float(answers["K_d"]) == pytest.approx(gain * K * T_d * T)


@tried(12)
@given(st.lists(st.integers(1, 6), min_size=3, max_size=4), st.integers(1, 5))
def test_the_loop_is_at_its_limit_with_the_ultimate_gain(poles, gain):
    D = sp.prod([s + p for p in poles])
    result = tuned(plant(sp.Integer(gain), D), controller_type="PI")
    assert result.status is Status.VERIFIED, result.reason
    K, T = float(result.answers["K_u"]), float(result.answers["T_u"])
    coefficients = np.array(sp.Poly(D, s).all_coeffs(), dtype=float)
    coefficients[-1] += K * gain
    roots = np.roots(coefficients)
    pair = [r for r in roots if abs(abs(r.imag) - 2 * np.pi / T) < 1e-6 and abs(r.real) < 1e-6]
    assert len(pair) == 2
    assert all(r.real < 0 for r in roots if abs(r.real) > 1e-6)


def test_a_loop_that_is_stable_between_two_gains():
    G = plant(s + 1, s * (s - 1) * (s**2 + 4 * s + 16))
    result = tuned(G)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K_u"] == (59 + 3 * sp.sqrt(17)) / 2  # Ogata, example 7-4: 23.3 < K < 35.7
    [intervals] = [step.values["intervals"] for step in result.steps if step.kind == "intervals"]
    assert [each.outside for each in intervals] == [2, 0, 2]


@pytest.mark.parametrize(
    ("G", "why"),
    [
        (plant(sp.Integer(1), (s + 1) * (s + 2)), "stays stable"),
        (plant(sp.Integer(1), s**3), "not stable for any"),
        (plant(1 - s, s + 1), "infinity"),
        (plant(sp.Integer(-1), (s + 1) ** 3), "origin"),
        (plant(sp.Symbol("a"), (s + 1) ** 3), "numbers"),
    ],
)
def test_where_there_is_no_ultimate_gain_it_is_said_why(G, why):
    result = tuned(G)
    assert result.status is Status.UNSOLVED
    assert why in str(result.reason)


def test_the_reaction_curve_of_three_equal_lags():
    result = tuned(plant(sp.Integer(2), (s + 1) ** 3), STEP)
    assert result.status is Status.VERIFIED, result.reason
    [tangent] = [step for step in result.steps if step.kind == "tangent"]
    assert tangent.values["time"] == 2
    R, L = 4 * np.exp(-2), 4.5 - np.exp(2) / 2
    assert float(result.answers["K_p"]) == pytest.approx(1.2 / (R * L))
    assert float(result.answers["K_i"]) == pytest.approx(1.2 / (R * L) / (2 * L))
    assert float(result.answers["K_d"]) == pytest.approx(0.6 / R)


def test_a_plant_that_integrates_tends_to_its_tangent():
    result = tuned(OGATA, STEP, controller_type="P")
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K_p"] == sp.Rational(25, 6)  # R = 1/5, L = 1 + 1/5
    assert (result.answers["K_i"], result.answers["K_d"]) == (0, 0)


@pytest.mark.parametrize(
    ("G", "why"),
    [
        (plant(sp.Integer(1), s + 1), "without a dead time"),
        (plant(sp.Integer(1), s**2 + s + 4), "beyond its final value"),
        (plant(sp.Integer(1), s - 1), "not stable"),
        (plant(s + 2, s + 1), "at once"),
    ],
)
def test_where_there_is_no_reaction_curve_it_is_said_why(G, why):
    result = tuned(G, STEP)
    assert result.status is Status.UNSOLVED
    assert why in str(result.reason)


def test_a_measured_tangent_may_hold_letters():
    R, L = sp.symbols("R L")
    result = tuned(system([[0]]), STEP, slope=R, dead_time=L)
    assert result.status is Status.VERIFIED, result.reason
    assert sp.simplify(result.answers["K_p"] - sp.Rational(6, 5) / (R * L)) == 0
    assert sp.simplify(result.answers["K_d"] - sp.Rational(3, 5) / R) == 0


@tried(15)
@given(st.integers(-3, 3), st.integers(-3, 3), st.integers(1, 4), st.lists(st.integers(-6, -1), min_size=3, max_size=3))
def test_three_poles_are_placed_by_three_gains(a1, a0, b, poles):
    result = tuned(plant(sp.Integer(b), s**2 + a1 * s + a0), PLACING, poles=tuple(map(sp.Integer, poles)))
    assert result.status is Status.VERIFIED, result.reason
    K_p, K_i, K_d = (result.answers[name] for name in ("K_p", "K_i", "K_d"))
    loop = s * (s**2 + a1 * s + a0) + b * (K_d * s**2 + K_p * s + K_i)
    assert sp.expand(loop - sp.prod([s - p for p in poles])) == 0


def test_a_first_order_plant_in_letters():
    a, b, p, q = sp.symbols("a b p q")
    result = tuned(plant(b, s + a), PLACING, controller_type="PI", poles=(-p, -q))
    assert result.status is Status.VERIFIED, result.reason
    assert sp.simplify(result.answers["K_p"] - (p + q - a) / b) == 0
    assert sp.simplify(result.answers["K_i"] - p * q / b) == 0


def test_poles_out_of_reach_and_gains_that_are_not_fixed():
    G = plant(sp.Integer(1), s**2 + 2 * s + 5)
    result = tuned(G, PLACING, controller_type="PI", poles=(-2 + 2 * sp.I, -2 - 2 * sp.I, sp.Integer(-10)))
    assert "cannot be had" in str(result.reason)
    result = tuned(plant(sp.Integer(1), s + 5), PLACING, poles=(sp.Integer(-1), sp.Integer(-2)))
    assert "more than one choice" in str(result.reason)


@pytest.mark.parametrize(
    ("options", "place"),
    [
        ({}, ""),
        ({"slope": sp.Integer(1)}, "slope"),
        ({"slope": sp.Integer(1), "dead_time": sp.Integer(0)}, "dead_time"),
        ({"slope": sp.Integer(0), "dead_time": sp.Integer(1)}, "slope"),
    ],
)
def test_half_a_question_is_refused_at_its_place(options, place):
    none = StateSpace(sp.ImmutableMatrix(sp.zeros(0, 0)), bare=True)
    faults = list(catalogue()["pid_tuning"].refused(none, {"controller_type": "PID", **options}))
    assert [where for where, _ in faults] == [place]


def test_too_few_poles_are_refused():
    options = {"controller_type": "PID", "poles": (sp.Integer(-1),)}
    [(place, reason)] = catalogue()["pid_tuning"].refused(OGATA, options)
    assert place == "poles"
    assert "4 poles" in str(reason)


QUESTIONS = [
    (OGATA, ULTIMATE, {}),
    (plant(sp.Integer(2), (s + 1) ** 3), STEP, {}),
    (plant(sp.Integer(4), s * (s + 2)), PLACING, {"poles": (-2 + 2 * sp.I, -2 - 2 * sp.I, sp.Integer(-10))}),
]


@pytest.mark.parametrize(("G", "method", "options"), QUESTIONS)
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(G, method, options):
    answers = tuned(G, method, **options).answers
    for name, value in answers.items():
        assert judged(G, method, {name: value}, **options) == {CheckStatus.PASSED}
        for corrupted in (-value, 2 * value, value * (1 + sp.Rational(1, 10**8)), value + 1, 1 / value):
            assert judged(G, method, {name: corrupted}, **options) == {CheckStatus.FAILED}, (name, corrupted)


def late(G, delay):
    """A plant with a dead time."""
    return DeadTime(G, delay)


@pytest.mark.parametrize(("delay", "lag"), [(1, 1), (r(1, 2), 3), (2, r(1, 2))])
def test_a_lag_with_a_dead_time_oscillates_where_the_phase_says(delay, lag):
    result = tuned(late(plant(sp.Integer(2), lag * s + 1), sp.sympify(delay)))
    assert result.status is Status.VERIFIED, result.reason
    omega = 2 * np.pi / float(result.answers["T_u"])
    assert omega * float(delay) + np.arctan(omega * float(lag)) == pytest.approx(np.pi)
    assert float(result.answers["K_u"]) == pytest.approx(np.hypot(1, omega * float(lag)) / 2)


def test_an_unstable_plant_with_a_dead_time_oscillates_at_its_second_limit():
    G = late(plant(sp.Integer(1), s - 1), r(1, 10))
    answers = tuned(G).answers
    assert float(answers["K_u"]) == pytest.approx(15.0775, rel=1e-4)  # stable for 1 < K < 15.08
    assert judged(G, ULTIMATE, {"K_u": answers["K_u"] * 2}) == {CheckStatus.FAILED}
    assert "not stable" in str(tuned(late(plant(sp.Integer(1), s**2 + 1), r(1, 10))).reason)


def test_powers_of_e_are_one_quotient():
    found = tuned(plant(sp.Integer(1), (s + 1) ** 3), STEP).answers
    e = sp.exp(2)
    assert found["K_d"] == 3 * e / 10
    assert found["K_p"] == 6 * e / (45 - 5 * e)
    assert found["K_i"] == 6 * e / (405 - 90 * e + 5 * e**2)
