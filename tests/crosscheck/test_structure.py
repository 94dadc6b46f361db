"""Controllability, observability, decompositions: three tests against each other, numpy, scipy and exact ranks."""

import control
import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import expm, null_space, solve_continuous_lyapunov, solve_discrete_lyapunov

from solver.derivation import Unsolved
from tests.helpers.comparing import (
    answers_of,
    characteristic,
    close,
    coefficients,
    floats,
    krylov,
    product,
    rank_modulo_a_prime,
    same,
    systems_tried,
)
from tests.helpers.strategies import plain_plants, plants

PAIRS = {
    "controllability": ("controllable", "controllability_matrix", "uncontrollable_modes"),
    "observability": ("observable", "observability_matrix", "unobservable_modes"),
}


def pair_of(task, plant):
    return (plant.A, plant.B) if task == "controllability" else (plant.A.T, plant.C.T)


def hidden_coefficients(A, B):
    """The polynomial of what (A, B) does not reach, exact: χ divided by that of the part in the range of [B, AB, …]."""
    wide = krylov(A, B)
    T = sp.Matrix.hstack(*wide.columnspace())
    reached = (T.T * T).LUsolve(T.T * sp.Matrix(A) * T) if T.cols else sp.Matrix(0, 0, [])
    x = sp.Symbol("x")
    part = sp.Poly(characteristic(reached) if T.cols else [1], x)
    quotient, remainder = sp.div(sp.Poly(characteristic(A), x), part)
    assert remainder.is_zero
    return quotient.all_coeffs()


def check_pair(task, plant):
    verdict, matrix, modes = PAIRS[task]
    A, B = pair_of(task, plant)
    wide = krylov(A, B)
    true_rank = rank_modulo_a_prime(wide)
    for method in ("rank", "pbh"):
        answers = answers_of(task, plant, method)
        assert answers["rank"] == true_rank
        assert bool(answers[verdict]) == (true_rank == A.rows)
        assert answers.get(modes) is None or [sp.expand(c) for c in coefficients(answers[modes])] == (
            hidden_coefficients(A, B)
        )
        assert (modes in answers and len(answers[modes]) > 0) == (true_rank < A.rows)
    ours = answers_of(task, plant, "rank")[matrix]
    assert same(ours if task == "controllability" else ours.T, wide)
    made = control.ctrb(floats(A), floats(B))
    assert close(floats(wide), made)


@systems_tried(60)
@given(plants(discrete=None), st.sampled_from(sorted(PAIRS)))
def test_rank_and_popov_belevitch_hautus_agree_with_exact_ranks(made, task):
    check_pair(task, made.system)


@systems_tried(20)
@given(plain_plants(5), st.sampled_from(sorted(PAIRS)))
def test_they_agree_where_eigenvalues_are_of_any_degree(plant, task):
    check_pair(task, plant)


@systems_tried(40)
@given(plants(discrete=None, stable=True), st.sampled_from(sorted(PAIRS)))
def test_the_gramian_of_a_stable_system_gives_the_same_verdict(made, task):
    verdict = PAIRS[task][0]
    plant = made.system
    A, B = pair_of(task, plant)
    answers = answers_of(task, plant, "gramian")
    W = answers["gramian"]
    Q = product(B, B.T)
    if plant.discrete:
        assert same(product(A, W, A.T) + Q, W)
        theirs = solve_discrete_lyapunov(floats(A), floats(Q))
    else:
        assert same(product(A, W) + product(W, A.T), -Q)
        theirs = solve_continuous_lyapunov(floats(A), -floats(Q))
    assert close(floats(W), theirs, 1e-5)
    by_rank = answers_of(task, plant, "rank")
    assert answers[verdict] == by_rank[verdict]
    assert answers["rank"] == by_rank["rank"] == rank_modulo_a_prime(W)


@systems_tried(20)
@given(plants(4), st.sampled_from(sorted(PAIRS)), st.sampled_from([sp.S.One, sp.Rational(1, 2)]))
def test_the_gramian_of_a_finite_time_is_the_integral(made, task, horizon):
    verdict = PAIRS[task][0]
    A, B = (floats(M) for M in pair_of(task, made.system))
    answers = answers_of(task, made.system, "gramian", horizon=horizon)
    n = len(A)  # van Loan: exp([[−A, BBᵀ], [0, Aᵀ]] T) holds the integral
    whole = expm(np.block([[-A, B @ B.T], [np.zeros((n, n)), A.T]]) * float(horizon))
    assert close(floats(answers["gramian"]), whole[n:, n:].T @ whole[:n, n:], 1e-6)
    assert answers[verdict] == answers_of(task, made.system, "rank")[verdict]


