"""Least energy between two states: both methods, singular pairs, refusals, corruptions, students' answers."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

METHODS = ("variations", "gramian")
t, T = sp.symbols("t T")
ONE = sp.ImmutableMatrix([[1]])
CHAIN = system([[0, 1], [0, 0]], B=[[0], [1]])
TURNING = system([[0, 1], [-1, 0]], B=[[0], [1]])
SPLIT = system([[-1, 0], [0, -2]], B=[[1], [0]])


def column(*entries):
    return sp.ImmutableMatrix([sp.sympify(entry) for entry in entries])


def transfer(start, end=(0, 0), time=1, **others):
    return {"initial_state": column(*start), "final_state": column(*end), "final_time": sp.sympify(time), **others}


@pytest.mark.parametrize("method", METHODS)
def test_the_example_of_the_course(method):
    result = ask("minimum_energy_control", CHAIN, method, **transfer((1, 1)))
    assert result.status is Status.VERIFIED, result.reason
    assert sp.expand(result.answers["u"] - (18 * t - 10)) == 0
    assert (result.answers["x"] - column(1 + t - 5 * t**2 + 3 * t**3, 1 - 10 * t + 9 * t**2)).expand().is_zero_matrix
    assert result.answers["cost"] == 14


def test_costates_and_conditions_are_those_of_the_hamiltonian():
    answers = ask("minimum_energy_control", CHAIN, "variations", **transfer((1, 1))).answers
    assert [sp.expand(each) for each in answers["costates"]] == [18, 10 - 18 * t]
    names = sp.symbols("lambda1 lambda2 lambda1_dot lambda2_dot x1_dot x2_dot x2 u")
    first, second, first_rate, second_rate, x1_rate, x2_rate, x2, u = names
    wanted = [first_rate, second_rate + first, second + u, x1_rate - x2, x2_rate - u]
    assert [sp.expand(a - b) for a, b in zip(answers["equations"], wanted, strict=True)] == [0] * 5


def test_constants_are_found_from_both_ends():
    steps = ask("minimum_energy_control", CHAIN, "variations", **transfer((1, 1))).steps
    assert [step.kind for step in steps] == [
        "hamiltonian", "costate_equations", "stationary", "costates", "states", "ends", "control", "motion", "cost",
    ]  # fmt: skip
    ends = next(step for step in steps if step.kind == "ends")
    assert [value for _, value in ends.values["found"]] == [18, 10]


def test_the_gramian_is_the_integral():
    weight = sp.ImmutableMatrix([[4]])
    W = ask("minimum_energy_control", CHAIN, "gramian", **transfer((1, 0), R=weight)).answers["gramian"]
    assert sp.ImmutableMatrix([[1, sp.Rational(3, 2)], [sp.Rational(3, 2), 3]]) / 12 == W


def test_symbols_stand_where_numbers_do():
    x0, v0 = sp.symbols("x_0 v_0")
    result = ask("minimum_energy_control", CHAIN, "gramian", **transfer((x0, v0), time=T))
    assert result.status is Status.VERIFIED, result.reason
    here = result.answers["u"].subs({x0: 1, v0: 1, T: 1})
    assert sp.expand(here - (18 * t - 10)) == 0


def test_an_undamped_oscillator_is_pushed_in_phase():
    result = ask("minimum_energy_control", TURNING, **transfer((1, 0), time=2 * sp.pi))
    assert result.answers["u"] == sp.sin(t) / sp.pi
    assert result.answers["cost"] == 1 / (2 * sp.pi)


@pytest.mark.parametrize("method", METHODS)
def test_a_state_in_reach_of_an_uncontrollable_pair(method):
    result = ask("minimum_energy_control", SPLIT, method, **transfer((1, 0)))
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["u"] + 2 * sp.exp(t) / (sp.E**2 - 1)).equals(0)


@pytest.mark.parametrize("method", METHODS)
def test_a_state_out_of_reach_is_said_to_be(method):
    result = ask("minimum_energy_control", SPLIT, method, **transfer((1, 1)))
    assert result.status is Status.UNSOLVED
    words = str(result.reason)
    assert "not controllable" in words
    assert "0 & 1" in words


def test_what_follows_the_free_motion_is_in_reach():
    result = ask("minimum_energy_control", SPLIT, **transfer((1, 1), (0, sp.exp(-2))))
    assert result.status is Status.VERIFIED, result.reason


def test_the_factor_changes_costates_and_cost_and_not_the_control():
    half, whole = (
        ask("minimum_energy_control", CHAIN, **transfer((1, 1), cost_factor=sp.sympify(factor))).answers
        for factor in ("1/2", 1)
    )
    assert whole["cost"] == 2 * half["cost"]
    assert whole["u"] == half["u"]
    assert [sp.expand(a - 2 * b) for a, b in zip(whole["costates"], half["costates"], strict=True)] == [0, 0]


entries = st.integers(-1, 1)


@tried(5)
@given(st.lists(entries, min_size=6, max_size=6), st.lists(entries, min_size=4, max_size=4))
def test_the_control_arrives_when_it_is_simulated(numbers, ends):
    A, B = np.array(numbers[:4], dtype=float).reshape(2, 2), np.array(numbers[4:], dtype=float).reshape(2, 1)
    if abs(np.linalg.det(np.hstack([B, A @ B]))) < 0.5:
        return
    plant = system(A.astype(int).tolist(), B=B.astype(int).tolist())
    result = ask("minimum_energy_control", plant, **transfer(ends[:2], ends[2:]))
    assert result.status is Status.VERIFIED, result.reason
    u = sp.lambdify(t, result.answers["u"])
    end = solve_ivp(lambda s, x: A @ x + B[:, 0] * u(s), (0, 1), ends[:2], rtol=1e-10, atol=1e-12).y[:, -1]
    size = max(1.0, *(abs(complex(u(s))) for s in np.linspace(0, 1, 9)))
    assert np.abs(end - ends[2:]).max() < 1e-6 * size


@pytest.mark.parametrize("weights", [{}, {"R": sp.ImmutableMatrix([[2, 1], [1, 2]])}])
def test_modes_in_decimals_are_led_to_the_end_by_both_methods(weights):
    plant = system([[0, 1, 0], [0, 0, 1], [-1, -1, 0]], B=[[0, 1], [0, 0], [1, 0]] if weights else [[0], [0], [1]])
    asked = transfer((1, 0, 0), (0, 0, 0), **weights)
    found = [ask("minimum_energy_control", plant, method, **asked) for method in METHODS]
    assert [each.status for each in found] == [Status.VERIFIED] * 2
    assert abs(found[0].answers["cost"] - found[1].answers["cost"]) < 1e-12 * abs(found[0].answers["cost"])


def test_corrupted_answers_are_rejected():
    asked = transfer((1, 1))
    answers = ask("minimum_energy_control", CHAIN, "variations", **asked).answers
    spoilt = [-each if i else 2 * each + t for i, each in enumerate(answers["equations"])]
    wrong = {
        "u": [-answers["u"], answers["u"] + t * (1 - t), 1.0001 * answers["u"]],
        "x": [-answers["x"], answers["x"] + column(t**2 * (1 - t) ** 2, 0)],
        "cost": [28, 14.001],
        "costates": [[-each for each in answers["costates"]], [36, 20 - 36 * t], answers["costates"][::-1]],
        "equations": [answers["equations"][:-1], spoilt],
    }
    for name, values in wrong.items():
        assert not rejected("minimum_energy_control", CHAIN, {name: answers[name]}, **asked)
        for value in values:
            assert rejected("minimum_energy_control", CHAIN, {name: value}, **asked), name


def test_a_control_that_arrives_and_costs_more_is_rejected():
    dearer = 18 * t - 10 + 5 * (20 * t**3 - 30 * t**2 + 12 * t - 1)
    assert rejected("minimum_energy_control", CHAIN, {"u": dearer}, **transfer((1, 1)))


def test_corrupted_gramians_are_rejected():
    asked = transfer((1, 1))
    W = ask("minimum_energy_control", CHAIN, "gramian", **asked).answers["gramian"]
    assert not rejected("minimum_energy_control", CHAIN, {"gramian": W}, **asked)
    for wrong in (-W, W + sp.eye(2) / 1000, W.inv()):
        assert rejected("minimum_energy_control", CHAIN, {"gramian": sp.ImmutableMatrix(wrong)}, **asked)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("initial_state: [1, 0]", "final_time"),
        ("final_time: 1", "where the motion begins or ends"),
        ("initial_state: [1, 0], final_time: 0", "final_time must be positive"),
        ("initial_state: [1, 0], final_time: 1, R: -1", "R must be positive definite"),
        ("initial_state: [1, 0, 0], final_time: 1", "2 rows"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(options, words):
    text = f"system: {{A: [[0, 1], [0, 0]], B: [0, 1]}}\nfind:\n  a: {{task: minimum_energy_control, {options}}}\n"
    with pytest.raises(Exception, match=words):
        solve(text)


def test_discrete_time_is_refused():
    text = (
        "system: {A: [[0, 1], [0, 0]], B: [0, 1], time: discrete}\n"
        "find:\n  a: {task: minimum_energy_control, initial_state: [1, 0], final_time: 1}\n"
    )
    with pytest.raises(Exception, match="time"):
        solve(text)
