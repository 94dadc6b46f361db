"""Similarity transformations: products by numpy, invariants, refusals, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given

from solver.derivation import Status
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.strategies import systems, unimodular
from tests.helpers.tried import tried

M = sp.Matrix
PLANT = system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0]])
MODAL = sp.ImmutableMatrix([[1, 1], [-1, -2]])


def test_eigenvectors_make_the_matrix_diagonal():
    result = ask("similarity_transformation", PLANT, T=MODAL)
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["A"], result.answers["B"]) == (sp.diag(-1, -2), M([1, -1]))
    assert (result.answers["C"], result.answers["D"]) == (M([[1, 1]]), M([[0]]))
    assert [step.kind for step in result.steps] == ["inverse", "system_matrix", "input_and_output", "unchanged"]


def test_complex_eigenvectors_are_a_transformation_too():
    plant = system([[0, 1], [-1, 0]])
    result = ask("similarity_transformation", plant, T=sp.ImmutableMatrix([[1, 1], [sp.I, -sp.I]]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers == {"A": sp.diag(sp.I, -sp.I)}


def test_parameters():
    a = sp.Symbol("a")
    result = ask("similarity_transformation", PLANT, T=sp.ImmutableMatrix([[a, 1], [0, 1]]))
    assert result.status is Status.VERIFIED, result.reason
    T = M([[a, 1], [0, 1]])
    assert (T * result.answers["A"] - PLANT.A * T).applyfunc(sp.cancel) == sp.zeros(2)


@tried(12)
@given(systems(3).flatmap(lambda A: unimodular(A.rows).map(lambda T: (A, T))))
def test_random_transformations(pair):
    A, T = pair
    plant = system(A, B=sp.ones(A.rows, 1), C=sp.ones(1, A.rows))
    result = ask("similarity_transformation", plant, T=sp.ImmutableMatrix(2 * T))
    assert result.status is Status.VERIFIED, result.reason
    A_float, T_float = (np.array(X, dtype=float) for X in (A, 2 * T))
    assert np.allclose(np.array(result.answers["A"], dtype=float), np.linalg.inv(T_float) @ A_float @ T_float)


@pytest.mark.parametrize("name", "ABCD")
def test_corrupted_answers_are_rejected_each_alone(name):
    right = ask("similarity_transformation", PLANT, T=MODAL).answers[name]
    assert not rejected("similarity_transformation", PLANT, {name: right}, T=MODAL)
    wrong = [right + sp.ones(*right.shape), right + sp.ones(*right.shape) / 1000]
    wrong += [X for X in (-right, right * 2) if right != X]
    for each in wrong:
        assert rejected("similarity_transformation", PLANT, {name: each}, T=MODAL)


def test_the_transformation_the_wrong_way_round_is_rejected():
    wrong = MODAL * PLANT.A * MODAL.inv()
    assert rejected("similarity_transformation", PLANT, {"A": wrong}, T=MODAL)


def test_a_singular_matrix_is_refused():
    task = catalogue()["similarity_transformation"]
    for T in (M([[1, 2], [2, 4]]), M([[sp.Symbol("a"), sp.Symbol("a")], [1, 1]])):
        ((option, message),) = task.refused(PLANT, {"T": sp.ImmutableMatrix(T)})
        assert option == "T"
        assert "singular" in str(message)
    ((_, message),) = task.refused(PLANT, {"T": sp.ImmutableMatrix(sp.eye(3))})
    assert "3×3" in str(message)
