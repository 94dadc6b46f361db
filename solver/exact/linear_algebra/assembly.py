"""Sums of number times function, put together without sympy's rewriting where the result is known to be canonical.

Adding up the entries of e^{At} with `+` and `*` takes most of the time of the whole computation, since sympy looks for
like terms that the modes cannot have. A product of a number and a function without a numerical factor, and a sum of
such products of different functions, only need their arguments in sympy's order.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cmp_to_key, lru_cache
from typing import Any

import sympy as sp

_in_order = cmp_to_key(sp.Basic.compare)


def linear_combination(terms: Iterable[tuple[sp.Expr, sp.Expr]]) -> sp.Expr:
    """Σ coefficient · function over different functions, none a sum; a real sum with parameters is multiplied out."""
    number: sp.Expr = sp.S.Zero
    products: list[sp.Expr] = []
    for coefficient, function in terms:
        if function is sp.S.One and coefficient.is_Number:
            number = coefficient
        elif coefficient.is_Number and not function.is_Number:
            products.append(_scaled(coefficient, function))
        else:
            return sp.Add(number, *products, *_multiplied_out(coefficient, function), *_rest(terms))
    return _sum(number, products)


@lru_cache(maxsize=64)
def powers(x: sp.Symbol, count: int) -> tuple[sp.Expr, ...]:
    """So many powers of x, the highest first."""
    return tuple(x**k for k in reversed(range(count)))


def product_of_powers(number: sp.Expr, factors: Iterable[sp.Expr]) -> sp.Expr:
    """Number · factors, at least one; powers of different bases, none a number, and no sum alone beside a number."""
    ordered: list[sp.Expr] = sorted(factors, key=_in_order)
    if number is not sp.S.One:
        ordered.insert(0, number)
    return ordered[0] if len(ordered) == 1 else sp.Mul._from_args(ordered, is_commutative=True)


def _rest(terms: Iterable[tuple[sp.Expr, sp.Expr]]) -> Iterable[sp.Expr]:
    """The terms not yet taken from an iterator, by sympy's own arithmetic."""
    for coefficient, function in terms:
        yield from _multiplied_out(coefficient, function)


def _multiplied_out(coefficient: sp.Expr, function: sp.Expr) -> Iterable[sp.Expr]:
    if coefficient.is_Add and coefficient.is_number and not function.is_number:
        return [_over_one_denominator(coefficient, function)]
    parts = [coefficient] if coefficient.has(sp.I) else sp.Add.make_args(coefficient)
    return [part * function for part in parts]


def _over_one_denominator(constant: sp.Expr, function: sp.Expr) -> sp.Expr:
    """(5 + √5)/10 · f for f/2 + √5 f/10: a sum of roots stays the one coefficient of its function."""
    content, whole = constant.primitive()
    if whole.is_negative or (whole.is_negative is None and whole.could_extract_minus_sign()):
        content, whole = -content, -whole
    return sp.Mul(content, whole, function)


def _scaled(number: sp.Expr, function: sp.Expr) -> sp.Expr:
    if number is sp.S.One:
        return function
    factors: tuple[Any, ...] = function.args if function.is_Mul else (function,)
    if factors[0].is_Number:
        return sp.Mul(number, *factors)
    return sp.Mul._from_args([number, *factors], is_commutative=True)


def _sum(number: sp.Expr, products: list[sp.Expr]) -> sp.Expr:
    products.sort(key=_in_order)
    if number is not sp.S.Zero:
        products.insert(0, number)
    if len(products) < 2:
        return products[0] if products else sp.S.Zero
    return sp.Add._from_args(products, is_commutative=True)
