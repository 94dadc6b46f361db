"""Deadbeat control: textbook gains, the fewest steps for random plants, parts that no input reaches, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

R = sp.Rational
DOUBLE_INTEGRATOR = system([[1, 1], [0, 1]], discrete=True, B=[R(1, 2), 1])
TWO_INPUTS = system([[1, 1, 0], [0, 1, 1], [1, 0, 2]], discrete=True, B=[[0, 0], [1, 0], [0, 1]])
UNREACHED = system([[1, 1, 0], [0, 0, 1], [0, 0, 0]], discrete=True, B=[1, 0, 0])
small = st.integers(-2, 2)


def least(A, B):
    """The fewest steps by exact ranks: Aᵛ x in the range of [B, AB, …]."""
    A, B = sp.Matrix(A), sp.Matrix(B)
    reached, power = sp.zeros(A.rows, 0), sp.eye(A.rows)
    for steps in range(A.rows + 1):
        if reached.rank() == reached.row_join(power).rank():
            return steps
        reached, power = reached.row_join(power * B), A * power
    return None


def test_the_double_integrator_of_textbooks():
    """Åström and Wittenmark, example 4.3: K = [1/T², 3/(2T)]."""
    T = sp.Symbol("T", positive=True)
    plant = system([[1, T], [0, 1]], discrete=True, B=[T**2 / 2, T])
    result = ask("deadbeat", plant)
    assert result.status is Status.VERIFIED
    assert sp.simplify(result.answers["K"] - sp.Matrix([[1 / T**2, 3 / (2 * T)]])).is_zero_matrix
    assert result.answers["steps"] == 2
    kinds = [step.kind for step in ask("deadbeat", DOUBLE_INTEGRATOR).steps]
    assert kinds[:3] == ["scheme", "idea", "desired"]
    assert kinds[-3:] == ["closed_loop", "powers", "motion"]


def test_several_inputs_need_fewer_steps_than_there_are_states():
    result = ask("deadbeat", TWO_INPUTS)
    loop = result.answers["closed_loop_A"]
    assert (result.status, result.answers["steps"]) == (Status.VERIFIED, 2)
    assert (loop**2).is_zero_matrix
    assert [step.kind for step in result.steps][2:5] == ["chains", "ends", "ends_gain"]


def test_inputs_that_do_nothing_new_are_left_at_rest():
    result = ask("deadbeat", system([[0, 1], [1, 1]], discrete=True, B=[[0, 0], [1, 2]]))
    assert result.status is Status.VERIFIED
    assert result.answers["K"][1, :].is_zero_matrix


def test_what_no_input_reaches_may_die_by_itself():
    result = ask("deadbeat", UNREACHED)
    assert (result.status, result.answers["steps"]) == (Status.VERIFIED, 2)
    lasting = ask("deadbeat", system([[2, 0], [0, R(1, 2)]], discrete=True, B=[1, 0]))
    assert lasting.status is Status.UNSOLVED
    assert lasting.reason.values == {"modes": [R(1, 2)]}


@tried(12)
@given(
    st.integers(1, 4).flatmap(
        lambda n: st.tuples(
            st.lists(st.lists(small, min_size=n, max_size=n), min_size=n, max_size=n),
            st.integers(1, 2).flatmap(
                lambda m: st.lists(st.lists(small, min_size=m, max_size=m), min_size=n, max_size=n)
            ),
        )
    )
)
def test_random_plants_are_dead_in_the_fewest_steps(matrices):
    A, B = matrices
    assume(any(any(row) for row in B))
    result, fewest = ask("deadbeat", system(A, discrete=True, B=B)), least(A, B)
    if fewest is None:
        assert result.status is Status.UNSOLVED
        return
    assert result.status is Status.VERIFIED
    assert result.answers["steps"] == max(fewest, 1)
    x, K = sp.Matrix(range(1, len(A) + 1)), result.answers["K"]
    for _ in range(fewest):
        x = sp.Matrix(A) * x + sp.Matrix(B) * (-K * x)
    assert x.is_zero_matrix


@pytest.mark.parametrize("plant", [DOUBLE_INTEGRATOR, TWO_INPUTS, UNREACHED])
def test_corrupted_answers_are_rejected(plant):
    answers = ask("deadbeat", plant).answers
    K, loop, steps = answers["K"], answers["closed_loop_A"], answers["steps"]
    bump = sp.ImmutableMatrix(sp.zeros(*K.shape))
    bump = sp.ImmutableMatrix(bump.rows, bump.cols, lambda i, j: R(1, 10**6) * int((i, j) == (0, 0)))
    for right in ({"K": K}, {"closed_loop_A": loop}, {"steps": steps}, dict(answers)):
        assert not rejected("deadbeat", plant, right)
    for wrong in (
        {"K": -K}, {"K": K + bump}, {"K": K.T if K.shape[0] != K.shape[1] else 2 * K},
        {"closed_loop_A": loop.T}, {"closed_loop_A": 2 * plant.A - loop}, {"steps": steps + 1}, {"steps": steps - 1},
    ):  # fmt: skip
        assert rejected("deadbeat", plant, wrong), wrong


def test_a_slower_gain_of_several_inputs_is_not_the_quickest():
    slow = ask("pole_placement", TWO_INPUTS, poles=(sp.Integer(0),) * 3).answers["K"]
    loop = TWO_INPUTS.A - TWO_INPUTS.B * slow
    assert not np.any(np.array((loop**3).tolist(), dtype=float))
    assert (loop**2).is_zero_matrix or rejected("deadbeat", TWO_INPUTS, {"K": slow})


PROBLEM = "system: {time: discrete, A: [[1, 1], [0, 1]], B: [[1/2], [1]]}\nfind:\n  a: deadbeat\n"
TWO = (
    "system: {time: discrete, A: [[1, 1, 0], [0, 1, 1], [1, 0, 2]], B: [[0, 0], [1, 0], [0, 1]]}\nfind: {a: deadbeat}\n"
)


@pytest.mark.parametrize(
    ("problem", "name", "value", "said"),
    [
        (PROBLEM, "K", "[-1, -1.5]", "the feedback is subtracted"),
        (PROBLEM, "K", "[1, 1]", "poles"),
        (TWO, "steps", "3", "fewer than"),
        (TWO, "steps", "1", "dimension 2"),
    ],
)
def test_usual_mistakes_are_named(problem, name, value, said):
    found = verdict(problem, "a", name, value)
    assert found.verdict == "wrong"
    assert said in str(found.reason)


def test_right_answers_are_right():
    assert verdict(PROBLEM, "a", "K", "[1, 1.5]").verdict == "correct"
    assert verdict(TWO, "a", "K", "[[1, 2, 1], [1, 0, 2]]").verdict == "correct"
