"""Φ(t) and Φ(k) judged by values: right ones of every kind pass, every corruption is rejected."""

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.evaluation.multiple_precision import determinant, exponential, inverse
from solver.numeric.judges.time_response import exponential_residual, power_residual
from tests.helpers.comparing import is_error

t, k = sp.symbols("t k")
c = sp.Symbol("c", real=True)
e, sin, cos = sp.exp, sp.sin, sp.cos

PAIRS = {
    "two real modes": (
        sp.Matrix([[0, 1], [-2, -3]]),
        sp.Matrix([[2 * e(-t) - e(-2 * t), e(-t) - e(-2 * t)], [2 * e(-2 * t) - 2 * e(-t), 2 * e(-2 * t) - e(-t)]]),
    ),
    "oscillator": (sp.Matrix([[0, 2], [-2, 0]]), sp.Matrix([[cos(2 * t), sin(2 * t)], [-sin(2 * t), cos(2 * t)]])),
    "defective": (
        sp.Matrix([[-1, 1, 0], [0, -1, 1], [0, 0, -1]]),
        e(-t) * sp.Matrix([[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]]),
    ),
    "nilpotent": (sp.Matrix([[0, 1, 0], [0, 0, 1], [0, 0, 0]]), sp.Matrix([[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]])),
    "parameter": (sp.Matrix([[c, 1], [0, 0]]), sp.Matrix([[e(c * t), (e(c * t) - 1) / c], [0, 1]])),
    "zero": (sp.zeros(2), sp.eye(2)),
    "scalar": (sp.Matrix([[-3]]), sp.Matrix([[e(-3 * t)]])),
    "stiff": (
        sp.Matrix([[-1, 1], [0, -100000]]),
        sp.Matrix([[e(-t), (e(-t) - e(-100000 * t)) / 99999], [0, e(-100000 * t)]]),
    ),
    "badly scaled": (
        sp.Matrix([[-1, 10**6], [0, -2]]),
        sp.Matrix([[e(-t), 10**6 * (e(-t) - e(-2 * t))], [0, e(-2 * t)]]),
    ),
    "small beside large": (
        sp.Matrix([[-1, 10**6], [sp.Rational(-1, 10**6), -1]]),
        e(-t) * sp.Matrix([[cos(t), 10**6 * sin(t)], [-sin(t) / 10**6, cos(t)]]),
    ),
    "complex": (sp.Matrix([[sp.I, 1], [0, -sp.I]]), sp.Matrix([[e(sp.I * t), sin(t)], [0, e(-sp.I * t)]])),
}


def corruptions(right, variable):
    """Every entry changed in sign, by one, by a thousandth; transposed; columns swapped; wrong time; no factor t."""
    entries = [(i, j) for i in range(right.rows) for j in range(right.cols)]
    for i, j in entries:
        for entry in (-right[i, j], right[i, j] + 1, right[i, j] * sp.Rational(1001, 1000), right[i, j] + variable):
            other = right.as_mutable()
            other[i, j] = entry
            yield other
    yield right.T
    if right.cols > 1:
        swapped = right.as_mutable()
        swapped.col_swap(0, 1)
        yield swapped
    yield right.subs(variable, 2 * variable)
    yield right.subs(variable, -variable)
    yield right * 1.001
    yield right.row_insert(0, right[0, :])
    yield right + sp.ones(*right.shape) / 10**8


@pytest.mark.parametrize("name", PAIRS)
def test_the_exponential_passes(name):
    A, Phi = PAIRS[name]
    assert exponential_residual(A, Phi, t) <= 1e-9


@pytest.mark.parametrize("name", PAIRS)
def test_every_corruption_of_the_exponential_is_rejected(name):
    A, Phi = PAIRS[name]
    for wrong in corruptions(Phi, t):
        if wrong.shape == Phi.shape and (wrong - Phi).applyfunc(sp.expand) == sp.zeros(*Phi.shape):
            continue  # the change was none: −0 for 0, Φᵀ of a symmetric Φ
        assert exponential_residual(A, wrong, t) > 1e-9, wrong


def test_a_forgotten_factor_t_and_a_division_by_t_are_rejected():
    A, Phi = PAIRS["defective"]
    assert exponential_residual(A, Phi.subs(Phi[0, 1], e(-t)), t) > 1e-9
    assert exponential_residual(A, sp.Matrix(3, 3, [sp.Mul(x, t, 1 / t, evaluate=False) for x in Phi]), t) == float(
        "inf"
    )


def test_a_wrong_slow_mode_beside_a_fast_one_is_seen():
    A, Phi = PAIRS["stiff"]
    assert exponential_residual(A, Phi.subs(e(-t), e(-t * sp.Rational(1001, 1000))), t) > 1e-9


