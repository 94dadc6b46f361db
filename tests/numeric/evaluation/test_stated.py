"""Every stated operation: what is right passes, what is nearly right fails."""

import itertools
from pkgutil import iter_modules

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Claim
from solver.numeric import NotEvaluable, check_claim
from solver.numeric.evaluation import operations
from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.stated import about
from solver.numeric.evaluation.values import SAFETY
from solver.stated import Stated, every_operation
from solver.stated.algebra import difference, exponential, power, product, quotient, total
from solver.stated.calculus import derivative, integral, summation, value_at
from solver.stated.matrices import adjugate, determinant, inverse, partitioned, rank, trace, transpose
from solver.stated.transforms import inverse_laplace, inverse_z

s, t, z, k, x, tau, w = sp.symbols("s t z k x tau omega", positive=None)
a = sp.Symbol("a", real=True)
A = sp.Matrix([[0, 1], [-2, -3]])
F = s * sp.eye(2) - A
PHI = sp.Matrix(
    [
        [2 * sp.exp(-t) - sp.exp(-2 * t), sp.exp(-t) - sp.exp(-2 * t)],
        [-2 * sp.exp(-t) + 2 * sp.exp(-2 * t), -sp.exp(-t) + 2 * sp.exp(-2 * t)],
    ]
)
CHI = s**2 + 3 * s + 2
ADJ = sp.Matrix([[s + 3, 1], [-2, s]])
POWER = sp.Matrix(
    [[2 * (-1) ** k - (-2) ** k, (-1) ** k - (-2) ** k], [-2 * (-1) ** k + 2 * (-2) ** k, -((-1) ** k) + 2 * (-2) ** k]]
)
SINGULAR = sp.Matrix([[1, 2, 3], [2, 4, 6], [1, 0, a]])

RIGHT = [
    (determinant(F), CHI),
    (determinant(SINGULAR), 0),
    (determinant(sp.Matrix([[a]])), a),
    (adjugate(F), ADJ),
    (adjugate(SINGULAR), sp.Matrix([[4 * a, -2 * a, 0], [6 - 2 * a, a - 3, 0], [-4, 2, 0]])),
    (adjugate(sp.Matrix([[a]])), sp.Matrix([[1]])),
    (partitioned(sp.Matrix([[a, 5], [7, 2]]), (1,), (1,)), sp.Matrix([[a, 5], [7, 2]])),
    (trace(sp.Matrix([[a, 5], [7, 2]])), a + 2),
    (rank(SINGULAR), 2),
    (summation(x**k, k, 0, 3), 1 + x + x**2 + x**3),
    (inverse(F), ADJ / CHI),
    (inverse(s + 1), 1 / (s + 1)),
    (transpose(sp.Matrix([[a, 1, 2]])), sp.Matrix([a, 1, 2])),
    (product(A, A), sp.Matrix([[-2, -3], [6, 7]])),
    (product(sp.Matrix([[1, a]]), sp.Matrix([3, 1])), 3 + a),
    (product(2, A, sp.Matrix([1, a])), sp.Matrix([2 * a, -4 - 6 * a])),
    (total(A, sp.eye(2), 3 * sp.eye(2)), sp.Matrix([[4, 1], [-2, 1]])),
    (difference(product(s, sp.eye(2)), A), F),
    (quotient(ADJ, CHI), ADJ / CHI),
    (quotient(adjugate(F), determinant(F)), ADJ / CHI),
    (power(A, 3), A**3),
    (power(A, -1), A.inv()),
    (power(A, 0), sp.eye(2)),
    (power(A, k), POWER),
    (power(a, 3), a**3),
    (power(x + 1, sp.Rational(1, 2)), sp.sqrt(x + 1)),
    (exponential(A * t), PHI),
    (exponential(product(A, t)), PHI),
    (exponential(sp.I * a), sp.cos(a) + sp.I * sp.sin(a)),
    (exponential(sp.zeros(2)), sp.eye(2)),
    (inverse_laplace(ADJ / CHI, s, t), PHI),
    (inverse_laplace(inverse(F), s, t), PHI),
    (inverse_laplace(inverse(difference(product(s, sp.eye(2)), A)), s, t), PHI),
    (inverse_laplace(quotient(adjugate(F), determinant(F)), s, t), PHI),
    (inverse_laplace(1 / (s + a) ** 3, s, t), t**2 * sp.exp(-a * t) / 2),
    (inverse_laplace(1 / s, s, t), 1),
    (inverse_laplace(w / (s**2 + w**2), s, t), sp.sin(w * t)),
    (inverse_laplace(1 / (s * (1 + 1 / (s + 2))), s, t), sp.Rational(2, 3) + sp.exp(-3 * t) / 3),
    (
        inverse_laplace(total(product(quotient(1, s + 1), A), product(quotient(2, power(s + 3, 2)), sp.eye(2))), s, t),
        A * sp.exp(-t) + 2 * t * sp.exp(-3 * t) * sp.eye(2),
    ),
    (inverse_laplace(1e-3 / (s + 1e-3), s, t), sp.Rational(1, 1000) * sp.exp(-t / 1000)),
    (inverse_z(z * inverse(z * sp.eye(2) - A).operands[0].inv(), z, k), POWER),
    (inverse_z(product(z, inverse(z * sp.eye(2) - A)), z, k), POWER),
    (inverse_z(z / (z - a) ** 2, z, k), k * a ** (k - 1)),
    (inverse_z(1 / z**2, z, k), sp.KroneckerDelta(k, 2)),
    (inverse_z(product(z, total(quotient(1, z - 2), quotient(1, z - a))), z, k), 2**k + a**k),
    (derivative(sp.exp(a * x), x), a * sp.exp(a * x)),
    (derivative(sp.Matrix([[sp.exp(-50 * x), x**4]]), x, 3), sp.Matrix([[-125000 * sp.exp(-50 * x), 24 * x]])),
    (derivative(1 / (x - 3), x, 2), 2 / (x - 3) ** 3),
    (derivative(inverse(F), s), -(F.inv() ** 2)),
    (integral(sp.exp(-a * tau), tau, 0, t), (1 - sp.exp(-a * t)) / a),
    (integral(product(sp.exp(-(t - tau)), sp.sin(tau)), tau, 0, t), (sp.exp(-t) + sp.sin(t) - sp.cos(t)) / 2),
    (integral(exponential(A * tau), tau, 0, t), A.inv() * (PHI - sp.eye(2))),
    (integral(sp.exp(-3 * tau), tau, 1, sp.oo), sp.exp(-3) / 3),
    (value_at(PHI, t, 0), sp.eye(2)),
    (value_at(derivative(PHI, t, 2), t, sp.Integer(0)), A**2),
    (value_at(x**2 + a, x, a), a**2 + a),
    ([determinant(A), trace(A)], [2, -3]),
]


