"""The Cayley–Hamilton coefficients: their conditions hold, and Σ αᵢ Aⁱ is the matrix function exactly."""

import pytest
import sympy as sp
from hypothesis import given

from solver import exact
from tests.helpers.exact_cases import COMPLEX, DECIMAL, EXACT, NUMERIC, RATIONAL, each, is_zero, k, t
from tests.helpers.strategies import systems
from tests.helpers.tried import tried


def combination(A, alpha):
    return sum((value * A**i for i, value in enumerate(alpha)), sp.zeros(A.rows))


@pytest.mark.parametrize("A", **each(EXACT))
def test_the_polynomial_in_the_matrix_is_the_exponential_exactly(A):
    alpha = exact.interpolation_coefficients(A, t, discrete=False)
    assert len(alpha) == A.rows
    assert is_zero(combination(A, alpha) - exact.exponential(A, t).matrix)


@pytest.mark.parametrize("A", **each(RATIONAL))
def test_the_polynomial_in_the_matrix_is_the_power_exactly(A):
    alpha = exact.interpolation_coefficients(A, k, discrete=True)
    assert is_zero(combination(A, alpha) - exact.power(A, k).matrix)


@pytest.mark.parametrize("A", **each(NUMERIC))
@pytest.mark.parametrize("discrete", [False, True])
def test_there_are_as_many_independent_conditions_as_unknowns(A, discrete):
    conditions = exact.interpolation(exact.spectrum(A), k if discrete else t, discrete=discrete)
    assert len(conditions) == A.rows
    rows = sp.Matrix([condition.row for condition in conditions])
    assert abs(sp.N(rows.det(method="berkowitz"), 20)) > 1e-12


@pytest.mark.parametrize("A", **each(EXACT))
@pytest.mark.parametrize("discrete", [False, True])
def test_the_coefficients_satisfy_the_conditions(A, discrete):
    time = k if discrete else t
    alpha = exact.interpolation_coefficients(A, time, discrete=discrete)
    for condition in exact.interpolation(exact.spectrum(A), time, discrete=discrete):
        residual = sum(c * value for c, value in zip(condition.row, alpha, strict=True)) - condition.right
        assert abs(sp.N(residual.subs(time, 3), 30)) < 1e-20


@pytest.mark.parametrize("A", **each(COMPLEX | DECIMAL))
def test_conditions_of_pairs_are_real(A):
    for condition in exact.interpolation(exact.spectrum(A), t, discrete=False):
        assert not condition.right.has(sp.I)
        assert not any(sp.sympify(c).has(sp.I) for c in condition.row)


def test_a_double_root_gives_the_derivative():
    A = sp.ImmutableMatrix([[-1, 1], [0, -1]])
    first, second = exact.interpolation(exact.spectrum(A), t, discrete=False)
    assert (first.row, first.right) == ((1, -1), sp.exp(-t))
    assert (second.row, second.right) == ((0, 1), t * sp.exp(-t))


def test_a_root_zero_in_discrete_time_gives_pulses():
    A = sp.ImmutableMatrix([[0, 1], [0, 0]])
    rights = [condition.right for condition in exact.interpolation(exact.spectrum(A), k, discrete=True)]
    assert rights == [sp.KroneckerDelta(k, 0), sp.KroneckerDelta(k, 1)]


@tried(30)
@given(systems(6))
def test_random_systems(A):
    alpha = exact.interpolation_coefficients(A, t, discrete=False)
    assert is_zero(combination(A, alpha) - exact.exponential(A, t).matrix)
