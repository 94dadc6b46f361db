"""Regulators over a finite horizon: scalars, plants, N steps, limits, refusals, corruptions, against scipy."""

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

METHODS = ("riccati", "hamiltonian")
t, T = sp.symbols("t T")
ONE, I2 = sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix(sp.eye(2))
CHAIN = system([[0, 1], [0, 0]], B=[[0], [1]])
SAMPLED = system([[1, 1], [0, 1]], B=[[0], [1]], discrete=True)


def one(a, b=1):
    return system([[a]], B=[[b]])


def matrix(*rows):
    return sp.ImmutableMatrix(rows)


def backwards(A, B, Q, R, S, length):
    """P at the beginning of a horizon, by scipy."""
    n = len(A)
    G = B @ np.linalg.solve(R, B.T)

    def slope(_, flat):
        P = flat.reshape(n, n)
        return (A.T @ P + P @ A - P @ G @ P + Q).ravel()

    return solve_ivp(slope, (0, length), np.ravel(S).astype(float), rtol=1e-11, atol=1e-13).y[:, -1].reshape(n, n)


@pytest.mark.parametrize("method", METHODS)
def test_the_exercise_of_the_course(method):
    asked = {"Q": matrix([3]), "R": ONE, "final_time": sp.Integer(1), "initial_state": matrix([1])}
    result = ask("finite_horizon_lqr", one(-1), method, **asked)
    assert result.status is Status.VERIFIED, result.reason
    right = 3 * (1 - sp.exp(4 * t - 4)) / (3 + sp.exp(4 * t - 4))
    for name in ("P", "K"):
        assert sp.simplify((result.answers[name][0, 0] - right).rewrite(sp.exp)) == 0
    assert result.answers["P_infinite"] == matrix([1])
    assert abs(float(result.answers["cost"]) - float(right.subs(t, 0)) / 2) < 1e-12


def test_separation_is_shown_step_by_step():
    asked = {"Q": matrix([3]), "R": ONE, "terminal_weight": matrix([2]), "final_time": sp.Integer(1)}
    steps = ask("finite_horizon_lqr", one(1), **asked).steps
    kinds = [step.kind for step in steps]
    assert kinds[:6] == ["weights", "equations", "backwards", "factors", "separated", "integrated"]
    assert steps[3].values["upper"] == 3
    assert steps[3].values["lower"] == -1


@pytest.mark.parametrize(
    ("plant", "Q", "S", "kind", "P"),
    [
        (one(0), 0, 1, "double", 1 / (3 - t)),
        (one(1), 3, 3, "rest", sp.Integer(3)),
        (one(1), 0, 0, "rest", sp.Integer(0)),
        (one(-1, 0), 2, 0, "linear", 1 - sp.exp(2 * t - 4)),
        (one(0), 4, 0, "integrated", 2 * sp.tanh(4 - 2 * t)),
    ],
)
def test_special_scalar_equations(plant, Q, S, kind, P):
    asked = {"Q": matrix([Q]), "R": ONE, "terminal_weight": matrix([S]), "final_time": sp.Integer(2)}
    result = ask("finite_horizon_lqr", plant, "riccati", **asked)
    assert result.status is Status.VERIFIED, result.reason
    assert kind in [step.kind for step in result.steps]
    found = result.answers["P"][0, 0]
    assert all(abs(complex((found - P).subs(t, at).evalf())) < 1e-12 for at in (0, sp.Rational(3, 7), 2))


@pytest.mark.parametrize("method", METHODS)
def test_the_double_integrator_has_a_short_form(method):
    result = ask("finite_horizon_lqr", CHAIN, method, Q=I2, R=ONE, final_time=T)
    assert result.status is Status.VERIFIED, result.reason
    r3 = sp.sqrt(3)
    D = 2 + sp.cosh(r3 * (T - t))
    wanted = matrix([r3 * sp.sinh(r3 * (T - t)) / D, (sp.cosh(r3 * (T - t)) - 1) / D])
    assert (result.answers["P"][0, :] - wanted).applyfunc(sp.expand).is_zero_matrix
    assert result.answers["P_infinite"] == matrix([r3, 1], [1, r3])


