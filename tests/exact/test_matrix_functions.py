"""e^{At} and Aᵏ: by their defining equations exactly, against mpmath and numpy, and in the form a page shows."""

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from scipy.linalg import expm

from solver import exact
from solver.exact.functions.matrix_functions import conditions_for
from solver.exact.functions.scalar_functions import ScalarFunction
from tests.helpers.exact_cases import (
    COMPLEX,
    DECIMAL,
    EXACT,
    NUMERIC,
    RATIONAL,
    SURD,
    companion,
    each,
    exponential_of,
    floats,
    is_zero,
    k,
    t,
    theta,
    x,
)
from tests.helpers.strategies import systems
from tests.helpers.tried import tried

e, cos, sin, sqrt = sp.exp, sp.cos, sp.sin, sp.sqrt
c, m, stiffness = sp.symbols("c m stiffness", positive=True)
p, q = sp.symbols("p q", real=True)

PARAMETERS = {
    "mass and spring": sp.ImmutableMatrix([[0, 1], [-stiffness / m, 0]]),
    "saddle": sp.ImmutableMatrix([[0, c], [m, 0]]),
    "undecided": sp.ImmutableMatrix([[0, 1], [-stiffness / m, -c / m]]),
    "triangular": sp.ImmutableMatrix([[p, 1], [0, q]]),
    "a double root": sp.ImmutableMatrix([[p, q], [0, p]]),
    "rotation": sp.ImmutableMatrix([[cos(theta), sin(theta)], [-sin(theta), cos(theta)]]),
    "four by four": sp.ImmutableMatrix([[0, 1, 0, 0], [0, 0, p, 0], [0, 0, 0, 1], [0, 0, c, 0]]),
}
VALUES = {"c": "3/2", "m": "2", "stiffness": "5/3", "p": "-1/3", "q": "3/4", "theta": "7/10"}
POINT = {symbol: sp.Rational(VALUES[symbol.name]) for symbol in (c, m, stiffness, p, q, theta)}

SADDLE = sqrt(2) * (e(2 * t) - e(-t)) / 3
SLOW, FAST = e(-t), e(-2 * t)
COSINE, SINE = e(-t) * cos(2 * t), e(-t) * sin(2 * t) / 2
CLOSED_FORMS = [
    (companion((x + 1) * (x + 2)), [[2 * SLOW - FAST, SLOW - FAST], [2 * FAST - 2 * SLOW, 2 * FAST - SLOW]]),
    (sp.ImmutableMatrix([[0, 1], [-1, 0]]), [[cos(t), sin(t)], [-sin(t), cos(t)]]),
    (sp.ImmutableMatrix([[0, 1], [0, 0]]), [[1, t], [0, 1]]),
    (companion(x**2 + 2 * x + 5), [[COSINE + SINE, SINE], [-5 * SINE, COSINE - SINE]]),
    (sp.ImmutableMatrix([[-1, 1], [0, -1]]), [[e(-t), t * e(-t)], [0, e(-t)]]),
    (
        sp.ImmutableMatrix([[0, sqrt(2)], [sqrt(2), 1]]),
        [[e(2 * t) / 3 + 2 * e(-t) / 3, SADDLE], [SADDLE, 2 * e(2 * t) / 3 + e(-t) / 3]],
    ),
]


def phi(A):
    return sp.Matrix(exact.exponential(sp.ImmutableMatrix(A), t).matrix)


@pytest.mark.parametrize(("A", "expected"), CLOSED_FORMS)
def test_textbook_closed_forms(A, expected):
    assert (phi(A) - sp.Matrix(expected)).expand() == sp.zeros(*A.shape)


@pytest.mark.parametrize("A", **each(EXACT))
def test_the_exponential_solves_its_differential_equation_exactly(A):
    Phi = phi(A)
    assert Phi.subs(t, 0).applyfunc(lambda entry: sp.radsimp(sp.expand(entry))) == sp.eye(A.rows)
    assert is_zero(Phi.diff(t) - A * Phi)


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_the_exponential_is_that_of_mpmath(A):
    for time in (0.0, 0.3, 1.7):
        expected = exponential_of(A, time)
        found = floats(phi(A), t=sp.Rational(str(time)))
        assert np.abs(found - expected).max() <= 1e-11 * max(1, np.abs(expected).max())


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_real_matrices_have_real_closed_forms(A):
    assert not phi(A).has(sp.I)
    assert not sp.Matrix(exact.power(A, k).matrix).has(sp.I)


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_entries_are_sums_of_distinct_modes(A):
    for entry in phi(A):
        modes = [
            sp.Mul(*(f for f in term.args if f.has(t))) if term.is_Mul else term for term in sp.Add.make_args(entry)
        ]
        numbers = [mode for mode in modes if not mode.has(t)]
        with_time = [mode for mode in modes if mode.has(t)]
        assert len(with_time) == len(set(with_time)) or A in SURD.values()
        assert len(numbers) <= 2  # a + b√d


