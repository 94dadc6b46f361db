"""Lyapunov equations: scipy's solutions, the equation itself, singular ones."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from scipy.linalg import solve_continuous_lyapunov, solve_discrete_lyapunov

from solver.exact import SingularEquation, lyapunov, lyapunov_equations, lyapunov_residual
from tests.helpers.strategies import systems
from tests.helpers.tried import tried


def test_the_course_example():
    A = sp.Matrix([[3, -2], [1, -1]])
    dual = lyapunov(A, sp.eye(2), dual=True)
    assert dual == sp.Matrix([[1, sp.Rational(7, 4)], [sp.Rational(7, 4), sp.Rational(9, 4)]])
    assert dual.det() == lyapunov(A, sp.eye(2)).det() == sp.Rational(-13, 16)


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("dual", [False, True])
def test_scipy_finds_the_same(discrete, dual):
    A = sp.Matrix([[-1, 2, 0], [0, -3, 1], [1, 0, -4]]) / 5
    Q = sp.Matrix([[2, 1, 0], [1, 3, 0], [0, 0, 1]])
    P = np.array(lyapunov(A, Q, dual=dual, discrete=discrete), dtype=float)
    F, R = (np.array(M, dtype=float) for M in (A if dual else A.T, Q))
    theirs = solve_discrete_lyapunov(F, R) if discrete else solve_continuous_lyapunov(F, -R)
    assert np.allclose(P, theirs)


@tried(25)
@given(systems(4))
def test_the_equation_holds_or_is_singular(A):
    sums = {sp.expand(a + b) for a in A.eigenvals() for b in A.eigenvals()}
    if 0 in sums:
        with pytest.raises(SingularEquation):
            lyapunov(A, sp.eye(A.rows))
    else:
        P = lyapunov(A, sp.eye(A.rows))
        assert P == P.T
        assert lyapunov_residual(A, P, sp.eye(A.rows)).is_zero_matrix


@pytest.mark.parametrize(("rows", "solvable"), [([[0, 1], [-1, 0]], False), ([[1, 0], [0, -1]], True)])
def test_a_singular_equation_is_named(rows, solvable):
    with pytest.raises(SingularEquation) as singular:
        lyapunov(sp.Matrix(rows), sp.eye(2))
    assert singular.value.solvable is solvable


def test_a_discrete_equation_is_singular_where_eigenvalues_multiply_to_one():
    with pytest.raises(SingularEquation):
        lyapunov(sp.diag(2, sp.Rational(1, 2)), sp.eye(2), discrete=True)


def test_parameters_surds_and_angles():
    a, b = sp.symbols("a b", positive=True)
    P = lyapunov(sp.Matrix([[0, 1], [-a, -b]]), sp.eye(2))
    assert sp.cancel(P[0, 1] - 1 / (2 * a)) == 0
    A = sp.Matrix([[-sp.sqrt(2), 1], [0, -1]])
    assert lyapunov_residual(A, lyapunov(A, sp.eye(2)), sp.eye(2)).applyfunc(sp.radsimp).is_zero_matrix


def test_a_right_side_that_is_not_symmetric_is_refused():
    with pytest.raises(ValueError, match="symmetric"):
        lyapunov(sp.eye(2), sp.Matrix([[1, 1], [0, 1]]))


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("dual", [False, True])
def test_the_equations_written_out_have_the_solution(dual, discrete):
    A = sp.Matrix([[3, -2], [1, -1]])
    unknowns = lyapunov_equations(A, sp.eye(2), dual=dual, discrete=discrete)
    P = lyapunov(A, sp.eye(2), dual=dual, discrete=discrete)
    values = {unknowns.P[i, j]: P[i, j] for i in range(2) for j in range(2)}
    assert [str(symbol) for symbol in unknowns.symbols] == ["p11", "p12", "p22"]
    assert all(sp.expand(equation.subs(values)) == 0 for equation in unknowns.equations)
