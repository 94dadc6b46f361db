"""Minimal realizations: order by python's own means, transfer function by numpy, corruptions."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.fractions_of_polynomials import fraction, numbers, plant, s, values
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

M = sp.Matrix
DIAGONAL = system(sp.diag(-1, -2, -3, -4), B=[[1], [1], [0], [0]], C=[[1, 0, 1, 0]])


def test_one_mode_of_four_is_left():
    result = ask("minimal_realization", DIAGONAL)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"] == M([[-1]])
    assert sorted(result.answers["cancelled"]) == [-4, -3, -2]
    assert [step.kind for step in result.steps] == ["reduction", "reduction", "modes_left_out", "assembled"]


def test_a_minimal_system_stays_as_it_is():
    result = ask("minimal_realization", system([[0, 1], [-2, -3]], B=[[0], [1]], C=[[1, 0]]))
    assert result.answers["A"] == M([[0, 1], [-2, -3]])
    assert result.answers["cancelled"] == []
    assert result.status is Status.VERIFIED


def test_a_fraction_is_cancelled_first():
    result = ask("minimal_realization", plant((s + 2) * (s + 1), (s + 2) * (s + 3) * (s + 4)))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"] == M([[0, 1], [-12, -7]])
    assert result.answers["cancelled"] == [-2]


@pytest.mark.parametrize("top", [3 * (s + 1), sp.Integer(0)])
def test_nothing_may_be_left(top):
    result = ask("minimal_realization", plant(top, s + 1))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"].shape == (0, 0)
    assert result.answers["cancelled"] == [-1]


def test_no_state_is_both_controllable_and_observable():
    result = ask("minimal_realization", system([[-1, 0], [0, -2]], B=[[1], [0]], C=[[0, 1]], D=[[5]]))
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["A"].shape, result.answers["D"]) == ((0, 0), M([[5]]))


def test_a_transfer_matrix_of_rank_one_needs_one_state():
    G = plant([(1, s + 1), (2, s + 1)], [(1, s + 1), (2, s + 1)])
    result = ask("minimal_realization", G)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["A"] == M([[-1]])
    for point in (0.3 + 0.4j, 2.0):
        assert np.allclose(values(result.answers, point), fraction(G, point))


def test_parameters_are_taken_as_general():
    a = sp.Symbol("a")
    result = ask("minimal_realization", system([[0, 1], [-a, -a - 1]], B=[[0], [1]], C=[[1, 1]]))
    assert result.status is Status.VERIFIED, result.reason
    assert (result.answers["A"], result.answers["cancelled"]) == (M([[-a]]), [-1])


def ranks(A, B, C):
    """Order of the minimal part: the rank of observability times controllability matrix, exactly."""
    n = A.rows
    reach = M.hstack(*(A**i * B for i in range(n)))
    see = M.vstack(*(C * A**i for i in range(n)))
    return (see * reach).rank()


@tried(15)
@given(systems(4), st.data(), st.integers(1, 2), st.integers(1, 2))
def test_random_plants(A, data, m, p):
    entry = st.sampled_from([0, 0, 1, -1])
    B = M(A.rows, m, lambda i, j: data.draw(entry))
    C = M(p, A.rows, lambda i, j: data.draw(entry))
    result = ask("minimal_realization", system(A, B=B, C=C))
    assert result.status is Status.VERIFIED, result.reason
    n = ranks(M(A), B, C)
    assert result.answers["A"].shape == (n, n)
    assert len(result.answers["cancelled"]) == A.rows - n
    for point in (0.37 + 0.81j, -2.31 + 0.11j):
        expected = numbers(C) @ np.linalg.solve(point * np.eye(A.rows) - numbers(A), numbers(B))
        assert np.allclose(values(result.answers, point), expected, rtol=1e-8, atol=1e-8)


def test_any_coordinates_are_right():
    answers = {"A": M([[-1]]), "B": M([[-4]]), "C": M([[sp.Rational(-1, 4)]]), "D": M([[0]])}
    assert not rejected("minimal_realization", DIAGONAL, answers)


@pytest.mark.parametrize("name", "ABCD")
def test_corrupted_answers_are_rejected(name):
    answers = dict(ask("minimal_realization", DIAGONAL).answers)
    assert rejected("minimal_realization", DIAGONAL, {**answers, name: answers[name] + sp.ones(1, 1)})


def test_a_realization_that_is_not_minimal_is_rejected():
    answers = {name: getattr(DIAGONAL, name) for name in "ABC"}
    assert rejected("minimal_realization", DIAGONAL, {**answers, "D": M([[0]])})
    assert rejected("minimal_realization", DIAGONAL, {"A": DIAGONAL.A})


@pytest.mark.parametrize("wrong", [[], [-2, -3], [-2, -3, -5], [-2, -3, -4, -1]])
def test_wrong_lists_of_cancelled_modes_are_rejected(wrong):
    assert not rejected("minimal_realization", DIAGONAL, {"cancelled": [-3, -4, -2]})
    assert rejected("minimal_realization", DIAGONAL, {"cancelled": list(map(sp.Integer, wrong))})
