"""Derivatives of motions: sums of products of numbers, powers of time, exponentials, sines and cosines, term by term.

`sympy.diff` asks of each new expression all that might be assumed of it, which takes several times as long.
"""

from __future__ import annotations

import sympy as sp


def derivative_of(expression: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """Return the derivative with respect to x, by the rules of sums and products."""
    if not expression.has(x):
        return sp.S.Zero
    if expression.is_Add:
        return sp.Add(*(derivative_of(term, x) for term in sp.Add.make_args(expression)))
    if expression.is_Mul:
        factors = sp.Mul.make_args(expression)
        moved = [i for i, factor in enumerate(factors) if factor.has(x)]
        return sp.Add(*(sp.Mul(*factors[:i], derivative_of(factors[i], x), *factors[i + 1 :]) for i in moved))
    return sp.S.One if expression == x else _of_function(expression, x)


def _of_function(function: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """The derivative by the chain rule; that of any other function as sympy has it."""
    if isinstance(function, sp.exp | sp.sin | sp.cos):
        inside = function.args[0]
        outer = {sp.exp: function, sp.sin: sp.cos(inside), sp.cos: -sp.sin(inside)}[function.func]
        return sp.Mul(derivative_of(inside, x), outer)
    found: sp.Expr = sp.diff(function, x)
    return found
