"""Regulators and filters in discrete time: scipy, python-control, simulated costs, corruptions, marking, refusals."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import solve_discrete_are

from solver import solve
from solver.derivation import Status
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

M, R = sp.ImmutableMatrix, sp.Rational
ONE = M([[1]])
PLANT = system([[1, 1], [0, 1]], discrete=True, B=[[R(1, 2)], [1]], C=[[1, 0]])
SINGULAR = system([[0, 1], [0, 2]], discrete=True, B=[[0], [1]], C=[[1, 1]])
SEEN = {"Q": M([[1, 0], [0, 0]]), "R": ONE}
METHODS = ["riccati", "hamiltonian"]
small = st.integers(-2, 2)


def floats(matrix):
    return np.array(sp.Matrix(matrix).evalf(30).tolist(), dtype=float)


@pytest.mark.parametrize("method", METHODS)
def test_both_methods_give_the_gain_of_python_control(method):
    result = ask("lqr", PLANT, method, **SEEN, initial_state=M([[1], [0]]))
    assert result.status is Status.VERIFIED, result.reason
    K, P, poles = control.dlqr(*(floats(each) for each in (PLANT.A, PLANT.B, SEEN["Q"], SEEN["R"])))
    assert np.allclose(floats(result.answers["K"]), K)
    assert np.allclose(floats(result.answers["P"]), P)
    assert np.allclose(sorted(map(complex, result.answers["eigenvalues"]), key=str), sorted(poles, key=str))
    assert result.answers["P"] == M([[2, 1], [1, R(3, 2)]])
    assert result.answers["cost"] == 1


def test_the_steps_lead_from_the_entries_to_the_choice():
    result = ask("lqr", PLANT, "riccati", **SEEN)
    kinds = [step.kind for step in result.steps]
    assert kinds[:4] == ["weights", "unknown", "equations", "splitting"]
    assert kinds[-4:] == ["choice", "gain", "law", "closed_loop"]
    assert result.answers["solutions"] == [M([[2, 1], [1, R(3, 2)]]), M([[-1, 1], [1, -R(3, 2)]])]
    assert result.answers["definiteness"] == ["positive definite", "negative definite"]
    p = sp.symbols("p11 p12 p22")
    for each in result.answers["equations"]:
        assert sp.expand(each).subs(dict(zip(p, (2, 1, R(3, 2)), strict=True))) == 0


def test_the_least_cost_is_that_of_a_simulation_and_other_gains_cost_more():
    result = ask("lqr", PLANT, "riccati", **SEEN, cost_factor=sp.Integer(1), initial_state=M([[1], [2]]))

    def cost(K, steps=400):
        x, total = np.array([1.0, 2.0]), 0.0
        for _ in range(steps):
            u = -K @ x
            total += x[0] ** 2 + u @ u
            x = floats(PLANT.A) @ x + floats(PLANT.B)[:, 0] * u[0]
        return total

    K = floats(result.answers["K"])
    assert cost(K) == pytest.approx(float(result.answers["cost"]))
    assert all(cost(K * factor) > cost(K) for factor in (0.9, 1.1))


@pytest.mark.parametrize("method", METHODS)
def test_a_singular_plant(method):
    result = ask("lqr", SINGULAR, method, R=ONE)
    assert result.status is Status.VERIFIED, result.reason
    assert 0 in result.answers["eigenvalues"]
    P = solve_discrete_are(*(floats(each) for each in (SINGULAR.A, SINGULAR.B, sp.eye(2), ONE)))
    assert np.allclose(floats(result.answers["P"]), P)


def test_a_weight_of_the_input_that_is_zero():
    result = ask("lqr", SINGULAR, "riccati", R=M([[0]]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["closed_loop_A"] ** 2 == sp.zeros(2)
    refused = ask("lqr", SINGULAR, "hamiltonian", R=M([[0]]))
    assert refused.status is Status.UNSOLVED
    assert "method riccati" in str(refused.reason)


def test_a_cross_weight_is_that_of_scipy():
    N = M([[1], [1]])
    result = ask("lqr", PLANT, "riccati", Q=M(sp.diag(2, 3)), R=ONE, N=N)
    assert result.status is Status.VERIFIED, result.reason
    A, B = floats(PLANT.A), floats(PLANT.B)
    P = solve_discrete_are(A, B, np.diag([2.0, 3.0]), np.eye(1), s=floats(N))
    assert np.allclose(floats(result.answers["K"]), np.linalg.solve(1 + B.T @ P @ B, B.T @ P @ A + floats(N).T))


@pytest.mark.parametrize("method", METHODS)
def test_symbols(method):
    a, b, q, r = sp.symbols("a b q r")
    result = ask("lqr", system([[a]], discrete=True, B=[[b]]), method, Q=M([[q]]), R=M([[r]]))
    assert result.status is Status.VERIFIED, result.reason
    p = result.answers["P"][0, 0]
    assert sp.simplify(b**2 * p**2 + (r - a**2 * r - b**2 * q) * p - q * r) == 0


def test_the_minimal_solution_leaves_alone_what_the_weight_does_not_see():
    plant = system([[2, 1], [0, 3]], discrete=True, B=[[0], [1]])
    result = ask("lqr", plant, "riccati", Q=M([[0, 0], [0, 1]]), R=ONE)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["minimal_solution"][0, 0] == 0
    assert result.answers["P"][0, 0] != 0


@tried(8)
@given(
    rows=st.lists(st.lists(small, min_size=2, max_size=2), min_size=2, max_size=2),
    column=st.lists(small, min_size=2, max_size=2),
    row=st.lists(small, min_size=2, max_size=2),
)
def test_the_filter_is_that_of_python_control(rows, column, row):
    plant = system(rows, discrete=True, C=[row])
    Q = M(column) * M(column).T
    result = ask("kalman_filter", plant, "hamiltonian", Q=Q, R=ONE)
    assume(result.status is not Status.UNSOLVED)
    assert result.status is Status.VERIFIED, result.reason
    A, C = floats(plant.A), floats(plant.C)
    P = solve_discrete_are(A.T, C.T, floats(Q), np.eye(1))
    gain = np.linalg.solve(1 + C @ P @ C.T, C @ P).T
    assert np.allclose(floats(result.answers["P"]), P, atol=1e-6)
    assert np.allclose(floats(result.answers["L_current"]), gain, atol=1e-7)
    assert np.allclose(floats(result.answers["L"]), A @ gain, atol=1e-7)


def test_a_filter_without_noise_of_measurement_knows_what_is_measured():
    result = ask("kalman_filter", system([[2]], discrete=True, C=[[1]]), Q=ONE, R=M([[0]]))
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["L"], result.answers["L_current"]) == (M([[2]]), ONE)


RIGHT = ask("lqr", PLANT, "riccati", **SEEN, initial_state=M([[1], [0]])).answers
FILTER = ask("kalman_filter", SINGULAR, "riccati", R=ONE).answers
HALF = R(1001, 1000)


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("P", RIGHT["solutions"][1]),
        ("P", RIGHT["P"] * HALF),
        ("K", -RIGHT["K"]),
        ("K", RIGHT["K"] * HALF),
        ("K", M([[0, 0]])),
        ("u", -RIGHT["u"]),
        ("closed_loop_A", RIGHT["closed_loop_A"].T),
        ("eigenvalues", [1 / each for each in RIGHT["eigenvalues"]]),
        ("eigenvalues", RIGHT["eigenvalues"][:1]),
        ("cost", 2 * RIGHT["cost"]),
        ("equations", [RIGHT["equations"][0] + 1, *RIGHT["equations"][1:]]),
        ("equations", RIGHT["equations"][:2]),
        ("solutions", RIGHT["solutions"][:1]),
        ("solutions", [RIGHT["P"], RIGHT["P"]]),
        ("definiteness", ["positive definite", "indefinite"]),
    ],
)
def test_corrupted_answers_are_rejected(name, wrong):
    options = {**SEEN, "initial_state": M([[1], [0]])}
    assert not rejected("lqr", PLANT, {name: RIGHT[name]}, **options)
    assert rejected("lqr", PLANT, {name: wrong}, **options)


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        ("L", FILTER["L_current"]),
        ("L_current", FILTER["L"]),
        ("L", FILTER["L"] * HALF),
        ("P", FILTER["solutions"][1]),
        ("error_A", FILTER["error_A"].T),
    ],
)
def test_corrupted_filters_are_rejected(name, wrong):
    assert not rejected("kalman_filter", SINGULAR, {name: FILTER[name]}, R=ONE)
    assert rejected("kalman_filter", SINGULAR, {name: wrong}, R=ONE)


QUESTION = """
system: {time: discrete, A: [[1, 1], [0, 1]], B: [1/2, 1], C: [1, 0]}
find:
  a: {task: lqr, Q: [[1, 0], [0, 0]], R: 1, answers: [P, K]}
  b: {task: kalman_filter, Q: [[1/4, 1/2], [1/2, 1]], R: 1, answers: [L, L_current, P]}
  c: {task: lqr, R: 1, answers: [P, K], system: {time: discrete, A: [[1]], B: [[1]]}}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "says"),
    [
        ("c", "K", "1 + √2", "continuous time"),
        ("a", "K", "[2, 4]", "$R$ is inverted"),
        ("a", "K", "[1/2, 1/2]", "$A$ is missing"),
        ("c", "K", "(1 - √5)/(3 - √5)", "not the stabilising"),
        ("a", "P", "[[-1, 1], [1, -3/2]]", "not the stabilising"),
        ("b", "L_current", "[5/4, 1/2]", "gain of the prediction"),
        ("b", "L", "[3/4, 1/2]", "gain of the current estimate"),
    ],
)
def test_usual_mistakes_have_names(part, name, value, says):
    found = verdict(QUESTION, part, name, value)
    assert found.verdict == "wrong", found
    assert says in str(found.reason), found.reason


