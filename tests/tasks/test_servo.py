"""Integral action: spectra, steady states by simulation, zeros at the origin, several outputs, corruptions."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Status
from solver.exact import reachable_order
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

METHODS = ("coefficient_matching", "bass_gura", "canonical_form", "ackermann", "unity_rank")
PLANT = system([[0, 1], [-2, -3]], B=[0, 1], C=[[1, 0]])
POLES = (sp.S(-3), -2 + 2 * sp.I, -2 - 2 * sp.I)


def numbers(*values):
    return tuple(sp.sympify(value) for value in values)


def array(M):
    return np.array(M.tolist(), dtype=float)


@pytest.mark.parametrize("method", METHODS)
def test_gains_worked_by_hand(method):
    # det(sI − Ā + B̄K̄) = s³ + (3 + k₂)s² + (2 + k₁)s + k_I against (s + 3)(s² + 4s + 8)
    result = ask("servo", PLANT, method, poles=POLES)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["K"] == sp.ImmutableMatrix([[18, 4]])
    assert result.answers["k_I"] == sp.ImmutableMatrix([[24]])
    assert result.answers["closed_loop_A"] == sp.ImmutableMatrix([[0, 1, 0], [-20, -7, 24], [-1, 0, 0]])


def test_the_error_vanishes_for_a_plant_that_is_not_quite_the_one_assumed():
    answers = ask("servo", PLANT, poles=POLES).answers
    K, k_I = array(answers["K"]), array(answers["k_I"])
    A, B, C = array(PLANT.A) * 1.07, array(PLANT.B) * 0.9, array(PLANT.C)
    loop = np.block([[A - B @ K, B @ k_I], [-C, np.zeros((1, 1))]])
    closed = control.ss(loop, np.array([[0], [0], [1]]), np.hstack([C, [[0]]]), 0)
    assert control.dcgain(closed) == pytest.approx(1)


@tried(12)
@given(systems(4), st.data())
def test_random_plants_have_the_poles_or_a_zero_at_the_origin(A, data):
    n = A.rows
    b, c = (
        sp.ImmutableMatrix(*shape, data.draw(st.lists(st.integers(-2, 2), min_size=n, max_size=n)))
        for shape in ((n, 1), (1, n))
    )
    assume(reachable_order(A, b) == n)
    method = data.draw(st.sampled_from(METHODS))
    poles = numbers(*range(-n - 1, 0))
    result = ask("servo", system(A, B=b, C=c), method, poles=poles)
    if sp.Matrix.vstack(sp.Matrix.hstack(A, b), sp.Matrix.hstack(c, sp.zeros(1))).det() == 0:
        assert result.status is Status.UNSOLVED
        assert "zero at the origin" in str(result.reason)
        return
    assert result.status is Status.VERIFIED, result.reason
    s = sp.Symbol("s")
    chi = sp.Matrix(result.answers["closed_loop_A"]).charpoly(s).as_expr()
    assert sp.expand(chi - sp.prod(s - pole for pole in poles)) == 0


def test_several_outputs_and_discrete_time():
    plant = system([[0, 1], [-1, -1]], B=[[0, 1], [1, 0]], C=[[1, 0], [0, 1]])
    result = ask("servo", plant, "unity_rank", poles=numbers(-1, -2, -3, -4))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["k_I"].shape == (2, 2)
    result = ask("servo", system([[0, 1], [1, 1]], B=[0, 1], C=[[1, 0]], discrete=True), poles=numbers(0, 0, 0))
    assert result.status is Status.VERIFIED, result.reason
    assert (sp.Matrix(result.answers["closed_loop_A"]) ** 3).is_zero_matrix


def test_fewer_inputs_than_outputs_are_unsolved_in_words():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0], [0, 1]])
    result = ask("servo", plant, poles=numbers(-1, -2, -3, -4))
    assert result.status is Status.UNSOLVED
    assert "fewer inputs" in str(result.reason)


def test_a_pole_for_each_state_and_integrator():
    faults = list(catalogue()["servo"].refused(PLANT, {"poles": numbers(-1, -2)}))
    assert [(option, str(fault)) for option, fault in faults] == [
        ("poles", "the closed loop has 3 poles; give 3, not 2")
    ]


@pytest.mark.parametrize("name", ["K", "k_I", "closed_loop_A"])
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answers = ask("servo", PLANT, poles=POLES).answers
    assert not rejected("servo", PLANT, {name: answers[name]}, poles=POLES)
    for i in range(len(answers[name])):
        changed = answers[name].as_mutable()
        changed[i] += sp.Rational(1, 1000)
        assert rejected("servo", PLANT, {name: sp.ImmutableMatrix(changed)}, poles=POLES)
        assert rejected("servo", PLANT, {**answers, name: sp.ImmutableMatrix(changed)}, poles=POLES)
    assert rejected("servo", PLANT, {name: sp.ImmutableMatrix(answers[name].T)[:, :0]}, poles=POLES)


def test_every_check_of_the_worked_example_passes():
    result = ask("servo", PLANT, poles=POLES)
    assert {check.status for check in result.checks} == {CheckStatus.PASSED}
