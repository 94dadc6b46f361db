"""Formulas of `solver.stated.limits`: what they are equal to, and how they are printed."""

import sympy as sp
from sympy import Integer, oo

from solver.stated.algebra import exponential, product, quotient
from solver.stated.limits import limit
from tests.stated.values import A, F, a, s, t, x

RIGHT = [
    (limit(sp.sin(a * x) / x, x, 0), a),
    (limit((1 - sp.cos(x)) / x**2, x, 0), sp.Rational(1, 2)),
    (limit((sp.exp(x) - 1 - x - x**2 / 2) / x**3, x, 0), sp.Rational(1, 6)),
    (limit((x**2 - a**2) / (x - a), x, a), 2 * a),
    (limit(product(s, quotient(s + 2, s * (s**2 + 3 * s + 5))), s, 0), sp.Rational(2, 5)),
    (limit((3 * x**2 + a * x) / (2 * x**2 + 1), x, oo), sp.Rational(3, 2)),
    (limit(sp.sqrt(x**2 + x) - x, x, oo), sp.Rational(1, 2)),
    (limit(1 + t * sp.exp(-t / 5), t, oo), 1),
    (limit(t**2 * sp.exp(-t), t, oo), 0),
    (limit(sp.exp(t), t, -oo), 0),
    (limit(sp.sin(t) / t, t, oo), 0),
    (limit((1 + a / x) ** x, x, oo), sp.exp(a)),
    (limit(sp.Abs(x) / x, x, 0, "+"), 1),
    (limit(sp.Abs(x) / x, x, 0, "-"), -1),
    (limit(sp.sqrt(x), x, 0, "+"), 0),
    (limit(exponential(product(A, t)), t, oo), sp.zeros(2)),
    (limit(product(s, F.inv()), s, oo), sp.eye(2)),
]

PRINTED = [
    (limit(s + 1, s, Integer(0)), r"\lim_{s \to 0}(s + 1)"),
    (limit(1 / x, x, Integer(0), "+"), r"\lim_{x \to 0^{+}}\frac{1}{x}"),
    (limit(x, x, oo), r"\lim_{x \to \infty}x"),
]
