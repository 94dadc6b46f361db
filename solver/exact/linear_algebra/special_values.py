"""Special values of parameters: where an expression in them is zero, and which of them a formula divides by."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import vanishing_factors
from solver.exact.linear_algebra.signs import is_not_zero
from solver.matrices import entries

LONG = 400
"""Operations in an entry beyond which its denominator is not looked for."""


def special_values(f: sp.Expr) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The parameter and its real values for which f is zero: of one parameter up to degree 2, of several linear in one.

    Values that the parameter is known not to have are left out; () where f is of none of these forms.
    """
    symbols = sorted(f.free_symbols, key=str)
    if not symbols or not f.is_polynomial(*symbols) or any(x.is_real is False for x in symbols):
        return ()
    found: list[tuple[Any, Any]] = []
    if len(symbols) == 1 and sp.degree(f, symbols[0]) == 2:
        a, b, c = sp.Poly(f, symbols[0]).all_coeffs()
        root = sp.sqrt(b**2 - 4 * a * c)
        found = [(symbols[0], sp.expand((-b + sign * root) / (2 * a))) for sign in (1, -1)] if root.is_real else []
    else:
        found = _where_linear(f, symbols)[:1]
    return tuple((x, value) for x, value in dict.fromkeys(found) if not is_not_zero(x - value))


def _where_linear(f: sp.Expr, symbols: list[Any]) -> list[tuple[Any, Any]]:
    """Each parameter in which f is linear, with a coefficient that is a number or is never zero, and the zero."""
    found = []
    for x in symbols:
        p = sp.Poly(f, x)
        if p.degree() == 1 and is_not_zero(p.LC()):
            found.append((x, sp.factor(-p.TC() / p.LC())))
    return sorted(found, key=lambda each: sp.count_ops(each[1]))


def divisors(value: Any, parameters: Collection[sp.Symbol]) -> Iterator[sp.Expr]:
    """The factors by which the entries of a value are divided: those made of parameters only that may be zero."""
    if isinstance(value, list | tuple):
        for each in value:
            yield from divisors(each, parameters)
        return
    for entry in entries(value) if isinstance(value, sp.MatrixBase) else [value]:
        if isinstance(entry, sp.Expr) and entry.free_symbols & set(parameters) and entry.count_ops() <= LONG:
            below = sp.denom(sp.together(entry))
            yield from (f for f in vanishing_factors(below) if f.free_symbols <= set(parameters))
