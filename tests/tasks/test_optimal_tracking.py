"""Optimal tracking: set points for as many, more and fewer inputs than outputs, simulation, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import solve_discrete_are

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

ONE = sp.ImmutableMatrix([[1]])
SINGULAR = system([[0, 1], [0, -2]], B=[[0], [1]], C=[[1, 0]])
ASKED = {"Q": sp.ImmutableMatrix(sp.diag(4, 1)), "R": ONE}


def floats(M) -> np.ndarray:
    return np.array(sp.Matrix(M).evalf(30).tolist(), dtype=float)


def test_a_plant_with_a_pole_at_the_origin():
    result = ask("optimal_tracking", SINGULAR, **ASKED)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == sp.ImmutableMatrix([[2, 1]])
    assert result.answers["F"] == sp.ImmutableMatrix([1, 0])
    assert result.answers["N"] == sp.zeros(1, 1)
    assert result.answers["K_o"] == sp.ImmutableMatrix([[2]])


def test_the_gain_may_be_given_and_the_loop_is_not_closed_twice():
    plant = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0]])
    answers = ask("optimal_tracking", plant, gain=sp.ImmutableMatrix([[3, 1]])).answers
    assert answers["N"] == sp.ImmutableMatrix([[2]])
    assert answers["K_o"] == sp.ImmutableMatrix([[5]])


def test_more_inputs_than_outputs_take_the_least_set_point():
    plant = system([[0, 1], [-2, -3]], B=[[0, 1], [1, 1]], C=[[1, 0]])
    result = ask("optimal_tracking", plant, gain=sp.ImmutableMatrix(sp.zeros(2)))
    assert result.status is Status.VERIFIED
    M = np.array([[0, 1, 0, 1], [-2, -3, 1, 1], [1, 0, 0, 0]], dtype=float)
    least = np.linalg.pinv(M) @ np.array([[0], [0], [1]])
    found = np.vstack([floats(result.answers["F"]), floats(result.answers["N"])])
    assert np.abs(found - least).max() < 1e-12
    other = {"F": sp.ImmutableMatrix([1, 0]), "N": sp.ImmutableMatrix([2, 0])}
    assert not rejected("optimal_tracking", plant, other, gain=sp.ImmutableMatrix(sp.zeros(2)))
    mixed = {"F": sp.ImmutableMatrix([1, 0]), "N": result.answers["N"]}
    assert rejected("optimal_tracking", plant, mixed, gain=sp.ImmutableMatrix(sp.zeros(2)))


@pytest.mark.parametrize(
    ("plant", "words"),
    [
        (system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0], [0, 1]]), "fewer inputs"),
        (system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[0, 1]]), "zero at $s = 0$"),
    ],
)
def test_references_that_cannot_be_held(plant, words):
    result = ask("optimal_tracking", plant, gain=sp.ImmutableMatrix([[1, 1]]))
    assert result.status is Status.UNSOLVED
    assert words in str(result.reason)


def test_discrete_time_with_a_gain():
    plant = system([[1, 1], [0, 1]], discrete=True, B=[[0], [1]], C=[[1, 0]])
    result = ask("optimal_tracking", plant, gain=sp.ImmutableMatrix([[sp.Rational(1, 4), 1]]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K_o"] == sp.ImmutableMatrix([[sp.Rational(1, 4)]])


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ("gain: [1, 2], Q: [[1, 0], [0, 1]]", "given twice"),
        ("", "say how K is found"),
        ("Q: [[1, 0], [0, -1]], R: 1", "semidefinite"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused(options, words):
    text = f"system: {{A: [[0, 1], [0, 0]], B: [0, 1], C: [1, 0]}}\nfind:\n  a: {{task: optimal_tracking, {options}}}\n"
    with pytest.raises(Exception, match=words):
        solve(text)


def test_weights_in_discrete_time():
    plant = system([[1, 1], [0, 1]], discrete=True, B=[[0], [1]], C=[[1, 0]])
    result = ask("optimal_tracking", plant, R=sp.ImmutableMatrix([[1]]))
    assert result.status is Status.VERIFIED, result.reason
    K, F, N = (result.answers[name] for name in ("K", "F", "N"))
    P = solve_discrete_are(*(floats(M) for M in (plant.A, plant.B, sp.eye(2), sp.eye(1))))
    A, B = floats(plant.A), floats(plant.B)
    assert np.allclose(floats(K), np.linalg.solve(1 + B.T @ P @ B, B.T @ P @ A))
    assert sp.simplify(result.answers["K_o"] - N - K * F) == sp.zeros(1)


RIGHT = ask("optimal_tracking", SINGULAR, **ASKED).answers


@pytest.mark.parametrize("name", list(RIGHT))
def test_right_answers_are_accepted_alone_and_wrong_ones_rejected(name):
    value = RIGHT[name]
    assert not rejected("optimal_tracking", SINGULAR, {name: value}, **ASKED)
    assert rejected(
        "optimal_tracking", SINGULAR, {name: sp.ImmutableMatrix(value + sp.ones(*value.shape) / 1000)}, **ASKED
    )
    assert rejected("optimal_tracking", SINGULAR, {name: sp.ImmutableMatrix(sp.ones(3, 3))}, **ASKED)
    if value != sp.zeros(*value.shape):
        assert rejected("optimal_tracking", SINGULAR, {name: -value}, **ASKED)


@tried(10)
@given(st.lists(st.integers(-3, 3), min_size=9, max_size=9), st.integers(1, 2))
def test_the_loop_settles_at_the_reference(entries, m):
    A = sp.Matrix(2, 2, entries[:4])
    B, C = sp.Matrix(2, m, entries[4 : 4 + 2 * m]), sp.Matrix([[1, 0]])
    result = ask(
        "optimal_tracking", system(A, B=B, C=C), Q=sp.ImmutableMatrix(sp.eye(2)), R=sp.ImmutableMatrix(sp.eye(m))
    )
    assert result.status is not Status.FAILED, result.reason
    if result.status is Status.VERIFIED:
        loop = floats(A) - floats(B) @ floats(result.answers["K"])
        y = floats(C) @ np.linalg.solve(-loop, floats(B) @ floats(result.answers["K_o"]))
        assert abs(y[0, 0] - 1) < 1e-8