@systems_tried(20)
@given(plants(discrete=None))
def test_a_gramian_is_refused_where_its_integral_diverges(made):
    decays = all(block.decays(made.system.discrete) for block in made.blocks)
    if decays:
        assert answers_of("controllability", made.system, "gramian")
    else:
        with pytest.raises(Unsolved):
            answers_of("controllability", made.system, "gramian")


@systems_tried(40)
@given(plants(discrete=None))
def test_stabilizability_and_detectability_ask_for_the_hidden_modes_only(made):
    plant = made.system
    for task, verdict, pair in (
        ("stabilizability", "stabilizable", (plant.A, plant.B)),
        ("detectability", "detectable", (plant.A.T, plant.C.T)),
    ):
        answers = answers_of(task, plant)
        hidden = hidden_coefficients(*pair)
        assert [sp.expand(c) for c in coefficients(answers["hidden_modes"])] == hidden
        roots = np.array([complex(sp.sympify(r)) for r in answers["hidden_modes"]])
        decays = np.abs(roots) < 1 - 1e-9 if plant.discrete else roots.real < -1e-9
        assert bool(answers[verdict]) == bool(np.all(decays))


@systems_tried(50)
@given(plants(discrete=None), st.sampled_from(["controllable", "observable", "full"]))
def test_decompositions_have_their_zeros_and_the_orders_of_exact_ranks(made, part):
    plant = made.system
    answers = answers_of("kalman_decomposition", plant, part=part)
    T, A, B, C = (answers[name] for name in "TABC")
    assert rank_modulo_a_prime(T) == plant.order
    assert same(product(plant.A, T), product(T, A))
    assert same(product(T, B), plant.B)
    assert same(product(plant.C, T), C)
    reached, seen = krylov(plant.A, plant.B), krylov(plant.A.T, plant.C.T).T
    r, o, both = rank_modulo_a_prime(reached), rank_modulo_a_prime(seen), rank_modulo_a_prime(product(seen, reached))
    n = plant.order
    orders = {
        "controllable": [r, n - r],
        "observable": [o, n - o],
        "full": [both, r - both, o - both, n - r - o + both],
    }[part]
    assert list(answers["orders"]) == orders
    if part == "controllable":
        assert A[r:, :r].is_zero_matrix
        assert B[r:, :].is_zero_matrix
    elif part == "observable":
        assert A[:o, o:].is_zero_matrix
        assert C[:, o:].is_zero_matrix
    else:
        first, second, third = orders[0], orders[0] + orders[1], sum(orders[:3])
        assert A[:first, first:second].is_zero_matrix
        assert A[:first, third:].is_zero_matrix
        assert A[second:, :second].is_zero_matrix
        assert A[second:third, third:].is_zero_matrix
        assert B[second:, :].is_zero_matrix
        assert C[:, first:second].is_zero_matrix
        assert C[:, third:].is_zero_matrix


@systems_tried(30)
@given(plants(discrete=None))
def test_fundamental_subspaces_have_the_dimensions_and_directions_of_scipy(made):
    M = product(made.system.A, made.system.A) + made.system.A  # has kernels often: 0 and −1 are frequent eigenvalues
    answers = answers_of("fundamental_subspaces", made.system, matrix=sp.ImmutableMatrix(M))
    true_rank = rank_modulo_a_prime(M)
    assert answers["rank"] == true_rank
    for name, of in (("null_space", M), ("left_null_space", M.T)):
        basis = answers[name]
        assert basis.cols == M.rows - true_rank
        if basis.cols:
            assert rank_modulo_a_prime(basis) == basis.cols
            assert product(of, basis).is_zero_matrix
            theirs = null_space(floats(of), rcond=1e-9)
            if theirs.shape[1] == basis.cols:  # scipy decides the rank in floating point
                assert np.linalg.matrix_rank(np.hstack([theirs, floats(basis)]), tol=1e-6) == basis.cols
    for name, of in (("column_space", M), ("row_space", M.T)):
        basis = answers[name]
        assert basis.cols == true_rank
        if true_rank:
            assert rank_modulo_a_prime(sp.Matrix.hstack(of, basis)) == rank_modulo_a_prime(basis) == true_rank
