"""The Kalman filter: textbook values, duality with the regulator, corruptions, refusals."""

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import solve_continuous_are

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system

METHODS = ("riccati", "hamiltonian")
ONE = sp.ImmutableMatrix([[1]])
PLANT = system([[0, 1], [0, 0]], B=[[0], [1]], C=[[1, 0]])
ASKED = {"Q": sp.ImmutableMatrix(sp.diag(0, 4)), "R": ONE}


def floats(M) -> np.ndarray:
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=float)


@pytest.mark.parametrize("method", METHODS)
def test_the_double_integrator(method):
    result = ask("kalman_filter", PLANT, method, **ASKED)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["P"] == sp.ImmutableMatrix([[2, 2], [2, 4]])
    assert result.answers["L"] == sp.ImmutableMatrix([2, 2])
    assert result.answers["error_A"] == sp.ImmutableMatrix([[-2, 1], [-2, 0]])
    assert set(result.answers["eigenvalues"]) == {-1 + sp.I, -1 - sp.I}


def test_the_gain_is_the_transposed_gain_of_the_dual_regulator():
    A, C = [[1, 2, 0], [0, -1, 1], [1, 0, -2]], [[1, 0, 1], [0, 1, 0]]
    Q, R = sp.ImmutableMatrix(sp.diag(1, 2, 3)), sp.ImmutableMatrix([[2, 1], [1, 2]])
    found = ask("kalman_filter", system(A, C=C), "hamiltonian", Q=Q, R=R)
    dual = ask("lqr", system(sp.Matrix(A).T, B=sp.Matrix(C).T), "hamiltonian", Q=Q, R=R)
    assert found.status is dual.status is Status.VERIFIED
    assert found.answers["L"] == dual.answers["K"].T
    P = solve_continuous_are(floats(A).T, floats(C).T, floats(Q), floats(R))
    assert np.abs(floats(found.answers["P"]) - P).max() < 1e-9


def test_pendulum_on_a_cart_of_the_course():
    A = [[0, 1, 0, 0], [0, "-3/17", "-981/425", 0], [0, 0, 0, 1], [0, "20/51", "2289/85", 0]]
    A = sp.Matrix(A).applyfunc(sp.Rational)
    C = [[1, 0, 0, 0], [0, 0, 1, 0]]
    asked = {"Q": sp.ImmutableMatrix(sp.eye(4)), "R": sp.ImmutableMatrix(sp.eye(2))}
    result = ask("kalman_filter", system(A, C=C), "hamiltonian", **asked)
    assert result.status is Status.VERIFIED, result.reason
    P = solve_continuous_are(floats(A).T, floats(C).T, np.eye(4), np.eye(2))
    assert np.abs(floats(result.answers["P"]) - P).max() < 1e-8 * np.abs(P).max()


@pytest.mark.parametrize(("named", "chosen"), [("Q R", False), ("Q", True), ("R", True)])
def test_an_intensity_that_is_not_given_is_said_to_be_chosen(named, chosen):
    result = ask("kalman_filter", PLANT, **{name: ASKED[name] for name in named.split()})
    (step,) = [each for top in result.steps for each in top.walk() if each.kind.endswith("intensities")]
    assert step.values["chosen"] is chosen


def test_an_unseen_unstable_mode_is_named():
    result = ask("kalman_filter", system([[1, 0], [0, -1]], C=[[0, 1]]), **ASKED)
    assert result.status is Status.UNSOLVED
    assert "not detectable: the mode $\\lambda = 1$" in str(result.reason)


RIGHT = ask("kalman_filter", PLANT, **ASKED).answers
WRONG = [
    ("P", RIGHT["solutions"][1]),
    ("P", sp.ImmutableMatrix([[4, 2], [2, 2]])),
    ("L", RIGHT["L"].T),
    ("L", -RIGHT["L"]),
    ("L", 2 * RIGHT["L"]),
    ("error_A", RIGHT["error_A"].T),
    ("eigenvalues", [1 + sp.I, 1 - sp.I]),
    ("equations", RIGHT["equations"][::2]),
    ("solutions", RIGHT["solutions"][:1]),
    ("definiteness", ["positive definite", "positive definite"]),
]


@pytest.mark.parametrize(("name", "wrong"), WRONG)
def test_a_corrupted_answer_is_rejected_alone(name, wrong):
    assert rejected("kalman_filter", PLANT, {name: wrong}, **ASKED)


@pytest.mark.parametrize("name", list(RIGHT))
def test_every_answer_is_accepted_alone(name):
    assert not rejected("kalman_filter", PLANT, {name: RIGHT[name]}, **ASKED)


def test_minors_and_loops_of_solutions_are_worked_out_and_told_where_they_stand():
    text = "title: t\nsystem: {A: [[0, 1], [0, 0]], C: [1, 0]}\n"
    page = solve(text + "find: {a: {task: kalman_filter, Q: [[0, 0], [0, 4]], R: 1}}\n").markdown(detail="tutor")
    assert r"\Delta_{2}(P_{1}) = 2 \cdot 4 - 2 \cdot 2" in page
    assert r"A^{T} - C^{T}R^{-1}CP_{1} = \begin{bmatrix}0 & 0 \\ 1 & 0\end{bmatrix} - " in page
    assert r"p_{12} = \pm\sqrt{4} = 2,\; -2" in page
    assert r"\text{equations:}" not in page
    assert "each of which is zero (step 3)" in page
