"""Ranks, hidden parts, rank conditions and Gramian kernels against numpy, sympy and definitions."""

from functools import reduce

import numpy as np
import pytest
import scipy.linalg
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver import exact
from solver.numeric.judges.structure import rank_falls_where
from tests.helpers.exact_cases import companion
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

M = sp.ImmutableMatrix
a, b, c = sp.symbols("a b c", real=True)
x = sp.Symbol("x")
p, less, least = sp.Symbol("p", positive=True), sp.Symbol("l", negative=True), sp.Symbol("q", nonnegative=True)


@given(systems(5), st.integers(1, 2), st.data())
@tried(25)
def test_the_hidden_part_is_annihilated_and_invariant(A, m, data):
    B = M(A.rows, m, [data.draw(st.integers(-1, 1)) for _ in range(A.rows * m)])
    hidden, C = exact.hidden_part(A, B), exact.controllability_matrix(A, B)
    assert exact.rank(C) == C.rank()
    if hidden is None:
        assert C.rank() == A.rows
    else:
        assert sp.zeros(hidden.N.rows, C.cols) == hidden.N * C
        assert hidden.N * A == hidden.H * hidden.N
        assert hidden.N.rows == A.rows - C.rank()
        assert len(hidden.spectrum.eigenvalues) == hidden.N.rows


@given(systems(4), st.data())
@tried(20)
def test_the_pencil_loses_rank_exactly_at_hidden_modes(A, data):
    B = M(A.rows, 1, [data.draw(st.integers(-1, 1)) for _ in range(A.rows)])
    low = {found.root.value for found in exact.pencil_ranks(A, B) if found.rank < A.rows}
    hidden = exact.hidden_part(A, B)
    assert low == set(hidden.spectrum.eigenvalues if hidden else ())
    for found in exact.pencil_ranks(A, B):
        assert sp.expand(found.unreached * found.pencil) == sp.zeros(found.unreached.rows, A.rows + 1)
        assert found.unreached.rows == A.rows - found.rank


@pytest.mark.parametrize("hidden", [x**2 + 2 * x + 5, x**2 - 2, x**3 - x - 1])
def test_what_is_not_reached_of_a_pair_is_told_row_by_row(hidden):
    """A block that the input does not touch, in other coordinates: every root has its row w, w [λI − A, B] = 0."""
    block, n = companion(hidden), sp.degree(hidden) + 1
    T = sp.Matrix(n, n, lambda i, j: int(i == j) + int(i == j + 1))
    A, B = M(T * sp.diag(block, -1) * T.inv()), M(T * sp.Matrix([0] * (n - 1) + [1]))
    low = [found for found in exact.pencil_ranks(A, B) if found.rank < n]
    assert len(low) == n - 1
    for found in low:
        assert found.unreached.rows == 1
        assert max(abs(sp.N(entry, 20)) for entry in found.unreached * found.pencil) < 1e-15


@pytest.mark.parametrize(
    ("matrix", "conditions"),
    [
        (M([[1, 2], [2, 4]]), set()),
        (M([[a, 0], [0, b]]), {sp.Eq(a, 0), sp.Eq(b, 0)}),
        (M([[a, b]]), {sp.And(sp.Eq(a, 0), sp.Eq(b, 0))}),
        (M([[a, a], [1, 1]]), set()),
        (M([[a, 1], [1, a]]), {sp.Eq(a, 1), sp.Eq(a, -1)}),
        (M([[a**2 + 1]]), set()),
        (M([[1 / a, b / a], [b, a]]), {sp.Eq(a - b**2, 0)}),
        (M([[sp.cos(a), sp.sin(a)], [-sp.sin(a), sp.cos(a)]]), set()),
        (M([[1 + sp.cos(a)]]), {sp.Eq(sp.cos(a) + 1, 0)}),
        (M([[p]]), set()),
        (M([[p * (p - 1)]]), {sp.Eq(p, 1)}),
        (M([[p**3 - p**2 + 2 * p + 1]]), set()),  # its only real root is negative, and so is the next one's
        (M([[least**3 - least**2 + 2 * least + 1]]), set()),
        (M([[less**3 + less**2 + 2 * less - 1]]), set()),  # its only real root is positive
        (M([[p * (sp.exp(p) - 1)]]), set()),  # e^p = 1 for p = 0 alone
        (M([[sp.exp(a) + 1]]), set()),
        (M([[sp.exp(-p) - 2]]), set()),  # p = −log 2
        (M([[2 * sp.exp(-p) - 1]]), {sp.Eq(p, sp.log(2))}),
        (M([[less**3 - less**2 + 2 * less + 1]]), {sp.Eq(less**3 - less**2 + 2 * less + 1, 0)}),
    ],
)
def test_rank_conditions(matrix, conditions):
    assert set(exact.rank_conditions(matrix)) == conditions


