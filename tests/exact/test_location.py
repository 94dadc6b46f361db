"""Where eigenvalues lie against numpy, on the boundary by construction, with parameters by hand."""

import numpy as np
import pytest
import sympy as sp

from solver import exact
from tests.helpers.exact_cases import companion, x

half = sp.Rational(1, 2)
p, q = sp.symbols("p q", positive=True)
minus = sp.Symbol("m", negative=True)
a = sp.Symbol("a", real=True)

POLYNOMIALS = [
    (x + 1) * (x + half) * (x - 3),
    (x**2 + x + 1) * (x + 2),
    (x**2 - x + 2) * (x**2 + 3),
    (x**2 + 4) * (x + 1),
    x * (x + 2),
    (x**2 - 2) * (x + 1),
    (x**2 + 3 * x + 1) * (x - half),
    x**3 + x + 1,
    x**3 + 3 * x**2 + 4 * x + 3,
    x**4 + 3 * x**2 + 1,
    x**4 - x**2 - 1,
    x**4 + x**3 + x**2 + x + 1,
    (x**2 - x + 1) * (x - half),
    (x**2 - half) * (x + 1),
    (x**2 + half) * (x + sp.Rational(1, 3)),
    x**2 - x + sp.Rational(2, 9),
    (x**2 - 3 * x + 1) * (x - 1),
    x**3 - x / 2 + sp.Rational(1, 5),
]


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("polynomial", POLYNOMIALS, ids=str)
def test_every_eigenvalue_is_on_the_side_where_numpy_finds_it(polynomial, discrete):
    placed = exact.location(companion(polynomial), discrete=discrete).placed
    for each in placed:
        value = complex(each.root.value)
        excess = abs(value) - 1 if discrete else value.real
        assert each.position == (0 if abs(excess) < 1e-12 else np.sign(excess))
        assert float(each.measure) == pytest.approx(abs(value) if discrete else value.real, abs=1e-12)


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("polynomial", POLYNOMIALS, ids=str)
def test_a_polynomial_is_stable_where_all_its_roots_are_inside(polynomial, discrete):
    coefficients = sp.Poly(sp.expand(3 * polynomial), x).all_coeffs()
    roots = np.roots([float(c) for c in coefficients])
    inside = bool(np.all(np.abs(roots) < 1 - 1e-9 if discrete else roots.real < -1e-9))
    assert exact.is_stable_polynomial(coefficients, discrete=discrete) is inside
    assert exact.is_stable_polynomial([-c for c in coefficients], discrete=discrete) is inside
    monic = [c / coefficients[0] for c in coefficients]
    conditions = exact.polynomial_conditions(monic, discrete=discrete)
    assert all(bool(c > 0) for c in conditions) is inside
    assert exact.stable_where(companion(polynomial), discrete=discrete) == inside


@pytest.mark.parametrize(
    ("A", "discrete", "verdict"),
    [
        (sp.diag(-1, -2), False, "asymptotically stable"),
        (sp.diag(-1, 0), False, "marginally stable"),
        (sp.diag(0, 0), False, "marginally stable"),
        (sp.Matrix([[0, 1], [0, 0]]), False, "unstable"),
        (sp.diag(0, 1), False, "unstable"),
        (sp.diag(half, -half), True, "asymptotically stable"),
        (sp.diag(1, -1), True, "marginally stable"),
        (sp.Matrix([[1, 1], [0, 1]]), True, "unstable"),
        (sp.diag(a, -1), False, None),
        (sp.diag(a, 1), False, "unstable"),
    ],
)
def test_the_verdict_counts_the_eigenvectors_on_the_boundary(A, discrete, verdict):
    assert exact.location(sp.ImmutableMatrix(A), discrete=discrete).verdict == verdict


@pytest.mark.parametrize(
    ("b", "c", "discrete", "positions"),
    [
        (p, q, False, [-1, -1]),
        (-p, q, False, [1, 1]),
        (a, q, False, [None, None]),
        (p, minus, False, [-1, 1]),
        (a, minus, False, [-1, 1]),
        (-p, a, False, [1, None]),
        (p, a, False, [None, None]),
        (sp.Integer(0), q, False, [0, 0]),
        (sp.Integer(0), 1 / (1 + p), True, [-1, -1]),
        (sp.Integer(0), 1 + p, True, [1, 1]),
        (p + 3, half, True, [1, None]),
        (a, half, True, [None, None]),
    ],
)
def test_a_quadratic_with_parameters(b, c, discrete, positions):
    found = [each.position for each in exact.location(companion(x**2 + b * x + c), discrete=discrete).placed]
    assert found == positions


def test_the_condition_that_can_never_hold():
    """(z + 1) has a bilinear image of lower degree, and a row of the array that is special cannot be positive."""
    assert exact.polynomial_conditions([sp.Integer(1), sp.Integer(1)], discrete=True) == [-1]
    assert exact.polynomial_conditions([sp.Integer(1), sp.Integer(0), sp.Integer(1)], discrete=False) == [-1]


def test_roots_at_one_are_divided_out():
    listed = sp.Poly((x - 1) ** 2 * (2 * x + 3) * (x - 5), x).all_coeffs()
    assert exact.off_the_point_one(listed) == ((2, -7, -15), 2)
    assert exact.off_the_point_one([sp.Integer(1), sp.Integer(2)]) == ((1, 2), 0)
    assert exact.off_the_point_one([sp.Integer(1), sp.Integer(-1)]) == ((1,), 1)
