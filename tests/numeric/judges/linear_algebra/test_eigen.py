"""Eigenvalues, vectors and chains judged by their equations: right ones pass, every corruption is rejected."""

import pytest
import sympy as sp

from solver.numeric import independent
from solver.numeric.judges.linear_algebra import (
    chain_residual,
    eigenpair_residual,
    left_residual,
    polynomial_residual,
    spectrum_residual,
)
from tests.helpers.comparing import is_error

x = sp.Symbol("lamda")
c = sp.Symbol("c", real=True)
r = sp.Symbol("r", positive=True)
I = sp.I


def similar(J, T):
    """(A, V, J, M): A V = V J with V = T, M = V⁻¹."""
    return T * J * T.inv(), T, J, T.inv()


T3 = sp.Matrix([[1, 0, 2], [1, 1, 0], [-1, 2, 1]])
SEVEN = sp.Matrix(7, 7, lambda i, j: -2 if i == j else int(j == i + 1))
CASES = {
    "distinct": similar(sp.diag(-1, -2, -3), T3),
    "defective": similar(sp.Matrix([[-1, 1, 0], [0, -1, 1], [0, 0, -1]]), T3),
    "two blocks": similar(sp.Matrix([[2, 1, 0], [0, 2, 0], [0, 0, 2]]), T3),
    "nilpotent": similar(sp.Matrix([[0, 1, 0], [0, 0, 1], [0, 0, 0]]), T3),
    "complex": similar(sp.diag(-1 + 2 * I, -1 - 2 * I), sp.Matrix([[1, 1], [1 + I, 1 - I]])),
    "surds": similar(sp.diag(1 + sp.sqrt(2), 1 - sp.sqrt(2)), sp.Matrix([[1, 1], [sp.sqrt(2), -sp.sqrt(2)]])),
    "wide": similar(sp.diag(10**6, sp.Rational(1, 10**6)), sp.Matrix([[1, 2], [1, 3]])),
    "parameter": similar(sp.diag(c, 2 * c), sp.Matrix([[1, 1], [c, 2]])),
    "root of a parameter": similar(sp.diag(sp.sqrt(r), -sp.sqrt(r)), sp.Matrix([[1, 1], [sp.sqrt(r), -sp.sqrt(r)]])),
    "zero": similar(sp.zeros(2), sp.eye(2)),
    "seven fold": similar(SEVEN, sp.Matrix(7, 7, lambda i, j: 1 if i >= j else 0)),
}


def diagonal(J):
    return [J[i, i] for i in range(J.rows)]


@pytest.fixture(params=CASES)
def case(request):
    return CASES[request.param]


def test_the_right_structure_passes(case):
    A, V, J, M = case
    assert chain_residual(A, V, J) <= 1e-9
    assert left_residual(A, M, J) <= 1e-9
    assert spectrum_residual(A, diagonal(J)) <= 1e-9
    assert independent(V)
    assert independent(M.T)
    if J.is_diagonal():
        assert eigenpair_residual(A, diagonal(J), V) <= 1e-9


def entry_changes(M):
    for i in range(M.rows):
        for j in range(M.cols):
            for entry in (-M[i, j], M[i, j] + 1, M[i, j] * sp.Rational(1001, 1000)):
                other = M.as_mutable()
                other[i, j] = entry
                if other != M:
                    yield other


def test_every_change_of_an_entry_that_breaks_the_equation_is_rejected(case):
    A, V, J, M = case
    for wrong in entry_changes(V):
        if not _zero(A * wrong - wrong * J):
            assert is_error(chain_residual(A, wrong, J)), wrong
    for wrong in entry_changes(M):
        if not _zero(wrong * A - J * wrong):
            assert is_error(left_residual(A, wrong, J)), wrong
    for wrong in entry_changes(J):
        if not _zero(A * V - V * wrong):
            assert is_error(chain_residual(A, V, wrong)), wrong


def _zero(M):
    return all(sp.expand(sp.radsimp(entry)) == 0 for entry in M)


def test_wrong_multiplicities_and_wrong_eigenvalues_are_rejected(case):
    A, _, J, _ = case
    right = diagonal(J)
    for i, value in enumerate(right):
        for wrong in (value + 1, value * sp.Rational(1000001, 1000000) + sp.Rational(1, 10**8), *right):
            changed = [*right[:i], wrong, *right[i + 1 :]]
            if wrong != value:
                assert is_error(spectrum_residual(A, changed)), changed
    assert spectrum_residual(A, right[:-1]) == float("inf")
    assert spectrum_residual(A, [*right, right[0]]) == float("inf")


