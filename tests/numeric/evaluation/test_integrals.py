"""Integrals that stand in a formula: against antiderivatives, within each other, and what is refused."""

import math

import pytest
import sympy as sp

from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.values import NotEvaluable

t, tau, tau_1 = sp.symbols("t tau tau_1")
v = sp.Function("v")


def test_an_integral_has_the_value_of_its_antiderivative():
    found = evaluate(sp.Integral(sp.cos(3 * tau), (tau, 0, t)), {t: 0.8})
    assert abs(found - math.sin(2.4) / 3) < 1e-13


def test_an_integral_of_an_integral_is_one():
    twice = sp.Integral(sp.sin(tau), (tau, 0, tau_1), (tau_1, 0, t))
    assert abs(evaluate(twice, {t: 0.7}) - (0.7 - math.sin(0.7))) < 1e-13
    kernel = sp.Integral((t - tau) * v(tau), (tau, 0, t))
    unknown = sp.Integral(v(tau), (tau, 0, tau_1), (tau_1, 0, t))
    assert abs(evaluate(unknown, {t: 1.3}) - evaluate(kernel, {t: 1.3})) < 1e-12


def test_the_derivative_of_an_integral_is_what_is_integrated():
    found = evaluate(sp.Derivative(sp.Integral(v(tau), (tau, 0, t)), t), {t: 0.6}, tolerance=1e-6)
    assert abs(found - evaluate(v(t), {t: 0.6})) < 1e-9


@pytest.mark.parametrize(
    "formula", [sp.Integral(v(tau), tau), sp.Integral(v(tau) * tau_1, (tau, 0, tau_1), (tau_1, 0, t))]
)
def test_what_has_no_such_value_is_refused(formula):
    with pytest.raises(NotEvaluable):
        evaluate(formula, {t: 1.0, tau: 0.5})