def test_entries_may_stand_over_their_denominator():
    value = (
        '["1 + p11 - p11 - (p11/2 + p12)^2/(p11/4 + p12 + p22 + 1)",'
        ' "p12 - p12 + p11 - (p11/2 + p12)(p11/2 + 3p12/2 + p22)/(p11/4 + p12 + p22 + 1)",'
        ' "p11 + 2p12 - (p11/2 + 3p12/2 + p22)^2/(p11/4 + p12 + p22 + 1)"]'
    )
    question = QUESTION.replace("answers: [P, K]", "answers: [equations]")
    assert verdict(question, "a", "equations", value).verdict == "correct"


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        ("{task: lqr, Q: [[1, 0], [0, 1]], R: -1}", "semidefinite"),
        ("{task: lqr, Q: [[1, 0], [0, 1]], R: 0, N: [1, 1]}", "R must be positive definite"),
        ("{task: kalman_filter, Q: [[1, 0], [0, -1]], R: 1}", "semidefinite"),
        ("{task: optimal_tracking, R: -1}", "semidefinite"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(asked, words):
    with pytest.raises(Exception, match=words):
        solve(QUESTION.partition("find:")[0] + "find:\n  a: " + asked + "\n")


@pytest.mark.parametrize(
    ("plant", "options", "words"),
    [
        (system([[1]], discrete=True, B=[[1]]), {"Q": M([[0]]), "R": ONE}, "eigenvalues on the unit circle"),
        (system([[2, 0], [0, 1]], discrete=True, B=[[0], [1]]), {"R": ONE}, "not stabilizable"),
        (system([[2]], discrete=True, B=[[1]]), {"Q": M([[0]]), "R": M([[0]])}, "leave the best control"),
    ],
)
def test_what_has_no_solution(plant, options, words):
    result = ask("lqr", plant, "riccati", **options)
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


def test_equations_that_cannot_hold_claim_nothing():
    """Where no input reaches a mode on the circle an entry says 1 = 0."""
    asked = "find: {a: {task: lqr, Q: [[1, 0], [0, 1]], R: 2}}\n"
    text = f"system: {{time: discrete, A: [[1, -2], [0, -2]], B: [0, 0]}}\n{asked}"
    solution = solve_problem(read_problem(Source("file.yaml", text), catalogue()))
    for detail in ("key", "full"):
        (part,) = document_of(solution, Presentation(detail)).parts
        assert part.status is Status.UNSOLVED
        assert "not stabilizable" in str(part.reason)
