"""Jordan structure, signs of eigenvalues and exponentials where entries differ by many orders of magnitude."""

import numpy as np
import pytest
import sympy as sp

from solver.exact import definiteness_of_numbers, riccati
from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.judges import linear_algebra, optimal, time_response
from solver.numeric.judges.optimal.riccati_solutions import definiteness_holds

lamda = sp.Symbol("lamda")


def companion(*roots):
    coefficients = sp.Poly(sp.prod([lamda - root for root in roots]), lamda).all_coeffs()
    n = len(roots)
    return sp.ImmutableMatrix(n, n, lambda i, j: int(j == i + 1) if i < n - 1 else -coefficients[n - j])


def test_the_ten_eigenvalues_of_a_companion_matrix_are_told_apart():
    A = companion(*range(-10, 0))
    assert linear_algebra.diagonalizable(A)
    assert linear_algebra.same_jordan_structure(A, sp.ImmutableMatrix(sp.diag(*range(-10, 0))))
    assert not linear_algebra.same_jordan_structure(
        A, sp.ImmutableMatrix(sp.diag(*range(-10, -1), sp.Rational(-1001, 1000)))
    )


def test_the_blocks_of_a_companion_matrix_with_large_entries():
    A = companion(-3, -3, -3, -8, -8, 20)
    J = sp.diag(sp.Matrix([[-3, 1, 0], [0, -3, 1], [0, 0, -3]]), sp.Matrix([[-8, 1], [0, -8]]), 20)
    assert not linear_algebra.diagonalizable(A)
    assert linear_algebra.same_jordan_structure(A, sp.ImmutableMatrix(J))
    J[0, 1] = 0
    assert not linear_algebra.same_jordan_structure(A, sp.ImmutableMatrix(J))


@pytest.mark.parametrize("digits", [50, 100])
@pytest.mark.parametrize("A", [companion(*range(-8, 0)), sp.Matrix([[0, 1], [-1, 0]]), sp.zeros(1), sp.eye(3) * -40])
def test_exponentials_are_those_of_mpmath_to_all_digits(A, digits):
    arithmetic = multiple(digits)
    mp = arithmetic.context
    X = np.array([[mp.mpf(int(entry)) * mp.mpf("0.3") for entry in row] for row in A.tolist()], dtype=object)
    value, magnitude = arithmetic.exponential(X[None])
    with mp.workdps(digits + 80):
        expected = mp.expm(mp.matrix(X.tolist()), method="taylor")
        error = max(abs(value[0][i, j] - expected[i, j]) for i in range(len(X)) for j in range(len(X)))
    assert error <= arithmetic.eps * max(1.0, float(np.max(magnitude)))
    assert float(np.max(magnitude)) * arithmetic.eps < 10.0 ** (10 - digits)


def test_the_square_root_of_a_singular_matrix_is_judged_by_what_doubles_know():
    A = sp.ImmutableMatrix([[1, -1, 0], [2, -2, 2], [1, -1, 1]]) / 2  # eigenvalues 0, 1/2, −1/2
    T, D = A.diagonalize()
    root = T * D.applyfunc(sp.sqrt) * T.inv()
    X = sp.Symbol("A")
    assert time_response.matrix_function_residual(A, sp.sqrt(X), X, sp.ImmutableMatrix(root)) < 1e-9
    wrong = root + sp.Rational(1, 10**4) * sp.eye(3)
    assert time_response.matrix_function_residual(A, sp.sqrt(X), X, sp.ImmutableMatrix(wrong)) > 1e-9


def test_signs_of_eigenvalues_twenty_orders_of_magnitude_apart():
    """All solutions are definite or indefinite, as the number of unstable roots says; none is semidefinite."""
    A, C = companion(*range(-6, 0)), sp.Matrix([[1, 0, 0, 0, 0, 0]])
    equation = riccati(A.T, C.T, sp.eye(6), sp.eye(1))
    words = [definiteness_of_numbers(each.P) for each in equation.solutions]
    expected = {0: "positive definite", 6: "negative definite"}
    assert words == [expected.get(each.flips, "indefinite") for each in equation.solutions]
    weights = optimal.Weights(A.T, C.T, sp.ImmutableMatrix(sp.eye(6)), sp.ImmutableMatrix([[1]]))
    assert definiteness_holds(weights, words, [each.P for each in equation.solutions])
    assert optimal.number_of_solutions(weights) == len(words)
    wrong = ["indefinite", *words[1:]]
    assert not definiteness_holds(weights, wrong, [each.P for each in equation.solutions])