def test_the_equations_are_the_entries():
    answers = ask("finite_horizon_lqr", CHAIN, Q=I2, R=ONE, final_time=sp.Integer(1)).answers
    p11, p12, p22, r11, r12, r22 = sp.symbols("p11 p12 p22 p11_dot p12_dot p22_dot")
    wanted = [r11 + 1 - p12**2, r12 + p11 - p12 * p22, r22 + 1 + 2 * p12 - p22**2]
    assert [sp.expand(a - b) for a, b in zip(answers["riccati_equations"], wanted, strict=True)] == [0, 0, 0]


def test_a_terminal_weight_alone_gives_rational_functions():
    asked = {"Q": matrix([0, 0], [0, 0]), "R": ONE, "terminal_weight": matrix([1, 0], [0, 0]), "final_time": T}
    P = ask("finite_horizon_lqr", CHAIN, **asked).answers["P"]
    assert sp.cancel(P[0, 0] - 3 / (3 + (T - t) ** 3)) == 0


def test_a_long_horizon_without_a_terminal_weight_leaves_an_unseen_mode_alone():
    asked = {"Q": matrix([0]), "R": ONE, "final_time": sp.Integer(1)}
    result = ask("finite_horizon_lqr", one(1), **asked)
    assert result.answers["P_infinite"] == matrix([0])
    limit = next(step for step in result.steps if step.kind == "limit")
    assert not limit.values["same"]
    assert limit.values["stabilizing"] == matrix([2])
    ended = ask("finite_horizon_lqr", one(1), **asked, terminal_weight=ONE)
    assert ended.answers["P_infinite"] == matrix([2])


def test_what_the_input_does_not_reach_may_cost_ever_more():
    plant = system([[1, 0], [0, -1]], B=[[0], [1]])
    result = ask("finite_horizon_lqr", plant, Q=I2, R=ONE, final_time=sp.Integer(1))
    assert result.status is Status.VERIFIED, result.reason
    assert "P_infinite" not in result.answers
    assert sp.expand(result.answers["P"][0, 0] - (sp.exp(2 - 2 * t) - 1) / 2) == 0


def test_parameters_stay_in_the_answer():
    a, q, r = sp.symbols("a q r", real=True)
    result = ask("finite_horizon_lqr", system([[a]], B=[[1]]), Q=matrix([q]), R=matrix([r]), final_time=T)
    assert result.status is Status.VERIFIED, result.reason
    P = result.answers["P"][0, 0]
    here = float(P.subs({a: 1, q: 3, r: 2, T: 1.5, t: 0}).evalf())
    right = backwards(*(np.array([[value]], dtype=float) for value in (1, 1, 3, 2, 0)), 1.5)
    assert abs(here - right[0, 0]) < 1e-8


entries = st.lists(st.integers(-2, 2), min_size=6, max_size=6)
diagonal = st.lists(st.integers(0, 3), min_size=4, max_size=4)


@tried(8)
@given(entries, diagonal)
def test_generated_plants_agree_with_scipy(numbers, diagonals):
    A, B = np.array(numbers[:4]).reshape(2, 2), np.array(numbers[4:]).reshape(2, 1)
    Q, S = np.diag(diagonals[:2]), np.diag(diagonals[2:])
    asked = {"Q": sp.ImmutableMatrix(Q), "R": ONE, "terminal_weight": sp.ImmutableMatrix(S)}
    result = ask("finite_horizon_lqr", system(A.tolist(), B=B.tolist()), **asked, final_time=sp.Integer(1))
    assert result.status is Status.VERIFIED, result.reason
    found = np.array(result.answers["P"].subs(t, 0).evalf(30).tolist(), dtype=float)
    right = backwards(A.astype(float), B.astype(float), Q, np.eye(1), S, 1.0)
    assert np.abs(found - right).max() < 1e-7 * (1 + np.abs(right).max())


