"""The four subspaces: steps, bases against scipy, empty ones, corruptions."""

import numpy as np
import scipy.linalg
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.systems import StateSpace
from tests.helpers.asking import ask, rejected, system
from tests.helpers.tried import tried

NAMES = ("null_space", "column_space", "row_space", "left_null_space")


def bare(rows):
    return StateSpace(sp.ImmutableMatrix(rows), bare=True)


@st.composite
def matrices(draw):
    """A product of two thin matrices, so that the rank is often deficient."""
    p, q, r = (draw(st.integers(1, 4)) for _ in range(3))
    entries = st.integers(-2, 2)
    return sp.Matrix(p, r, lambda i, j: draw(entries)) * sp.Matrix(r, q, lambda i, j: draw(entries))


@given(matrices())
@tried(25)
def test_bases_span_what_scipys_span(M):
    result = ask("fundamental_subspaces", bare(M))
    assert result.status is Status.VERIFIED, result.reason
    F = np.array(M, dtype=float)
    expected = {
        "null_space": scipy.linalg.null_space(F),
        "column_space": scipy.linalg.orth(F) if F.any() else np.zeros((M.rows, 0)),
        "row_space": scipy.linalg.orth(F.T) if F.any() else np.zeros((M.cols, 0)),
        "left_null_space": scipy.linalg.null_space(F.T),
    }
    for name, basis in expected.items():
        ours = np.array(result.answers[name], dtype=float).reshape(result.answers[name].shape)
        assert ours.shape == basis.shape
        assert np.allclose(basis @ (basis.T @ ours), ours)


def test_the_notes_example():
    result = ask("fundamental_subspaces", bare([[1, 0, 1], [0, 1, 1]]))
    assert [step.kind for step in result.steps] == [
        *["echelon", "null_space", "column_space", "row_space", "left_null_space", "dimensions"]
    ]
    assert result.answers["null_space"] == sp.Matrix([-1, -1, 1])
    assert result.answers["column_space"] == sp.eye(2)
    assert result.answers["row_space"] == sp.Matrix([[1, 0], [0, 1], [1, 1]])
    assert result.answers["left_null_space"] == sp.Matrix(2, 0, [])
    assert result.answers["rank"] == 2


def test_the_option_comes_before_the_system():
    result = ask("fundamental_subspaces", system([[1]]), matrix=sp.ImmutableMatrix([[1, 2], [2, 4], [0, 0]]))
    assert result.answers["null_space"] == sp.Matrix([-2, 1])
    assert result.answers["left_null_space"].shape == (3, 2)


def test_row_operations_lead_to_the_echelon_form():
    step = ask("fundamental_subspaces", bare([[2, 4], [1, 3]])).steps[0]
    assert step.values["reduced"] == sp.eye(2)
    assert step.steps[0].values["stages"][-1].after == sp.eye(2)


def test_parameters_are_general_and_exceptions_said():
    a = sp.Symbol("a", real=True)
    result = ask("fundamental_subspaces", bare([[1, a], [a, 1]]))
    assert result.answers["rank"] == 2
    assert set(result.steps[-1].values["exceptions"]) == {sp.Eq(a, 1), sp.Eq(a, -1)}


def test_other_bases_are_right_and_corrupted_ones_rejected():
    plant = bare([[1, 2, 3], [2, 4, 6]])
    answers = ask("fundamental_subspaces", plant).answers
    for name in NAMES:
        V = answers[name]
        other = V * (sp.Matrix([[1, 1], [1, 2]]) if V.cols == 2 else sp.Matrix([[-3]]))
        assert not rejected("fundamental_subspaces", plant, {name: sp.ImmutableMatrix(other)})
        changed = V.as_mutable()
        changed[0, 0] += sp.Rational(1, 1000)
        for wrong in (changed, V[:, :0], sp.Matrix.hstack(V, V), sp.zeros(*V.shape), V[:-1, :]):
            assert rejected("fundamental_subspaces", plant, {name: sp.ImmutableMatrix(wrong)}), (name, wrong)
    assert rejected("fundamental_subspaces", plant, {"rank": sp.Integer(2)})
    assert not rejected("fundamental_subspaces", bare([[1, 0], [0, 1]]), {"null_space": sp.ImmutableMatrix(2, 0, [])})