def nearly(right):
    """Wrong right sides that are close: one entry off by a thousandth, by one; the transpose; the sign."""
    right = sp.S.One * sp.Matrix(right) if isinstance(right, list) else right
    if not isinstance(right, sp.MatrixBase):
        return [right + sp.Rational(1, 1000), -right + 1, right * 2 + 1]
    wrong = []
    for i, j in itertools.product(range(right.rows), range(right.cols)):
        entry = right[i, j]
        for change in (entry * sp.Rational(1001, 1000) + sp.Rational(1, 10**6), entry + 1, 1 - entry):
            other = right.as_mutable()
            other[i, j] = change
            if other[i, j] != entry:
                wrong.append(other)
    return wrong


@pytest.mark.parametrize(("left", "right"), RIGHT, ids=lambda side: getattr(side, "operation", "") or None)
def test_a_right_statement_passes(left, right):
    check = check_claim(Claim(left, right), "right")
    assert check.status is CheckStatus.PASSED, check


@pytest.mark.parametrize(("left", "right"), RIGHT, ids=lambda side: getattr(side, "operation", "") or None)
def test_a_nearly_right_statement_fails(left, right):
    if isinstance(left, list):
        right = list(right)
        candidates = [[right[0] + 1, *right[1:]], [*right[:-1], -right[-1]], right[::-1]]
    else:
        candidates = nearly(right)
    for wrong in candidates:
        check = check_claim(Claim(left, wrong), "wrong")
        assert check.status is CheckStatus.FAILED, (wrong, check)


def test_every_operation_that_can_be_stated_can_be_evaluated_and_is_in_the_table():
    assert all(about(name, "evaluate") for name in every_operation())
    assert {left.operation for left, _ in RIGHT if isinstance(left, Stated)} >= set(every_operation())


