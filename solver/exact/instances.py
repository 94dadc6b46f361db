"""Elements of K and L as sympy expressions, at a root of the factor."""

from __future__ import annotations

import sympy as sp

from solver.exact.fields import Algebraic, expression
from solver.exact.spectrum import Root


def element_at(a: Algebraic, root: Root) -> sp.Expr:
    """The element of L = K[x]/(p) at x = root, as an expression."""
    K = a.modulus.domain
    coefficients = [expression(K, c) for c in a.coefficients]
    if len(coefficients) == 1:
        return coefficients[0]
    return value_at(coefficients, root)


def value_at(coefficients: list[sp.Expr], root: Root) -> sp.Expr:
    """Σ cᵢ rootⁱ, multiplied out (numbers) or over one denominator (parameters); decimals keep 30 digits."""
    value: sp.Expr = sp.Integer(0)
    for c in reversed(coefficients):
        value = sp.expand(value * root.value + (sp.N(c, 40) if root.kind == "decimal" else c))
    if value.free_symbols:
        return sp.expand(sp.cancel(value)) if value.is_rational_function() else value
    return value