@pytest.mark.parametrize("name", ["distinct", "complex", "surds", "parameter"])
def test_vectors_in_another_order_than_their_eigenvalues_are_rejected(name):
    A, V, J, M = CASES[name]
    swapped = V.copy()
    swapped.col_swap(0, 1)
    assert is_error(eigenpair_residual(A, diagonal(J), swapped))
    assert is_error(chain_residual(A, swapped, J))
    rows = M.copy()
    rows.row_swap(0, 1)
    assert is_error(left_residual(A, rows, J))


def test_a_dropped_superdiagonal_or_a_transposed_block_is_rejected():
    A, V, J, M = CASES["defective"]
    assert is_error(chain_residual(A, V, sp.diag(-1, -1, -1)))
    assert is_error(chain_residual(A, V, J.T))
    assert is_error(left_residual(A, M, J.T))
    assert is_error(chain_residual(A, V.T, J))


def test_left_and_right_are_not_confused():
    A, V, J, M = CASES["distinct"]
    assert is_error(chain_residual(A, M, J))
    assert is_error(left_residual(A, V, J))


def test_scaled_vectors_are_as_good_and_zero_vectors_are_none():
    A, V, J, _ = CASES["distinct"]
    scaled = V * sp.diag(sp.Rational(1, 10**7), -5, 10**6)
    assert chain_residual(A, scaled, J) <= 1e-9
    assert independent(scaled)
    nothing = V.copy()
    nothing[:, 1] = sp.zeros(3, 1)
    assert chain_residual(A, nothing, J) == float("inf")
    assert eigenpair_residual(A, diagonal(J), nothing) == float("inf")
    assert left_residual(A, sp.zeros(3), J) == float("inf")
    assert not independent(nothing)


def test_dependent_columns_are_found_however_close_the_independent_ones_are():
    close = sp.Matrix([[1, 1], [1, 1 + sp.Rational(1, 10**20)]])
    assert independent(close)
    assert not independent(sp.Matrix([[1, 2], [sp.sqrt(2), 2 * sp.sqrt(2)]]))
    assert not independent(sp.Matrix([[1, 0, 1], [0, 1, 1]]))
    assert not independent(sp.Matrix([[c, 2 * c], [1, 2]]))
    assert independent(sp.Matrix([[c, 2], [1, 2]]))
    assert independent(sp.Matrix(3, 0, []))
    assert independent(sp.Matrix(10, 10, lambda i, j: sp.Integer(-(j + 1)) ** i))
    decimals = sp.Matrix([[sp.Float("0.333333333333333", 15), 1], [sp.Float("0.666666666666667", 15), 2]])
    assert not independent(decimals)


def test_misshapen_answers_are_rejected():
    A, V, J, M = CASES["distinct"]
    assert eigenpair_residual(A, [-1, -2], V) == float("inf")
    assert chain_residual(A, V[:, :2], J) == float("inf")
    assert left_residual(A, M[:2, :], J) == float("inf")


def test_some_eigenpairs_may_be_judged_alone():
    A, V, _, _ = CASES["distinct"]
    assert eigenpair_residual(A, [-1, -3], V.extract([0, 1, 2], [0, 2])) <= 1e-9


def test_the_characteristic_polynomial_passes_and_every_wrong_coefficient_is_rejected(case):
    A, _, J, _ = case
    right = sp.Poly(sp.expand(sp.prod([x - value for value in diagonal(J)])), x)
    assert polynomial_residual(A, right.as_expr(), x) <= 1e-9
    assert polynomial_residual(A, sp.prod([x - value for value in diagonal(J)]), x) <= 1e-9
    coefficients = right.all_coeffs()
    for i, coefficient in enumerate(coefficients):
        for wrong in (-coefficient, coefficient + 1, coefficient * sp.Rational(1001, 1000)):
            changed = sum((wrong if i == j else each) * x ** (A.rows - j) for j, each in enumerate(coefficients))
            if sp.expand(changed - right.as_expr()) != 0:
                assert is_error(polynomial_residual(A, changed, x)), changed
    assert is_error(polynomial_residual(A, -right.as_expr(), x))
    assert is_error(polynomial_residual(A, right.as_expr().subs(x, -x) * 2, x))


def test_eigenvalues_in_decimals_pass_with_the_digits_they_have():
    A = sp.Matrix([[0, 1, 0], [0, 0, 1], [-1, -1, 0]])
    roots = [sp.N(root, 15) for root in sp.Poly(x**3 + x + 1, x).nroots(n=30)]
    assert spectrum_residual(A, roots) <= 1e-9
    assert is_error(spectrum_residual(A, [roots[0] * sp.Float("1.0000001"), *roots[1:]]))
