"""Sums collected as books on mechanics print them: by accelerations and velocities, coefficients in factors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.exact.modelling.angles import by_differences
from solver.exact.modelling.quotients import normal


def in_factors(expression: sp.Expr) -> sp.Expr:
    """Return a coefficient in normal form, by sums and differences of angles where these are shorter."""
    if not expression.has(sp.Add):
        return expression
    found = normal(expression)
    merged = by_differences(found)
    return _with_positive_sums(found if merged == found else normal(merged))


def scaled(coefficient: sp.Expr, other: sp.Expr) -> sp.Expr:
    """Return a product with its number in front of a sum, not in it: ½ (m + M) x."""
    number, rest = coefficient.as_content_primitive()
    product: sp.Expr = sp.Mul(number, _with_positive_sums(rest), other)
    return product


def _with_positive_sums(product: Any) -> sp.Expr:
    """The product with −(a + b) for each sum −a − b in it."""
    factors: Any = sp.Mul.make_args(product)
    turned = [f for f in factors if f.is_Add and all(term.as_coeff_Mul()[0].is_negative for term in f.args)]
    if not turned or len(factors) == 1:
        return product
    kept = [f for f in factors if f not in turned]
    return sp.Mul((-1) ** len(turned), *kept, *(-f for f in turned))


def collected(expression: sp.Expr, variables: Sequence[sp.Symbol]) -> list[sp.Expr] | None:
    """Return the terms of a polynomial in some symbols, each monomial once; None where it is none.

    Monomials with the first symbols lead, then those of the highest degree; what is free of them comes last.
    """
    found = coefficients(expression, variables)
    return None if found is None else [scaled(c, monomial) for monomial, c in found]


def coefficients(expression: sp.Expr, variables: Sequence[sp.Symbol]) -> list[tuple[sp.Expr, sp.Expr]] | None:
    """Return the monomials in some symbols with their coefficients that are not zero; None if it is no polynomial."""
    groups: dict[tuple[int, ...], list[sp.Expr]] = {}
    places: dict[sp.Expr, int] = {x: i for i, x in enumerate(variables)}
    for term in sp.Add.make_args(_spread(expression, variables)):
        powers, rest = [0] * len(variables), []
        for factor in sp.Mul.make_args(term):
            base, k = factor.as_base_exp()
            if base in places and k.is_Integer and k > 0:
                powers[places[base]] = int(k)
            else:
                rest.append(factor)
        if any(factor.has(*variables) for factor in rest):
            return None
        groups.setdefault(tuple(powers), []).append(sp.Mul(*rest))
    sums = {powers: in_factors(sp.Add(*terms)) for powers, terms in groups.items()}
    ordered = sorted((powers for powers, c in sums.items() if c != 0), key=lambda p: (-sum(p), [-k for k in p]))
    return [(sp.Mul(*(x**k for x, k in zip(variables, p, strict=True))), sums[p]) for p in ordered]


def _spread(expression: Any, variables: Sequence[sp.Symbol]) -> sp.Expr:
    """The expression multiplied out as far as the symbols stand in it: what is free of them is left as it is."""
    if not expression.has(*variables):
        return expression
    if expression.is_Add:
        return sp.Add(*(_spread(term, variables) for term in expression.args))
    if expression.is_Pow and expression.exp.is_Integer and expression.exp > 0:
        return sp.expand(expression)
    if expression.is_Mul:
        return sp.expand(expression)
    return expression


def grouped(expression: sp.Expr, variables: Sequence[sp.Symbol]) -> list[sp.Expr]:
    """Return the terms of a sum, those with the same functions of some symbols as one: (m₁ + m₂) g l cos θ."""
    groups: dict[sp.Expr, list[sp.Expr]] = {}
    for term in sp.Add.make_args(sp.expand(expression)):
        moving = sp.Mul(*(factor for factor in sp.Mul.make_args(term) if factor.has(*variables)))
        groups.setdefault(moving, []).append(term / moving)
    sums = {moving: in_factors(sp.Add(*terms)) for moving, terms in groups.items()}
    return [scaled(c, moving) for moving, c in sums.items() if c != 0]
