"""Derivatives of motions: sums of products of numbers, powers of time, exponentials, sines and cosines, term by term.

`sympy.diff` asks of each new expression all that might be assumed of it, which takes ten times as long.
"""

from __future__ import annotations

import sympy as sp


def derivative_of(expression: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """Return the derivative with respect to x, by the rules of sums and products."""
    if not expression.has(x):
        return sp.S.Zero
    if expression.is_Add:
        return sp.Add(*(derivative_of(term, x) for term in expression.args))
    if expression == x:
        return sp.S.One
    if expression.is_Mul:
        factors = expression.args
        moved = [i for i, factor in enumerate(factors) if factor.has(x)]
        return sp.Add(*(sp.Mul(*factors[:i], derivative_of(factors[i], x), *factors[i + 1 :]) for i in moved))
    if isinstance(expression, sp.exp):
        return sp.Mul(derivative_of(expression.args[0], x), expression)
    if isinstance(expression, sp.sin):
        return sp.Mul(derivative_of(expression.args[0], x), sp.cos(expression.args[0]))
    if isinstance(expression, sp.cos):
        return sp.Mul(-derivative_of(expression.args[0], x), sp.sin(expression.args[0]))
    if expression.is_Pow and expression.exp.is_Integer:
        base, n = expression.as_base_exp()
        return sp.Mul(n, base ** (n - 1), derivative_of(base, x))
    found: sp.Expr = sp.diff(expression, x)
    return found
