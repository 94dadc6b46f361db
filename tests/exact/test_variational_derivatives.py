"""Kernels of extremals against sympy's own: variational derivatives, increments, integrals along functions."""

from __future__ import annotations

from itertools import pairwise

import pytest
import sympy as sp
from sympy.calculus.euler import euler_equations

from solver import exact
from solver.jets import jet_symbol

t = sp.Symbol("t")
X = [jet_symbol(("x", k)) for k in range(6)]
x, v, a = X[:3]
FOLLOWING = {t: sp.S.One, **dict(pairwise(X))}
INTEGRANDS = [
    (v**2 - x**2, 1), (x * sp.sqrt(1 + v**2), 1), (t * v**2 + x * v + sp.exp(x), 1), (sp.sqrt((1 + v**2) / x), 1),
    (a**2 / 2 - t * x, 2), (a**2 * x + v**3, 2), (v**2 / t**3, 1), (sp.exp(-t) * (v**2 + x**2), 1),
]  # fmt: skip


@pytest.mark.parametrize(("phi", "order"), INTEGRANDS)
def test_variational_derivatives_are_sympys(phi, order):
    found = exact.variational_derivative(phi, X[: order + 1], FOLLOWING)
    f = sp.Function("x")(t)
    functions = {X[k]: sp.diff(f, t, k) for k in range(6)}
    (equation,) = euler_equations(phi.subs({X[k]: functions[X[k]] for k in reversed(range(order + 1))}), [f], [t])
    path = 2 + t**3 / 3 + sp.sin(t)
    theirs = equation.lhs.subs(f, path).doit()
    ours = found.expression.subs({X[k]: sp.diff(path, t, k) for k in range(6)})
    assert abs(sp.N((ours - theirs).subs(t, sp.Rational(4, 5)), 30)) < 1e-25
    assert len(found.momenta) == order


@pytest.mark.parametrize(("phi", "order"), INTEGRANDS)
def test_what_is_cleared_is_the_equation(phi, order):
    whole = exact.variational_derivative(phi, X[: order + 1], FOLLOWING).expression
    found = exact.cleared(whole, list(reversed(X)))
    point = {t: sp.Rational(3, 4), **{q: sp.Rational(5 + i, 7) for i, q in enumerate(X)}}
    assert abs(sp.N((found.left * found.by - whole).subs(point), 30)) < 1e-25


def test_factors_that_may_vanish_stay():
    assert exact.cleared(2 * x * (a + x), [a]).left == x * (a + x)
    assert exact.cleared(-3 * (a + x) / (1 + v**2), [a]).left == a + x
    assert exact.cleared(sp.exp(-t) * (x - a), [a]).left == a - x
    assert exact.cleared(sp.S.Zero, [a]).left == 0


def test_the_increment_of_a_polynomial_is_whole():
    dx, dv = jet_symbol(("dx", 0)), jet_symbol(("dx", 1))
    found = exact.increment(t * x**3 + v**2, {x: dx, v: dv})
    assert found.whole
    parts = [sp.expand(sp.Add(*part)) for part in found.parts]
    assert parts == [sp.expand(3 * t * x**2 * dx + 2 * v * dv), sp.expand(3 * t * x * dx**2 + dv**2), t * dx**3]
    root = exact.increment(sp.sqrt(1 + v**2), {v: dv})
    assert not root.whole
    assert sp.simplify(sp.Add(*root.parts[1]) - dv**2 / (2 * (1 + v**2) ** sp.Rational(3, 2))) == 0


ALONG = [
    (sp.exp(t + 1) / (sp.exp(2) - 1) - sp.exp(1 - t) / (sp.exp(2) - 1), sp.sinh(t) / sp.sinh(1)),
    (sp.sqrt(2) * sp.sqrt(3 * t / 2 + sp.Rational(1, 2)), sp.sqrt(3 * t + 1)),
    ((t + 1) ** 2, t**2 + 2 * t + 1),
]


@pytest.mark.parametrize(("function", "written"), ALONG)
def test_functions_are_written_as_a_person_does(function, written):
    assert exact.in_time(function, t) == written


@pytest.mark.parametrize(
    "function", [sp.sinh(t) / sp.sinh(1), t**2 - 1, sp.sin(2 * t) + t, sp.exp(t) * sp.cos(t), sp.log(t), t**-2]
)
def test_integrals_along_functions_are_quadratures(function):
    integrand = exact.along(function**2 + sp.diff(function, t) ** 2, t)
    found = exact.definite_integral(integrand, t, sp.Integer(1), sp.Integer(2))
    wanted = sp.Integral(function**2 + sp.diff(function, t) ** 2, (t, 1, 2)).evalf(20)
    if function == sp.log(t):
        assert found is None
        found = exact.decimal_integral(integrand, t, sp.Integer(1), sp.Integer(2))
    assert abs(sp.N(found, 20) - wanted) < 1e-15


def test_roots_of_squares_are_cosh():
    u = 2 * t + 1
    assert exact.without_roots(sp.sqrt(1 + sp.sinh(u) ** 2)) == sp.cosh(u)
    assert exact.without_roots(3 / (1 + sp.sinh(u) ** 2) ** sp.Rational(3, 2)) == 3 / sp.cosh(u) ** 3
    assert exact.without_roots(sp.sqrt(2 + sp.sinh(u) ** 2)).has(sp.sinh)


def test_squares_under_roots_have_the_sign_of_the_interval():
    square, start, stop = sp.sqrt(t**2 - 4 * t + 4), sp.Integer(0), sp.Integer(2)
    assert exact.without_squares(square, t, start, stop) == 2 - t
    assert exact.without_squares(2 * square, t, sp.Integer(2), sp.Integer(5)) == 2 * t - 4
    assert exact.without_squares(square, t, start, sp.Integer(3)) == square
    assert exact.without_squares(sp.sqrt(2 * (t + 1) ** 2), t, start, stop) == sp.sqrt(2) * (t + 1)


def test_functions_that_leave_the_reals_are_seen():
    start, stop = sp.Integer(0), sp.Integer(2)
    for beyond in (sp.sqrt(t - 1), 1 / (t - 1), 1 / sp.sqrt(1 - t), sp.log(1 - t)):
        assert exact.leaves_reals(beyond, t, start, stop)
    for within in (sp.sqrt(t + 1), 1 / (t + 1), sp.exp(t) / (t**2 + 1), sp.cbrt(t + 3), sp.log(t + 1), t**3 - 8):
        assert not exact.leaves_reals(within, t, start, stop)
