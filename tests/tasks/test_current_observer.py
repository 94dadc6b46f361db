"""Current observers: simulated as defined, the prediction observer beside them, singular plants, corruptions."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

R = sp.Rational
METHODS = ["coefficient_matching", "bass_gura", "canonical_form", "ackermann"]
PLANT = system([[1, R(1, 10)], [0, 1]], discrete=True, B=[R(1, 200), R(1, 10)], C=[[1, 0]])
POLES = (R(2, 5), R(1, 2))
SINGULAR = system([[1, 1], [0, 0]], discrete=True, B=[0, 1], C=[[1, 0]])
SEVERAL = system([[1, 1, 0], [0, 2, 1], [1, 0, 1]], discrete=True, B=[0, 0, 1], C=[[1, 0, 0], [0, 0, 1]])
small = st.integers(-2, 2)


def floats(matrix):
    return np.array(matrix.tolist(), dtype=float).reshape(matrix.shape)


def errors_of(plant, L, steps=6):
    """x − x̂ of the observer as it is defined, driven by some input."""
    A, B, C = plant.A, plant.B, plant.C
    x, estimate, found = sp.ones(plant.order, 1), sp.zeros(plant.order, 1), []
    for k in range(steps):
        u = sp.Matrix([R(k * k + 1, 3)] * B.cols)
        x, predicted = A * x + B * u, A * estimate + B * u
        estimate = predicted + L * (C * x - C * predicted)
        found.append(x - estimate)
    return found


@pytest.mark.parametrize("method", METHODS)
def test_every_method_gives_the_gain_of_python_control(method):
    result = ask("current_observer", PLANT, method, poles=POLES)
    A, C = floats(PLANT.A), floats(PLANT.C)
    assert result.status is Status.VERIFIED
    assert np.allclose(floats(result.answers["L"]).ravel(), control.acker(A.T, (C @ A).T, [0.4, 0.5]).ravel())
    assert np.allclose(floats(result.answers["L_prediction"]).ravel(), control.acker(A.T, C.T, [0.4, 0.5]).ravel())
    assert result.answers["L_prediction"] == PLANT.A * result.answers["L"]


def test_the_errors_of_a_simulation_follow_the_polynomial_asked_for():
    errors = errors_of(PLANT, ask("current_observer", PLANT, poles=POLES).answers["L"])
    for e0, e1, e2 in zip(errors, errors[1:], errors[2:], strict=False):
        assert (e2 - R(9, 10) * e1 + R(1, 5) * e0).is_zero_matrix


def test_a_deadbeat_observer_knows_the_state_after_n_steps():
    L = ask("current_observer", PLANT, poles=(sp.Integer(0), sp.Integer(0))).answers["L"]
    errors = errors_of(PLANT, L)
    assert not errors[0].is_zero_matrix
    assert errors[1].is_zero_matrix


def test_the_steps_say_what_is_done():
    kinds = [step.kind for step in ask("current_observer", PLANT, "ackermann", poles=POLES).steps]
    assert kinds[:2] == ["error", "pair"]
    assert kinds[-3:] == ["equation", "prediction", "comparison"]


def test_a_singular_plant_keeps_a_pole_at_zero():
    for poles in ((R(1, 2),), (R(1, 2), sp.Integer(0))):
        result = ask("current_observer", SINGULAR, poles=poles)
        assert result.status is Status.VERIFIED
        assert result.answers["error_A"].charpoly(sp.Symbol("z")).as_expr() == sp.sympify("z**2 - z/2")
    result = ask("current_observer", SINGULAR, poles=(R(1, 2), R(1, 3)))
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == "placement/fixed_mode"


def test_an_error_that_grows_by_itself_is_refused():
    plant = system([[2, 0], [0, 1]], discrete=True, B=[1, 1], C=[[0, 1]])
    result = ask("current_observer", plant, poles=(R(1, 2),))
    assert result.status is Status.UNSOLVED
    assert result.reason.kind == "observers/error_grows"


@tried(10)
@given(
    st.lists(st.lists(small, min_size=3, max_size=3), min_size=3, max_size=3),
    st.integers(1, 2).flatmap(lambda p: st.lists(st.lists(small, min_size=3, max_size=3), min_size=p, max_size=p)),
)
def test_random_plants_have_the_poles(A, C):
    plant, poles = system(A, discrete=True, B=[1, 0, 0], C=C), (sp.Integer(0), R(1, 2), R(-1, 2))
    result = ask("current_observer", plant, "unity_rank" if len(C) > 1 else "bass_gura", poles=poles)
    if result.status is Status.UNSOLVED:
        return
    assert result.status is Status.VERIFIED
    errors = errors_of(plant, result.answers["L"], 5)
    for e0, e2 in zip(errors[1:], errors[3:], strict=False):
        assert (e2 - e0 / 4).is_zero_matrix  # z³ = z/4


@pytest.mark.parametrize(
    ("plant", "poles"), [(PLANT, POLES), (SINGULAR, (R(1, 2),)), (SEVERAL, (sp.Integer(0), R(1, 2), R(-1, 2)))]
)
def test_corrupted_answers_are_rejected(plant, poles):
    answers = ask("current_observer", plant, poles=poles).answers
    L, L_p, error = answers["L"], answers["L_prediction"], answers["error_A"]
    for right in ({"L": L}, {"L_prediction": L_p}, {"error_A": error}, dict(answers)):
        assert not rejected("current_observer", plant, right, poles=poles)
    wrongs = [{"L": -L}, {"L": L_p + L}, {"L_prediction": -L_p}, {"L_prediction": 2 * L_p}, {"error_A": 2 * error}]
    wrongs += [{"L": L, "error_A": error + sp.eye(plant.order) / 10**6}, {"error_A": sp.ImmutableMatrix(error.T * 2)}]
    for wrong in wrongs:
        assert rejected("current_observer", plant, wrong, poles=poles), wrong


PROBLEM = """system: {time: discrete, A: [[1, 1], [0, 1]], B: [[1/2], [1]], C: [[1, 0]]}
find:
  a: {task: current_observer, poles: [1/2, 0]}
"""
RIGHT = ask("current_observer", system([[1, 1], [0, 1]], discrete=True, C=[[1, 0]]), poles=(R(1, 2), R(0))).answers


def written(matrix):
    return str(matrix.tolist())


@pytest.mark.parametrize(
    ("name", "value", "said"),
    [
        ("L", RIGHT["L_prediction"], "prediction observer"),
        ("L_prediction", RIGHT["L"], "current observer"),
        ("error_A", sp.Matrix([[1, 1], [0, 1]]) - RIGHT["L"] * sp.Matrix([[1, 0]]), "as of a prediction observer"),
        ("error_A", sp.Matrix([[1, 1], [0, 1]]) - RIGHT["L_prediction"] * sp.Matrix([[1, 0]]), "corrected last"),
        ("L", sp.Matrix([1, 1]), "poles"),
    ],
)
def test_the_two_observers_are_told_apart(name, value, said):
    found = verdict(PROBLEM, "a", name, written(value))
    assert found.verdict == "wrong"
    assert said in str(found.reason)
    assert verdict(PROBLEM, "a", name, written(RIGHT[name])).verdict == "correct"
