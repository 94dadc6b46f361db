"""Antiderivatives that a table has."""

from __future__ import annotations

import sympy as sp

from solver.exact.functions.antiderivatives import antiderivative


def table_integral(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """An antiderivative of f in x; None where the table has none."""
    found = antiderivative(sp.ImmutableMatrix([[f]]), x)
    return None if found is None else found.function[0]


def integrated(f: sp.Expr, x: sp.Symbol, times: int) -> tuple[sp.Expr, ...] | None:
    """The antiderivative of f, that of it, and so on; None where the table does not have one of them."""
    found: list[sp.Expr] = []
    for _ in range(times):
        following = table_integral(f, x)
        if following is None:
            return None
        found.append(sp.expand(following) if following.is_polynomial(x) else following)
        f = found[-1]
    return tuple(found)
