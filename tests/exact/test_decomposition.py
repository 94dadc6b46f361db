"""Kalman's decompositions: the zero pattern, the ranks and the invariance of what is decomposed."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.exact import (
    controllable_decomposition,
    controllable_part,
    kalman_decomposition,
    observable_decomposition,
    rank_conditions,
    reached_in_echelon,
    seen_in_echelon,
)
from tests.helpers.strategies import eigenvalues, jordan_block, unimodular
from tests.helpers.tried import tried

a, b = sp.symbols("a b")
M = sp.ImmutableMatrix


@st.composite
def plants(draw, largest=5):
    """(A, B, C) with hidden parts as often as not: Jordan blocks, of which inputs and outputs meet some."""
    n = draw(st.integers(1, largest))
    blocks, left = [], n
    while left:
        size = draw(st.integers(1, min(left, 2)))
        blocks.append(jordan_block(draw(eigenvalues), size))
        left -= size
    inputs, outputs = draw(st.integers(1, 2)), draw(st.integers(1, 2))
    sparse = st.sampled_from([0, 0, 1, -1, 2])
    B = sp.Matrix(n, inputs, lambda *_: draw(sparse))
    C = sp.Matrix(outputs, n, lambda *_: draw(sparse))
    T = draw(unimodular(n))
    return M(T * sp.diag(*blocks) * T.inv()), M(T * B), M(C * T.inv())


def rank_of_reached(A, B):
    return sp.Matrix.hstack(*(A**i * B for i in range(A.rows))).rank()


def is_transformed(found, A, B, C):
    return found.T * found.A == A * found.T and found.T * found.B == B and found.C == C * found.T


@tried(25)
@given(plants())
def test_in_echelon_bases_the_parts_are_the_same(plant):
    A, B, C = plant
    reached, seen = reached_in_echelon(A, B, C), seen_in_echelon(A, B, C)
    assert reached.orders == controllable_decomposition(A, B, C).orders
    assert seen.orders == observable_decomposition(A, B, C).orders
    assert is_transformed(reached, A, B, C)
    assert is_transformed(seen, A, B, C)
    assert reached.block(1, 0).is_zero_matrix
    assert reached.input_block(1).is_zero_matrix
    assert seen.block(0, 1).is_zero_matrix
    assert seen.output_block(1).is_zero_matrix


@tried(25)
@given(plants())
def test_the_controllable_part_is_all_that_the_input_reaches(plant):
    A, B, C = plant
    found = controllable_decomposition(A, B, C)
    r = rank_of_reached(A, B)
    assert found.orders == [r, A.rows - r]
    assert is_transformed(found, A, B, C)
    assert found.block(1, 0).is_zero_matrix
    assert found.input_block(1).is_zero_matrix
    assert rank_of_reached(found.block(0, 0), found.input_block(0)) == r if r else True
    assert found.trivial == (r == A.rows) == (sp.eye(A.rows) == found.T and r == A.rows)


@tried(25)
@given(plants())
def test_single_states_may_stand_for_what_the_input_does_not_reach(plant):
    A, B, _ = plant
    found, other = controllable_part(A, B), controllable_decomposition(A, B)
    assert found.orders == other.orders
    assert found.bases[0] == other.bases[0]
    assert found.T * found.A == A * found.T
    assert found.T * found.B == B
    assert found.block(1, 0).is_zero_matrix
    assert all(sorted(unit) == [0] * (A.rows - 1) + [1] for unit in found.bases[1].T.tolist())


@tried(25)
@given(plants())
def test_the_observable_part_is_dual(plant):
    A, B, C = plant
    found = observable_decomposition(A, B, C)
    q = rank_of_reached(A.T, C.T)
    assert found.orders == [q, A.rows - q]
    assert is_transformed(found, A, B, C)
    assert found.block(0, 1).is_zero_matrix
    assert found.output_block(1).is_zero_matrix


ZEROS = [(0, 1), (0, 3), (2, 0), (2, 1), (2, 3), (3, 0), (3, 1)]


@tried(25)
@given(plants())
def test_the_full_decomposition_has_its_seven_zero_blocks(plant):
    A, B, C = plant
    found = kalman_decomposition(A, B, C)
    r, q = rank_of_reached(A, B), rank_of_reached(A.T, C.T)
    assert sum(found.orders[:2]) == r
    assert found.orders[0] + found.orders[2] == q
    assert is_transformed(found, A, B, C)
    assert all(found.block(i, j).is_zero_matrix for i, j in ZEROS)
    assert all(found.input_block(i).is_zero_matrix for i in (2, 3))
    assert all(found.output_block(j).is_zero_matrix for j in (1, 3))
    k, first = found.orders[0], (found.block(0, 0), found.input_block(0), found.output_block(0))
    if k:
        assert rank_of_reached(*first[:2]) == rank_of_reached(first[0].T, first[2].T) == k


def test_the_printed_matrices_of_the_course():
    A, B, C = M([[-2, -2, -2], [1, 0, 0], [1, 1, -1]]), M([1, 0, 0]), M([[1, 1, 0]])
    found = controllable_decomposition(A, B, C)
    assert M([[1, -2, 0], [0, 1, -1], [0, 1, 1]]) == found.T
    assert M([[0, -4, -2], [1, -2, -1], [0, 0, -1]]) == found.A
    assert M([[1, -1, -1]]) == found.C
    assert found.hidden_modes == [-1]
    companion = M([[0, 1, 0], [0, 0, 1], [-6, -11, -6]])
    seen = observable_decomposition(companion, M([0, 0, 1]), M([[2, 1, 0]]))
    assert M([[2, 0, 1], [1, 2, -2], [0, 1, 4]]) == seen.T
    assert M([[56, 77, 0], [-119, -140, 0], [-91, -112, -42]]) == seen.A * 21
    assert M([-2, 5, 4]) == seen.B * 21


def test_no_input_and_no_output_leave_everything_hidden():
    A = M([[0, 1], [-2, -3]])
    found = kalman_decomposition(A, M([0, 0]), M([[0, 0]]))
    assert found.orders == [0, 0, 0, 2]
    assert sp.eye(2) == found.T
    assert sorted(found.hidden_modes) == [-2, -1]
    assert found.block(0, 0).shape == (0, 0)
    assert found.input_block(0).shape == (0, 1)


def test_parameters_and_roots_keep_their_field():
    A = M([[sp.sqrt(2), 0, 1], [0, b, 0], [0, 0, -1]])
    found = kalman_decomposition(A, M([1, 0, 1]), M([[1, 1, 0]]))
    assert found.orders == [2, 0, 1, 0]
    assert found.block(0, 0) == M([[0, sp.sqrt(2)], [1, sp.sqrt(2) - 1]])
    assert found.hidden_modes == [b]


def test_the_generic_rank_is_taken_where_parameters_decide():
    found = controllable_decomposition(M([[a, 1], [0, b]]), M([1, a]))
    assert found.orders == [2, 0]


@pytest.mark.parametrize("seed", range(3))
def test_the_visible_part_has_the_impulse_response_of_the_plant(seed):
    random = np.random.default_rng(seed)
    A = M(random.integers(-2, 3, (4, 4)).tolist())
    A = M(sp.diag(A[:2, :2], A[2:, 2:]))
    B, C = M([[1, 0], [0, 1], [0, 0], [0, 0]]), M([[1, 1, 0, 1]])
    found = kalman_decomposition(A, B, C)
    k = found.orders[0]
    visible = found.A[:k, :k], found.B[:k, :], found.C[:, :k]
    for i in range(6):
        assert visible[2] * visible[0] ** i * visible[1] == C * A**i * B


def test_a_vanishing_denominator_is_no_condition_for_the_rank():
    m = sp.Symbol("m")
    assert rank_conditions(M([[1 / m, -b / m**2], [0, 1 / m]])) == ()
    assert rank_conditions(M([[a / m, -b / m**2], [0, 1 / m]])) == (sp.Eq(a, 0),)