def test_every_evaluation_belongs_to_an_operation():
    assert {module.name for module in iter_modules(operations.__path__)} == set(every_operation())


def test_an_operation_without_an_evaluation_is_told():
    with pytest.raises(NotEvaluable, match="no rule for the operation nothing"):
        value_of(Stated("nothing", (1,)), Environment.at([{}]))


@pytest.mark.parametrize(
    ("formula", "reason"),
    [
        (inverse_laplace(sp.exp(-s) / s, s, t), "not rational"),
        (inverse_laplace(1 / sp.sqrt(s), s, t), "not rational"),
        (inverse_laplace(inverse(exponential(s)), s, t), "not known"),
        (inverse_laplace(inverse(sp.Matrix([[s, 1], [1, 0]])), s, t), "singular"),
        (inverse_z(1 / (z - 2), z, sp.Rational(1, 2)), "whole"),
        (derivative(sp.Abs(x), x), "analytic"),
        (derivative(sp.conjugate(x), x), "analytic"),
        (integral(1 / tau, tau, 1, sp.oo), "slowly"),
        (power(A, sp.Rational(1, 2)), "whole"),
    ],
)
def test_what_has_no_sound_evaluation_is_skipped_with_the_reason(formula, reason):
    check = check_claim(Claim(formula, 1), "refused")
    assert check.status is CheckStatus.SKIPPED
    assert reason in check.reason


@pytest.mark.parametrize("rate", [1, 30, 60])
def test_an_integral_with_many_digits_is_refined_until_they_are_known(rate):
    arithmetic = multiple(50)
    formula = integral(sp.exp(-rate * tau) * sp.sin(tau), tau, 0, 3)
    found = value_of(formula, Environment.at([{}], arithmetic))
    mp = arithmetic.context
    right = (1 - mp.exp(-3 * rate) * (rate * mp.sin(3) + mp.cos(3))) / (rate**2 + 1)
    error = abs(complex(found.value[0] - right))
    assert error <= 1e-9 * abs(complex(right))
    assert error <= SAFETY * arithmetic.eps * found.magnitude[0]


def test_an_integrand_too_quick_for_the_nodes_is_refused():
    with pytest.raises(NotEvaluable, match="smooth"):
        value_of(integral(sp.cos(900 * tau), tau, 0, 3), Environment.at([{}], multiple(50)))


@pytest.mark.parametrize("pole", [sp.Rational(1, 5), sp.Rational(3, 2), sp.Rational(1, 50)])
def test_a_pole_near_the_point_of_differentiation_is_kept_outside_the_circle(pole):
    claim = Claim(value_at(derivative(1 / (x - pole), x, 1), x, 0), -1 / pole**2)
    assert check_claim(claim, "derivative").status is CheckStatus.PASSED


@pytest.mark.parametrize(
    "claim",
    [
        Claim(product(A, sp.Matrix([[1, 2]])), A),
        Claim(total(A, sp.eye(3)), A),
        Claim(determinant(sp.Matrix([[1, 2]])), 1),
        Claim(A, sp.eye(3)),
        Claim(sp.Matrix([1, 2]), sp.Matrix([[1, 2]])),
        Claim(quotient(1, A), A.inv()),
    ],
)
def test_shapes_that_do_not_fit_fail_the_claim(claim):
    check = check_claim(claim, "misshapen")
    assert check.status is CheckStatus.FAILED
    assert "matri" in check.reason or "shapes" in check.reason


@pytest.mark.parametrize(
    ("matrix", "right"),
    [
        (sp.Matrix([[1, 2, 3], [2, 4, 6]]), 1),
        (sp.Matrix([[1, sp.Symbol("a")], [2, 4]]), 2),
        (sp.Matrix([[sp.sqrt(2), 2], [1, sp.sqrt(2)]]), 1),
        (sp.Matrix([[sp.Rational(1, 10**9), 0], [0, 1]]), 2),
        (sp.zeros(2, 3), 0),
    ],
)
def test_a_rank_is_decided_with_as_many_digits_as_it_takes(matrix, right):
    formula = rank(sp.ImmutableMatrix(matrix))
    assert check_claim(Claim(formula, sp.Integer(right)), "").status is CheckStatus.PASSED
    assert check_claim(Claim(formula, sp.Integer(right + 1)), "").status is CheckStatus.FAILED
