"""Signs for all values of parameters, intervals of one, conjunctions for several."""

import mpmath
import pytest
import sympy as sp

from solver.exact import all_positive, definiteness, sign_of

k, a, b = sp.symbols("k a b", real=True)
p, q = sp.symbols("p q", positive=True)
half = sp.Rational(1, 2)


@pytest.mark.parametrize(
    ("expression", "sign"),
    [
        (sp.sqrt(2) - sp.Rational(3, 2), -1),
        (sp.sqrt(2) * sp.sqrt(3) - sp.sqrt(6), 0),
        (k**2 - 2 * k + 2, 1),
        (3 - 2 * sp.sin(k), 1),
        (1 - sp.sin(k), None),
        (p * q + 1, 1),
        (-p / q, -1),
        (a, None),
        (a**2, None),
        (a**2 + 1, 1),
        (p - q, None),
    ],
)
def test_signs(expression, sign):
    assert sign_of(sp.sympify(expression)) == sign


@pytest.mark.parametrize(
    ("conditions", "expected"),
    [
        ([1 - k / 2, k], (k > 0) & (k < 2)),
        ([6 - p], p < 6),
        ([p + 1], sp.true),
        ([-p], sp.false),
        ([k, -k], sp.false),
        ([k**2 - 2], (k < -sp.sqrt(2)) | (k > sp.sqrt(2))),
        ([(k - 1) ** 2], sp.Ne(k, 1)),
        ([k / (k - 2)], (k < 0) | (k > 2)),
        ([1 - 2 * sp.sin(k)], sp.sin(k) < half),
        ([1 - sp.sin(k)], sp.sin(k) < 1),
        ([3 - sp.sin(k)], sp.true),
        ([k - sp.pi, 4 - k], (k > sp.pi) & (k < 4)),
        ([sp.Integer(2)], sp.true),
    ],
)
def test_one_parameter(conditions, expected):
    assert all_positive(conditions) == expected


def test_a_bound_of_degree_three_is_a_decimal():
    condition = all_positive([k**3 - k - 1])
    with mpmath.workdps(40):
        (root,) = [z.real for z in mpmath.polyroots([1, 0, -1, -1], extraprec=200) if abs(z.imag) < 1e-30]
        assert abs(condition.rhs - sp.Float(root, 40)) < 1e-28


@pytest.mark.parametrize(
    ("conditions", "wanted", "expected"),
    [
        ([k + a, k * a + b], [], (k + a > 0) & (k * a + b > 0)),
        ([k + p, k * p + 1], [k], (k > -p) & (k > -1 / p)),
        ([a, k, a * k + 1], [], (a > 0) & (k > 0)),
        ([a, (a * b - k) / a, k], [], (a > 0) & (k < a * b) & (k > 0)),
        ([a, -a * b], [], (a > 0) & (b < 0)),
        ([2 * a + 2 * b], [], a + b > 0),
        ([a, -p * a], [], sp.false),
    ],
)
def test_several_parameters(conditions, wanted, expected):
    assert all_positive(conditions, wanted) == expected


@pytest.mark.parametrize(
    ("rows", "kind"),
    [
        ([[2, 1], [1, 2]], "positive definite"),
        ([[1, 1], [1, 1]], "positive semidefinite"),
        ([[1, 2], [2, 1]], "indefinite"),
        ([[-1, 0], [0, -2]], "negative definite"),
        ([[-1, 0], [0, 0]], "negative semidefinite"),
        ([[p, 0], [0, q]], "positive definite"),
        ([[a, 0], [0, 1]], None),
    ],
)
def test_definiteness(rows, kind):
    assert definiteness(sp.ImmutableMatrix(rows)) == kind