@pytest.mark.parametrize("A", **each(EXACT))
def test_entries_are_in_the_form_that_sympy_keeps(A):
    for entry in phi(A):
        assert entry.func(*entry.args) == entry if entry.args else True


@pytest.mark.parametrize("A", **each(RATIONAL))
def test_real_rational_spectra_give_exponentials_and_powers_of_time_only(A):
    assert not phi(A).has(sin, cos, sp.sinh, sp.cosh, sp.Float)


@pytest.mark.parametrize("A", **each(DECIMAL))
def test_decimals_occur_only_where_a_factor_of_degree_three_forces_them(A):
    assert phi(A).has(sp.Float)
    assert all(number._prec >= 99 for number in phi(A).atoms(sp.Float))


@pytest.mark.parametrize("A", **each(PARAMETERS))
def test_parametric_exponentials_have_the_right_values(A):
    found = floats(phi(A).subs(POINT), t="4/5")
    expected = exponential_of(A.subs(POINT), 0.8)
    assert np.abs(found - expected).max() < 1e-12


@pytest.mark.parametrize("A", **each(PARAMETERS))
def test_parametric_exponentials_solve_the_differential_equation(A):
    Phi = phi(A)
    residual = (Phi.diff(t) - A * Phi).subs({**POINT, t: sp.Rational(4, 5)}).evalf(40)
    assert max(abs(entry) for entry in residual) < 1e-30
    start = (Phi.subs(t, 0) - sp.eye(A.rows)).subs(POINT).evalf(40)
    assert max(abs(entry) for entry in start) < 1e-30


def test_an_undecided_pair_is_right_on_both_sides():
    A = PARAMETERS["undecided"]
    for value in ("1/10", "9"):  # underdamped, overdamped
        point = {**POINT, c: sp.Rational(value)}
        assert np.abs(floats(phi(A).subs(point), t="1/2") - exponential_of(A.subs(point), 0.5)).max() < 1e-12


@pytest.mark.parametrize("A", **each(RATIONAL))
def test_powers_are_matrix_powers_exactly(A):
    closed = sp.Matrix(exact.power(A, k).matrix)
    for exponent in range(7):
        assert (closed.subs(k, exponent) - A**exponent).expand() == sp.zeros(A.rows)


@pytest.mark.parametrize("A", **each(COMPLEX | SURD | DECIMAL))
def test_powers_are_matrix_powers(A):
    closed = exact.power(A, k).matrix
    for exponent in range(9):
        expected = floats(A**exponent)
        assert np.abs(floats(closed, k=exponent) - expected).max() <= 1e-12 * max(1, np.abs(expected).max())


@pytest.mark.parametrize(
    ("pair", "angle"),
    [
        (x**2 + 1, sp.pi / 2),
        (x**2 - 2 * x + 2, sp.pi / 4),
        (x**2 + 2 * x + 2, 3 * sp.pi / 4),
        (x**2 + x + 1, 2 * sp.pi / 3),
        (x**2 - x + 1, sp.pi / 3),
        (x**2 - sqrt(3) * x + 1, sp.pi / 6),
    ],
)
def test_nice_angles_are_multiples_of_pi(pair, angle):
    A = sp.ImmutableMatrix([[0, 1], [-sp.Poly(pair, x).nth(0), -sp.Poly(pair, x).nth(1)]])
    assert sp.Matrix(exact.power(A, k).matrix).has(cos(angle * k))


def test_a_nilpotent_matrix_has_powers_made_of_pulses():
    found = exact.power(sp.ImmutableMatrix([[0, 1], [0, 0]]), k).matrix
    assert found == sp.Matrix([[sp.KroneckerDelta(k, 0), sp.KroneckerDelta(k, 1)], [0, sp.KroneckerDelta(k, 0)]])