@tried(8)
@given(entries, diagonal, st.integers(1, 4))
def test_n_steps_are_the_recursion(numbers, diagonals, count):
    A, B = np.array(numbers[:4]).reshape(2, 2), np.array(numbers[4:]).reshape(2, 1)
    Q, S = np.diag(diagonals[:2]), np.diag(diagonals[2:])
    plant = system(A.tolist(), B=B.tolist(), discrete=True)
    asked = {"Q": sp.ImmutableMatrix(Q), "R": ONE, "terminal_weight": sp.ImmutableMatrix(S), "steps": count}
    result = ask("finite_horizon_lqr", plant, **asked, initial_state=matrix([1], [0]))
    assert result.status is Status.VERIFIED, result.reason
    P = S.astype(float)
    for found in result.answers["K"][::-1]:
        K = np.linalg.solve(np.eye(1) + B.T @ P @ B, B.T @ P @ A)
        assert np.allclose(np.array(found.tolist(), dtype=float), K)
        P = Q + A.T @ P @ (A - B @ K)
    assert np.allclose(np.array(result.answers["P"][0].tolist(), dtype=float), P)
    assert float(result.answers["cost"]) == pytest.approx(P[0, 0] / 2)


CONTINUOUS = {"Q": I2, "R": ONE, "final_time": sp.Integer(1), "initial_state": matrix([1], [0])}
DISCRETE = {"Q": I2, "R": ONE, "steps": 3, "initial_state": matrix([1], [0])}


def test_corrupted_answers_are_rejected():
    answers = ask("finite_horizon_lqr", CHAIN, **CONTINUOUS).answers
    spoiled = {
        "P": [-answers["P"], answers["P"] + sp.eye(2) / 1000, answers["P"].subs(t, 1 - t), answers["P_infinite"]],
        "K": [-answers["K"], answers["K"] * sp.Rational(1001, 1000), answers["P_infinite"][1, :]],
        "x": [-answers["x"], answers["x"] + matrix([t / 1000], [0])],
        "u": [-answers["u"], answers["u"] + t / 1000],
        "cost": [2 * answers["cost"], answers["cost"] + sp.Rational(1, 1000)],
        "P_infinite": [2 * answers["P_infinite"], answers["P_infinite"] + sp.eye(2) / 1000],
        "riccati_equations": [[-each if i else each + 1 for i, each in enumerate(answers["riccati_equations"])]],
    }
    for name, values in spoiled.items():
        assert not rejected("finite_horizon_lqr", CHAIN, {name: answers[name]}, **CONTINUOUS), name
        for value in values:
            spoilt = sp.ImmutableMatrix(value) if isinstance(value, sp.MatrixBase) else value
            assert rejected("finite_horizon_lqr", CHAIN, {name: spoilt}, **CONTINUOUS), name


def test_corrupted_lists_are_rejected():
    answers = ask("finite_horizon_lqr", SAMPLED, **DISCRETE).answers
    for name in ("P", "K", "x", "u"):
        assert not rejected("finite_horizon_lqr", SAMPLED, {name: answers[name]}, **DISCRETE), name
        for wrong in (answers[name][::-1], answers[name][:-1], [2 * each for each in answers[name]]):
            assert rejected("finite_horizon_lqr", SAMPLED, {name: wrong}, **DISCRETE), name
    assert rejected("finite_horizon_lqr", SAMPLED, {"cost": 2 * answers["cost"]}, **DISCRETE)


@pytest.mark.parametrize(
    ("time", "options", "words"),
    [
        ("", "Q: [[1, 0], [0, 1]]", "give final_time"),
        ("", "Q: [[1, 0], [0, 1]], final_time: -1", "final_time must be positive"),
        ("", "Q: [[1, 0], [0, -1]], final_time: 1", "positive semidefinite"),
        ("", "R: 0, final_time: 1", "R must be positive definite"),
        ("", "terminal_weight: [[1, 2], [2, 1]], final_time: 1", "terminal_weight must be positive semidefinite"),
        ("", "steps: 3, final_time: 1", "in continuous time; its horizon is given by final_time"),
        (", time: discrete", "final_time: 1", "give steps"),
        (", time: discrete", "steps: 0", "1"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(time, options, words):
    text = f"system: {{A: [[0, 1], [0, 0]], B: [0, 1]{time}}}\nfind:\n  a: {{task: finite_horizon_lqr, {options}}}\n"
    with pytest.raises(Exception, match=words):
        solve(text)