def test_the_rank_falls_where_conditions_of_codimension_two_hold():
    found = exact.rank_conditions(M([[a * b, b * c, a * c]]))
    assert len(found) == 3
    for condition in found:
        assert rank_falls_where(M([[a * b, b * c, a * c]]), condition)


@pytest.mark.parametrize(
    ("matrix", "values"),
    [
        (M([[1, 2 + a * (a - 1)], [a, 2 * a]]), (0, 1)),
        (M([[a * (a**2 + 1), 0, a], [0, a**2 - 2, a]]), (0,)),
        (M([[b * (a - 1), 0], [0, a**2 - b]]), (1, -sp.sqrt(b), sp.sqrt(b))),
        (M([[1, a], [0, 3]]), ()),
    ],
)
def test_critical_values(matrix, values):
    assert exact.critical_values(matrix, a).values == values


def test_complex_values_are_left_out():
    found = exact.critical_values(M([[a**2 + 4]]), a)
    assert (found.values, set(found.left_out)) == ((), {2 * sp.I, -2 * sp.I})


def test_telling_minors_share_the_common_zeros():
    matrix = M([[a, 1, 0], [0, a - 1, a * (a - 1)]])
    chosen = exact.telling_minors(matrix, a)
    values = [sp.Poly(value, a, domain="QQ") for _, value in chosen]
    assert reduce(sp.gcd, values).monic() == sp.Poly(a * (a - 1), a, domain="QQ")
    for columns, value in chosen:
        assert sp.expand(matrix[:, columns].det() - value) == 0


@pytest.mark.parametrize("polynomial", [x**2 + 2 * x + 5, (x**2 + 9) * (x + 1), (x**2 + 2 * x + 5) ** 2, x**2, x - 1])
def test_finite_gramians_of_pairs_and_repeated_roots(polynomial):
    is_that_of_van_loan(companion(polynomial))


@given(systems(4))
@tried(10)
def test_finite_gramians_are_those_of_van_loan(A):
    is_that_of_van_loan(A)


def is_that_of_van_loan(A):
    B = M(A.rows, 1, [1] * A.rows)
    W = exact.finite_gramian(A, B, sp.Integer(1))
    F, G, n = np.array(A, dtype=float), np.ones((A.rows, 1)), A.rows
    E = scipy.linalg.expm(np.block([[-F, G @ G.T], [np.zeros((n, n)), F.T]]))
    expected = E[n:, n:].T @ E[:n, n:]
    assert np.allclose(np.array(W.evalf(30), dtype=float), expected, rtol=1e-6, atol=1e-7 * (1 + abs(expected).max()))


def test_null_vectors_have_a_positive_free_unknown_and_no_fractions():
    assert exact.null_basis(M([[2, 3, 0]])) == M([[-3, 0], [2, 0], [0, 1]])
    assert exact.null_basis(M([[1, 0], [0, 1]])) == sp.Matrix(2, 0, [])
