"""The increment of an integrand by the powers of a variation."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations_with_replacement

import sympy as sp

from solver.exact.modelling.quotients import normal

ORDERS = 2
"""So many parts are found where the increment is no polynomial in the variation."""
MOST_DEGREE = 12
"""Beyond it a polynomial is not multiplied out."""


@dataclass(frozen=True, slots=True)
class Increment:
    """f(q + δq) − f(q): as it stands, and its parts of degree 1, 2, ... in δq, each the list of its terms.

    Where it is a polynomial in δq the parts are the `whole`, else the first two of a Taylor series.
    """

    stands: sp.Expr
    parts: tuple[tuple[sp.Expr, ...], ...]
    whole: bool


def increment(expression: sp.Expr, variations: Mapping[sp.Symbol, sp.Symbol]) -> Increment:
    """Return the increment of an expression where each q is changed by `variations`[q]."""
    shifted = expression.xreplace({q: q + d for q, d in variations.items()})
    whole = expression.is_polynomial(*variations)
    degree = sp.Poly(expression, *variations).total_degree() if whole else ORDERS
    whole = whole and degree <= MOST_DEGREE
    parts = _multiplied_out(shifted, list(variations.values())) if whole else _by_taylor(expression, variations)
    terms = {n: tuple(listed) for n, listed in parts.items()}
    last = max(ORDERS, *terms) if terms else ORDERS
    return Increment(shifted - expression, tuple(terms.get(n, ()) for n in range(1, last + 1)), whole)


def _multiplied_out(shifted: sp.Expr, by: list[sp.Symbol]) -> dict[int, list[sp.Expr]]:
    parts: dict[int, list[sp.Expr]] = {}
    for powers, coefficient in sp.Poly(shifted, *by).terms():
        if sum(powers) and coefficient != 0:
            monomial = sp.Mul(*(d**k for d, k in zip(by, powers, strict=True)))
            parts.setdefault(sum(powers), []).append(_scaled(sp.expand(coefficient), monomial))
    return parts


def _by_taylor(expression: sp.Expr, variations: Mapping[sp.Symbol, sp.Symbol]) -> dict[int, list[sp.Expr]]:
    parts: dict[int, list[sp.Expr]] = {}
    for n in range(1, ORDERS + 1):
        for which in combinations_with_replacement(variations, n):
            times = [which.count(q) for q in dict.fromkeys(which)]
            found = tidied(sp.diff(expression, *which)) / sp.Mul(*map(sp.factorial, times))
            if found != 0:
                parts.setdefault(n, []).append(_scaled(found, sp.Mul(*(variations[q] for q in which))))
    return parts


def _scaled(coefficient: sp.Expr, monomial: sp.Expr) -> sp.Expr:
    """The term, with a number in front of a sum multiplied in."""
    number, rest = coefficient.as_coeff_Mul()
    return sp.Mul(sp.expand(coefficient) if rest.is_Add and number != 1 else coefficient, monomial)


def tidied(derivative: sp.Expr) -> sp.Expr:
    """Return a derivative in normal form; one with roots or functions over one denominator, where that is shorter."""
    if not derivative.atoms(sp.Function) and all(each.exp.is_Integer for each in derivative.atoms(sp.Pow)):
        return normal(derivative)
    together = sp.factor(sp.together(derivative))
    return together if together.count_ops() < derivative.count_ops() else derivative