POWERS = {
    "two modes": (
        sp.Matrix([[0, 1], [-2, -3]]),
        sp.Matrix(
            [
                [2 * (-1) ** k - (-2) ** k, (-1) ** k - (-2) ** k],
                [2 * (-2) ** k - 2 * (-1) ** k, 2 * (-2) ** k - (-1) ** k],
            ]
        ),
    ),
    "deadbeat": (
        sp.Matrix([[0, 1, 0], [0, 0, 1], [0, 0, 0]]),
        sp.Matrix(3, 3, lambda i, j: sp.KroneckerDelta(k, j - i) if j >= i else 0),
    ),
    "defective": (sp.Matrix([[2, 1], [0, 2]]), sp.Matrix([[2**k, k * 2 ** (k - 1)], [0, 2**k]])),
    "piecewise": (
        sp.Matrix([[0, 0], [1, 1]]),
        sp.Matrix([[sp.KroneckerDelta(k, 0), 0], [sp.Piecewise((0, sp.Eq(k, 0)), (1, True)), 1]]),
    ),
    "rotation": (
        sp.Matrix([[0, 1], [-1, 0]]),
        sp.Matrix([[cos(sp.pi * k / 2), sin(sp.pi * k / 2)], [-sin(sp.pi * k / 2), cos(sp.pi * k / 2)]]),
    ),
}


@pytest.mark.parametrize("name", POWERS)
def test_the_powers_pass_and_every_corruption_is_rejected(name):
    A, Phi = POWERS[name]
    assert power_residual(A, Phi, k) <= 1e-9
    for wrong in corruptions(Phi, k):
        if wrong.shape == Phi.shape and _same_powers(wrong, Phi):
            continue
        assert power_residual(A, wrong, k) > 1e-9, wrong


def _same_powers(wrong, right):
    return all((wrong - right).subs(k, step).applyfunc(sp.nsimplify).is_zero_matrix for step in range(9))


def test_a_delta_forgotten_at_zero_is_seen():
    A, Phi = POWERS["piecewise"]
    assert power_residual(A, sp.Matrix([[0, 0], [1, 1]]), k) > 1e-9
    assert power_residual(A, Phi.subs(sp.KroneckerDelta(k, 0), 0), k) > 1e-9


def companion_of_order_ten():
    x = sp.Symbol("x")
    low = sp.Poly(sp.prod([x + i for i in range(1, 11)]), x).all_coeffs()[:0:-1]
    A = sp.Matrix(10, 10, lambda i, j: int(j == i + 1) if i < 9 else -low[j])
    V = sp.Matrix(10, 10, lambda i, j: sp.Integer(-(j + 1)) ** i)
    W = V.inv()
    return A, sp.Matrix(10, 10, lambda i, j: sum(V[i, m] * W[m, j] * e(-(m + 1) * t) for m in range(10)))


def test_order_ten_with_entries_over_many_decades():
    A, Phi = companion_of_order_ten()
    assert exponential_residual(A, Phi, t) <= 1e-9
    for i, j in ((0, 9), (9, 0), (4, 4)):
        wrong = Phi.copy()
        wrong[i, j] *= 1 + sp.Rational(1, 10**6)
        assert is_error(exponential_residual(A, wrong, t))


MATRICES = [
    [[0, 1], [-2, -3]],
    [[-50, 49], [0, -1]],
    [[0, 0], [0, 0]],
    [[1j, 2], [0.5, -1j]],
    [[1e-12, 1e6], [-1e-7, 3]],
    [[-40]],
]


@pytest.mark.parametrize("rows", MATRICES)
def test_the_exponential_in_whole_numbers_agrees_with_mpmath_and_scipy(rows):
    many = multiple(50)
    M = many.array(rows)
    value, error_of_value = exponential(M, many.context)
    error = error_of_value()
    with mpmath.workdps(60):
        reference = mpmath.expm(mpmath.matrix(rows), method="taylor")
    for i, j in np.ndindex(*M.shape):
        assert abs(value[i, j] - reference[i, j]) <= error[i, j] * 10 + 1e-40 * abs(reference[i, j])
    assert np.allclose(value.astype(complex), expm(np.array(rows, dtype=complex)), rtol=1e-9, atol=1e-12)


def test_elimination_with_many_digits_agrees_with_numpy():
    rng = np.random.default_rng(5)
    many = multiple(50)
    for n in (1, 2, 5):
        M = rng.normal(size=(n, n)) + 1j * rng.normal(size=(n, n))
        exact = many.array(M)
        assert complex(determinant(exact)) == pytest.approx(np.linalg.det(M))
        assert np.allclose(inverse(exact).astype(complex), np.linalg.inv(M))
        assert np.max(many.size(exact @ inverse(exact) - many.array(np.eye(n)))) < 1e-45


def test_a_nilpotent_matrix_with_eigenvalues_that_look_nonzero_in_doubles():
    A = sp.Matrix([[0, 1, 1], [-1, -1, 0], [0, 1, 1]])
    Phi = sp.eye(3) + A * t + A**2 * t**2 / 2
    assert exponential_residual(A, Phi, t) <= 1e-9
    assert exponential_residual(A, Phi + A**2 * t**2 / 1000, t) > 1e-9