def test_an_undecided_pair_has_no_closed_form_of_powers_or_a_right_one():
    A = PARAMETERS["undecided"]
    try:
        closed = exact.power(A, k).matrix
    except exact.NotExact:
        return
    assert np.abs(floats(closed.subs(POINT), k=3) - floats((A**3).subs(POINT))).max() < 1e-12


@pytest.mark.parametrize(
    "A", **each({name: A for name, A in PARAMETERS.items() if name not in ("undecided", "rotation")})
)
def test_parametric_powers_have_the_right_values(A):
    closed = exact.power(A, k).matrix.subs(POINT)
    for exponent in range(5):
        expected = floats((A**exponent).subs(POINT))
        assert np.abs(floats(closed, k=exponent) - expected).max() < 1e-12


EITHER_SIGN = [
    sp.ImmutableMatrix([[q, p], [-p, q]]),
    PARAMETERS["rotation"],
    sp.ImmutableMatrix([[0, p], [-p, 0]]),
    sp.ImmutableMatrix([[0, 1], [-(p**2), 0]]),
]


@pytest.mark.parametrize(
    ("A", "value"),
    [
        *((A, "7/10") for A in EITHER_SIGN),
        *((A, "-7/10") for A in EITHER_SIGN[:2]),
        *(pytest.param(A, "-7/10") for A in EITHER_SIGN[2:]),
    ],
)
def test_powers_are_right_for_either_sign_of_the_frequency(A, value):
    point = {p: sp.Rational(value), q: sp.Rational(1, 2), theta: sp.Rational(value)}
    closed = exact.power(A, k).matrix.subs(point)
    for exponent in range(5):
        assert np.abs(floats(closed, k=exponent) - floats((A**exponent).subs(point))).max() < 1e-12


@pytest.mark.parametrize("A", **each(EXACT))
def test_the_truncated_series_is_the_beginning_of_the_series(A):
    expected = sp.eye(A.rows) + A * t + A * A * t**2 / 2 + A**3 * t**3 / 6
    assert (exact.truncated_series(A, t, 4) - expected).expand() == sp.zeros(A.rows)
    assert exact.truncated_series(A, t, 1) == sp.eye(A.rows)


@pytest.mark.parametrize("A", **each(EXACT))
def test_listed_powers_are_the_powers(A):
    assert [(found - A**i).expand() for i, found in enumerate(exact.powers(A, 4))] == [sp.zeros(A.rows)] * 4


@pytest.mark.parametrize("function", [e(-2 * t), t * e(-t), e(-t) * cos(2 * t), sp.Integer(1), t**2])
def test_expansions_are_those_of_sympy(function):
    assert sp.expand(sp.Add(*exact.taylor(function, t, 5)) - sp.series(function, t, 0, 5).removeO()) == 0


@tried(25)
@given(systems(6))
def test_random_systems_agree_with_scipy(A):
    Phi = phi(A)
    assert is_zero(Phi.diff(t) - A * Phi)
    assert Phi.subs(t, 0).expand() == sp.eye(A.rows)
    expected = expm(floats(A).real * 0.5)
    assert np.abs(floats(Phi, t="1/2") - expected).max() <= 1e-8 * max(1, np.abs(expected).max())


@tried(20)
@given(systems(6))
def test_powers_of_random_systems_agree_with_numpy(A):
    closed = exact.power(A, k).matrix
    for exponent in (0, 1, 2, 3, 7):
        expected = np.linalg.matrix_power(floats(A).real, exponent)
        assert np.abs(floats(closed, k=exponent) - expected).max() <= 1e-9 * max(1, np.abs(expected).max())


@pytest.mark.parametrize("A", **each(NUMERIC))
def test_the_conditions_on_the_coefficients_are_as_many_as_states_and_give_the_function(A):
    """f(A) = Σ αⱼ Aʲ, where the α meet all the conditions; those of a conjugate pair are two real ones."""
    variable = sp.Symbol("A")
    conditions = list(conditions_for(A, ScalarFunction(sp.exp(variable / 2), variable)))
    assert len(conditions) == A.rows
    rows = np.array([[complex(entry) for entry in each.row] for each in conditions])
    alphas = np.linalg.solve(rows, np.array([complex(each.right) for each in conditions]))
    F = floats(A)
    powers = sum(alpha * np.linalg.matrix_power(F, j) for j, alpha in enumerate(alphas))
    assert np.allclose(powers, expm(F / 2), rtol=1e-6, atol=1e-7)
