"""The figure of a condition on two parameters: where it holds in their plane."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation.parameter_figures import ParameterRegion
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.words import formula

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, Symbol

IN_THE_HALF_PLANE = "Where all roots lie in the open left half plane"
IN_THE_DISC = "Where all roots lie inside the unit circle"
MOST_CURVES = 6
HIGHEST = 8
"""Polynomials of higher degree are not drawn."""


def parameter_region(
    conditions: Sequence[Expr], wanted: Sequence[Symbol], condition: Any, *, discrete: bool = False
) -> tuple[ParameterRegion, ...]:
    """Return where conditions are positive in the plane of two parameters; nothing of more, or where they never are."""
    undecided = [each for each in conditions if each.free_symbols and exact.sign_of(each) != 1]
    symbols: list[Any] = sorted(
        set().union(*(each.free_symbols for each in undecided)) if undecided else set(), key=str
    )
    if len(symbols) != 2 or condition in (sp.true, sp.false):
        return ()
    x, y = wanted if len(wanted) == 2 and set(wanted) == set(symbols) else symbols
    listed = [*undecided, *(sign * each for each in symbols for sign in (1, -1) if exact.sign_of(sign * each) == 1)]
    turning: dict[Expr, None] = {}
    for each in listed:
        above, below = sp.fraction(sp.together(each))
        product = above * below
        if not product.is_polynomial(x, y):
            return ()
        turning[sp.expand(product)] = None
    found = _simplest(list(turning))
    if len(found) > MOST_CURVES or any(sp.Poly(each, x, y).total_degree() > HIGHEST for each in found):
        return ()
    names = tuple(f"{formula(each)} = 0" for each in found)
    title = IN_THE_DISC if discrete else IN_THE_HALF_PLANE
    return (ParameterRegion(title, x, y, tuple(found), names, (formula(x), formula(y))),)


def _simplest(polynomials: list[Expr]) -> list[Expr]:
    """The polynomials without factors that the others make positive, primitive."""
    found: list[Expr] = []
    for each in sorted(polynomials, key=lambda p: (sp.Poly(p).total_degree(), str(p))):
        number, factors = sp.factor_list(each)
        sign = sp.Integer(1) if number > 0 else sp.Integer(-1)
        left = []
        for factor, times in factors:
            if times % 2 and factor in found:
                continue
            if times % 2 and sp.expand(-factor) in found:
                sign = -sign
                continue
            left.append(factor ** (2 - times % 2))
        if left:
            kept = sp.expand(sign * sp.Mul(*left))
            found += [] if kept in found else [kept]
    return found
