"""Tracking of a constant reference: the closed loop simulated, singular and over-actuated plants, refusals."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.exact import reachable_order
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

SERVO = system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]])


def numbers(*values):
    return tuple(sp.sympify(value) for value in values)


def array(M):
    return np.array(M.tolist(), dtype=float)


def steady_output(plant, K, K_o):
    """y/r of the closed loop at rest, by python-control's dcgain."""
    A, B, C = (array(M) for M in (plant.A, plant.B, plant.C))
    D = np.zeros((len(C), B.shape[1])) if plant.D is None else array(plant.D)
    loop = control.ss(A - B @ K, B @ K_o, C - D @ K, D @ K_o, *([True] if plant.discrete else []))
    return np.atleast_2d(control.dcgain(loop))


@pytest.mark.parametrize(
    ("plant", "poles"),
    [
        (SERVO, (-2 + 2 * sp.I, -2 - 2 * sp.I)),
        (system([[0, 1], [0, 1]], B=[0, 1], C=[[1, 0]]), (-2, -3)),
        (system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]], D=[[1]]), (-2, -3)),
        (system([[0, 1], [-2, -3]], B=[[1, 0], [0, 1]], C=[[1, 0], [1, 1]]), (-2, -3)),
        (system([[0, 1], [0, 1]], B=[[1, 0], [0, 1]], C=[[1, 0]]), (-2, -3)),
        (system([[0, 1], [1, 1]], B=[0, 1], C=[[1, 0]], discrete=True), (0, sp.Rational(1, 2))),
        (system([[1, 1], [0, 1]], B=[0, 1], C=[[1, 0]], discrete=True), (0, sp.Rational(1, 2))),
    ],
)
def test_the_output_settles_at_the_reference(plant, poles):
    result = ask("reference_tracking", plant, poles=numbers(*poles))
    assert result.status is Status.VERIFIED, result.reason
    K, K_o = (array(result.answers[name]) for name in ("K", "K_o"))
    assert np.allclose(steady_output(plant, K, K_o), np.eye(plant.C.rows), atol=1e-9)


def test_a_given_gain_is_kept():
    K = sp.ImmutableMatrix([[3, 4]])
    result = ask("reference_tracking", SERVO, gain=K)
    assert result.status is Status.VERIFIED
    assert result.answers["F"] == sp.ImmutableMatrix([1, 0])
    assert result.answers["N"] == sp.ImmutableMatrix([[2]])
    assert result.answers["K_o"] == sp.ImmutableMatrix([[5]])
    assert "closed_loop" not in [step.kind for step in result.steps], "the gain is no closed loop to start from"


@tried(12)
@given(systems(4), st.data())
def test_random_plants_with_as_many_outputs_as_inputs(A, data):
    n = A.rows
    m = data.draw(st.integers(1, min(2, n)))
    B, C = (
        sp.ImmutableMatrix(*shape, data.draw(st.lists(st.integers(-2, 2), min_size=n * m, max_size=n * m)))
        for shape in ((n, m), (m, n))
    )
    assume(reachable_order(A, B) == n)
    M = sp.Matrix.vstack(sp.Matrix.hstack(A, B), sp.Matrix.hstack(C, sp.zeros(m)))
    poles = numbers(*range(-n, 0))
    plant = system(A, B=B, C=C)
    result = ask("reference_tracking", plant, poles=poles)
    if M.rank() < n + m:
        assert result.status is Status.UNSOLVED
        assert "zero" in str(result.reason)
        return
    assert result.status is Status.VERIFIED, result.reason
    K, K_o = result.answers["K"], result.answers["K_o"]
    assert (C * (B * K - A).inv() * B * K_o - sp.eye(m)).is_zero_matrix


def test_fewer_inputs_than_outputs_are_unsolved_in_words():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0], [0, 1]])
    result = ask("reference_tracking", plant, poles=numbers(-1, -2))
    assert result.status is Status.UNSOLVED
    assert "under-actuated" in str(result.reason)


def test_a_gain_and_poles_are_one_too_many():
    options = {"gain": sp.ImmutableMatrix([[1, 1]]), "poles": numbers(-1, -2)}
    assert [option for option, _ in catalogue()["reference_tracking"].refused(SERVO, options)] == ["poles"]
    assert list(catalogue()["reference_tracking"].refused(SERVO, {}))


OPTIONS = {"poles": numbers(-4, -5)}


@pytest.mark.parametrize("name", ["F", "N", "K_o", "K"])
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answer = ask("reference_tracking", SERVO, **OPTIONS).answers[name]
    assert not rejected("reference_tracking", SERVO, {name: answer}, **OPTIONS)
    for i in range(len(answer)):
        changed = answer.as_mutable()
        changed[i] += sp.Rational(1, 1000)
        assert rejected("reference_tracking", SERVO, {name: sp.ImmutableMatrix(changed)}, **OPTIONS)
    assert rejected("reference_tracking", SERVO, {name: -answer}, **OPTIONS)


def test_any_steady_state_of_an_over_actuated_plant_is_right():
    plant = system([[0, 1], [0, 1]], B=[[1, 0], [0, 1]], C=[[1, 0]])
    gain = sp.ImmutableMatrix([[1, 0], [0, 2]])
    F, N = sp.ImmutableMatrix([1, 3]), sp.ImmutableMatrix([-3, -3])
    right = {"F": F, "N": N, "K_o": N + gain * F}
    assert not rejected("reference_tracking", plant, right, gain=gain)
    assert rejected("reference_tracking", plant, {**right, "N": -N}, gain=gain)
