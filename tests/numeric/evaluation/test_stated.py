"""What the evaluation of stated formulas refuses, and how far it goes for its digits."""

import pytest
import sympy as sp

from solver.derivation import CheckStatus, Claim
from solver.numeric import NotEvaluable, check_claim
from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.values import SAFETY
from solver.stated.algebra import exponential, power, product, quotient, total
from solver.stated.calculus import derivative, integral, partial_derivative, value_at
from solver.stated.limits import limit
from solver.stated.lists import sum_over, sum_over_roots
from solver.stated.matrices import determinant, inverse, rank
from solver.stated.transforms import inverse_laplace, inverse_z, laplace, z_transform
from tests.stated.values import A, k, s, t, tau, x, z


@pytest.mark.parametrize(
    ("formula", "free"),
    [
        (integral(sp.exp(-tau * x), tau, 0, t), {x, t}),
        (integral(sp.exp(-tau * x), tau, tau, t), {x, t, tau}),
        (sum_over(x * k, k, [1, z]), {x, z}),
        (laplace(exponential(A * t * x), t, s), {x, s}),
        (product(x, value_at(x**2, x, t)), {x, t}),
        ([product(s, t), sp.Matrix([[z]])], {s, t, z}),
    ],
    ids=["integral", "limit of an integral", "sum", "transform", "value", "list"],
)
def test_what_is_bound_needs_no_value_and_what_is_outside_does(formula, free):
    assert free_symbols(formula) == free


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
        (limit(sp.sin(x), x, sp.oo), "settle"),
        (laplace(sp.exp(t**2), t, s), "too fast"),
        (laplace(sp.exp(t), t, sp.Rational(1, 2)), "slowly"),
        (z_transform(2**k, k, sp.Integer(1)), "slowly"),
        (sum_over_roots(x, x, sp.sin(x)), "no polynomial"),
        (sum_over(x, x, ()), "over nothing"),
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


@pytest.mark.parametrize(
    ("formula", "right", "status"),
    [
        (limit(x**2 / (x + 1), x, sp.oo), sp.oo, CheckStatus.PASSED),
        (limit(x**2 / (x + 1), x, sp.oo), -sp.oo, CheckStatus.FAILED),
        (limit(x**2 / (x + 1), x, sp.oo), sp.Integer(10**6), CheckStatus.FAILED),
        (limit(x / (x + 1), x, sp.oo), sp.oo, CheckStatus.FAILED),
        (limit(1 / x, x, 0, "-"), -sp.oo, CheckStatus.PASSED),
        (limit(1 / x, x, 0), sp.oo, CheckStatus.FAILED),
        (limit(1 / x**2, x, 0), sp.oo, CheckStatus.PASSED),
        (limit(sp.exp(x), x, sp.oo), sp.oo, CheckStatus.PASSED),
        (limit(1 + sp.exp(x - 1000), x, sp.oo), sp.Integer(1), CheckStatus.FAILED),
        (limit(sp.sign(x), x, 0), sp.Integer(0), CheckStatus.FAILED),
        (limit(sp.cos(2 * sp.pi * x), x, sp.oo), sp.Integer(1), CheckStatus.SKIPPED),
        (limit(1 / sp.log(x), x, sp.oo), sp.Integer(0), CheckStatus.SKIPPED),
    ],
)
def test_limits_that_are_infinite_or_do_not_exist(formula, right, status):
    assert check_claim(Claim(formula, right), "limit").status is status


def test_a_partial_derivative_leaves_the_other_variables_where_they_are():
    q = sp.Function("q")(t)
    energy = q * sp.diff(q, t)
    assert check_claim(Claim(partial_derivative(energy, q), sp.diff(q, t)), "").status is CheckStatus.PASSED
    assert check_claim(Claim(derivative(energy, t), sp.diff(q, t) ** 2), "").status is CheckStatus.FAILED


def test_two_unknown_functions_are_two():
    q, p = sp.Function("q")(t), sp.Function("p")(t)
    assert check_claim(Claim(derivative(q, t), sp.diff(p, t)), "").status is CheckStatus.FAILED
    assert check_claim(Claim(derivative(q, t, 2), sp.diff(q, t)), "").status is CheckStatus.FAILED
