"""Formulas of `solver.stated.lists`: what they are equal to, and how they are printed."""

import sympy as sp
from sympy import Integer

from solver.stated.algebra import product
from solver.stated.lists import indexed_product, product_over, sum_over, sum_over_roots, summation
from tests.stated.values import A, a, k, s, t, x

RIGHT = [
    (summation(x**k, k, 0, 3), 1 + x + x**2 + x**3),
    (indexed_product(1 + x**k, k, 1, 3), (1 + x) * (1 + x**2) * (1 + x**3)),
    (indexed_product(product(A, k), k, 1, 3), 6 * A**3),
    (sum_over(x**2 + t, x, (1, a, -3)), 10 + a**2 + 3 * t),
    (product_over(s - x, x, (1, a)), (s - 1) * (s - a)),
    (product_over(product(x, A), x, (2, a)), 2 * a * A**2),
    (sum_over_roots(x**2, x, x**2 + a * x + 5), a**2 - 10),
    (sum_over_roots(1 / (s - x), x, (x - 1) ** 3), 3 / (s - 1)),
    (sum_over_roots(sp.exp(x * t) / (3 * x**2 - 1), x, x**3 - x), (sp.exp(t) + sp.exp(-t)) / 2 - 1),
]

PRINTED = [
    (summation(a + k, k, Integer(0), Integer(3)), r"\sum_{k = 0}^{3}(a + k)"),
    (indexed_product(a + k, k, Integer(0), Integer(3)), r"\prod_{k = 0}^{3}(a + k)"),
    (sum_over(x + 1, x, (1, a)), r"\sum_{x \in \left\{1, a\right\}}(x + 1)"),
    (product_over(s - x, x, (1, a)), r"\prod_{x \in \left\{1, a\right\}}(s - x)"),
    (sum_over_roots(x, x, x**2 - 2), r"\sum_{x^{2} - 2 = 0}x"),
]
