"""The discrete Riccati equation: scipy's solution, all solutions, poles at zero, singular weights, parameters."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.linalg import solve_discrete_are

from solver import exact
from tests.helpers.tried import tried

M = sp.ImmutableMatrix
z = sp.Symbol("z")
small = st.integers(-3, 3)


def floats(matrix):
    return np.array(sp.Matrix(matrix).evalf(30).tolist(), dtype=float)


def equation(A, B, Q, R):
    return exact.discrete_riccati(*(M(each) for each in (A, B, Q, R)))


def residual(A, B, Q, R, P):
    gain = np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)
    return Q + A.T @ P @ A - A.T @ P @ B @ gain - P


def matrices(n, m, entries=small):
    rows = st.lists(st.lists(entries, min_size=m, max_size=m), min_size=n, max_size=n)
    return rows.map(M)


@tried(12)
@given(data=st.data(), n=st.integers(1, 3), m=st.integers(1, 2))
def test_the_stabilizing_solution_is_scipys_and_every_other_one_solves_the_equation(data, n, m):
    A, B, C = (data.draw(matrices(*shape)) for shape in ((n, n), (n, m), (1, n)))
    Q, R = C.T * C, sp.eye(m)
    try:
        found = exact.discrete_riccati(A, B, M(Q), M(R))
    except (exact.NotStabilizable, exact.OnTheAxis):
        return
    assume(min(abs(abs(complex(each)) - 1) for each in found.eigenvalues) > 1e-3)
    a, b, q, r = (floats(each) for each in (A, B, Q, R))
    P = floats(found.stabilizing.P)
    assert np.allclose(P, solve_discrete_are(a, b, q, r), rtol=1e-6, atol=1e-6)
    assert np.allclose(floats(found.gain(B, R)), np.linalg.solve(r + b.T @ P @ b, b.T @ P @ a), atol=1e-8)
    for each in found.solutions if found.listable else ():
        P = floats(each.P)
        assert np.allclose(residual(a, b, q, r, P), 0, atol=1e-7 * (1 + abs(P).max()))
        loop = a - b @ np.linalg.solve(r + b.T @ P @ b, b.T @ P @ a)
        stated = [float(c) for c in each.polynomial]
        assert np.allclose(stated, np.poly(loop), atol=1e-5 * (1 + max(map(abs, stated))))


def test_a_scalar_is_solved_by_the_quadratic_formula():
    a, b = sp.symbols("a b", real=True)
    q, r = sp.symbols("q r", positive=True)
    found = equation([[a]], [[b]], [[q]], [[r]])
    p = found.stabilizing.P[0, 0]
    assert sp.simplify(b**2 * p**2 + (r - a**2 * r - b**2 * q) * p - q * r) == 0
    root = sp.sqrt((a**2 * r - 2 * a * r + b**2 * q + r) * (a**2 * r + 2 * a * r + b**2 * q + r))
    assert sp.simplify(p - (root + a**2 * r + b**2 * q - r) / (2 * b**2)) == 0
    assert found.count == 2


def test_a_pole_at_zero_has_no_mirror_image():
    found = equation([[0, 1], [0, 2]], [[0], [1]], sp.eye(2), [[1]])
    assert found.count == 2
    assert found.symplectic is None
    assert not found.unreached
    assert all(0 in sp.roots(sp.Poly(each.polynomial, z)) for each in found.solutions)


@pytest.mark.parametrize(
    ("plant", "P", "K"),
    [
        (([[2]], [[1]], [[1]], [[0]]), [[1]], [[2]]),
        (([[1, 1], [0, 1]], [[0], [1]], [[1, 0], [0, 0]], [[0]]), None, None),
    ],
)
def test_a_weight_of_the_input_may_be_zero(plant, P, K):
    found = equation(*plant)
    if P is not None:
        assert M(P) == found.stabilizing.P
        assert found.gain(None, None) == M(K)
    a, b, q, r = (floats(each) for each in plant)
    assert np.allclose(residual(a, b, q, r, floats(found.stabilizing.P)), 0)


def test_weights_that_say_nothing_leave_the_control_open():
    with pytest.raises(exact.Undetermined):
        equation([[2]], [[1]], [[0]], [[0]])


@pytest.mark.parametrize(("a", "factor"), [(1, z - 1), (-1, z + 1)])
def test_modes_on_the_circle_that_the_weight_does_not_see(a, factor):
    with pytest.raises(exact.OnTheAxis) as finding:
        equation([[a]], [[1]], [[0]], [[1]])
    assert finding.value.factor.as_expr(z) == factor


def test_a_mode_outside_of_the_circle_that_the_input_does_not_reach():
    with pytest.raises(exact.NotStabilizable) as finding:
        equation([[-2, 0], [0, 1]], [[0], [1]], sp.eye(2), [[1]])
    assert finding.value.modes == [-2]
    assert equation([[-sp.Rational(1, 2), 0], [0, 1]], [[0], [1]], sp.eye(2), [[1]]).unreached


def test_real_poles_are_written_by_their_sums_with_their_inverses():
    found = equation([[1, 1], [0, 1]], [[0], [1]], [[16, 0], [0, 1]], [[1]])
    p = sp.Poly([sp.N(c, 40) for c in found.stabilizing.polynomial], z)
    for root in found.eigenvalues:
        assert abs(p.eval(sp.N(root, 40))) < 1e-30
        assert abs(sp.N(root)) < 1


@pytest.mark.parametrize(
    "plant",
    [
        ([[1, 1], [0, 1]], [[sp.Rational(1, 2)], [1]], [[1, 0], [0, 0]], [[1]]),
        ([[0, 1], [0, 2]], [[0], [1]], [[1, 0], [0, 1]], [[1]]),
        ([[1, 2], [3, 4]], [[1, 0], [1, 1]], [[2, 1], [1, 2]], [[2, 0], [0, 1]]),
        ([[2, 0], [0, 3]], [[1, 0], [0, 1]], [[1, 0], [0, 1]], [[1, 0], [0, 0]]),
    ],
)
def test_the_pencil(plant):
    found = equation(*plant)
    left, right = exact.symplectic_pencil(found)
    phi, factors = exact.pencil_polynomial(found, z)
    assert sp.expand((z * right - left).det() - phi) == 0
    assert sp.expand(factors - phi) == 0
    solution, n = found.stabilizing, found.order
    p = sp.Add(*(c * z ** (n - i) for i, c in enumerate(solution.polynomial)))
    mirrored = sp.Add(*(c * z**i for i, c in enumerate(solution.polynomial)))
    gap = exact.reciprocal_factor(found, solution) * p * mirrored - phi
    assert all(abs(sp.N(c, 40)) < 1e-25 for c in sp.Poly(gap, z).all_coeffs())
    E = exact.annihilator(found, solution)
    if E is not None:
        assert np.allclose(floats(E * sp.Matrix.vstack(sp.eye(n), solution.P)), 0)


def test_decimals_have_the_digits_of_a_long_iteration():
    A, B = M([[1, 2, 0], [-1, 1, 3], [2, 0, 1]]), M([[0], [1], [1]])
    found = exact.discrete_riccati(A, B, M(sp.eye(3)), M([[1]]))
    assert not found.stabilizing.exact
    with mpmath.workdps(40):
        a, b, P = mpmath.matrix(A.tolist()), mpmath.matrix(B.tolist()), mpmath.eye(3)
        for _ in range(200):
            K = mpmath.inverse(mpmath.eye(1) + b.T * P * b) * (b.T * P * a)
            P = mpmath.eye(3) + K.T * K + (a - b * K).T * P * (a - b * K)
        worst = max(abs(P[i, j] - mpmath.mpmathify(found.stabilizing.P[i, j])) for i in range(3) for j in range(3))
        assert worst < mpmath.mpf(10) ** -22


@pytest.mark.parametrize("B", [[[0], [1]], [[1, 0], [1, 2]]])
def test_the_entries_are_polynomials(B):
    A, B, Q, R = M([[1, 2], [3, 4]]), M(B), M([[2, 1], [1, 3]]), M(sp.eye(M(B).cols) * 2)
    P = M(2, 2, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{max(i, j) + 1}"))
    by, entries = exact.discrete_riccati_entries(A, B, Q, R, P)
    weight = exact.riccati_weight(B, R, P)
    stated = by * (Q + A.T * P * A - P) - A.T * P * B * weight.adjugate() * B.T * P * A
    assert (stated - entries).expand().is_zero_matrix
    assert sp.expand(weight.det() - by) == 0


def test_roots_stay_as_they_are_when_something_is_multiplied_out():
    a, b = sp.symbols("a b")
    root = sp.sqrt((a + 1) * (b + 1))
    assert exact.expanded_around_roots((a + root) ** 2) == a**2 + 2 * a * root + a * b + a + b + 1


def test_where_the_recursion_settles():
    two, one, zero = (M([[each]]) for each in (2, 1, 0))
    assert exact.limit_of_the_recursion(two, one, zero, one, zero) == (zero, M([[3]]))
    assert exact.limit_of_the_recursion(two, one, zero, one, one) == (M([[3]]), None)
    assert exact.limit_of_the_recursion(one, one, zero, one, one) is None
