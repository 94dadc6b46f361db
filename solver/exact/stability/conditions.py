"""When several rational functions of parameters are positive together: the condition in its shortest form."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.stability.inequalities import (
    Condition,
    generator_of,
    positive_intervals,
    relational,
    sign_of,
    signed_factors,
)


def all_positive(conditions: Sequence[sp.Expr], wanted: Sequence[sp.Symbol] = ()) -> Condition:
    """When all conditions are positive: intervals of one parameter, or a conjunction without what others imply.

    `wanted` are the parameters asked for: a condition linear in one of them alone is solved for it.
    """
    if any(x.has(sp.I) for x in conditions):
        raise NotExact("stability/not_real")
    generator = generator_of(conditions)
    if generator is not None:
        return relational(positive_intervals(conditions, generator), generator)
    kept = _conjunction(conditions)
    if kept is None:
        return sp.false
    kept = _without_implied(kept)
    return sp.And(*(_solved(x, wanted) for x in kept[0]), *(sp.Ne(x, 0) for x in kept[1]))


Kept = tuple[list[sp.Expr], list[sp.Expr]]


def _conjunction(conditions: Sequence[sp.Expr]) -> Kept | None:
    """What must be positive and what only not zero, without factors whose sign is known; None if it cannot be."""
    positive: list[sp.Expr] = []
    nonzero: list[sp.Expr] = []
    for condition in conditions:
        sign, left = 1, []
        for factor, exponent in signed_factors(condition):
            known = sign_of(factor)
            known = (
                1 if known is None and factor in positive else -1 if known is None and -factor in positive else known
            )
            if known == 0:
                return None
            if exponent % 2 == 0:
                nonzero += [factor] if known is None and factor not in nonzero else []
            elif known is None:
                left.append(factor)
            else:
                sign *= known
        if not left and sign < 0:
            return None
        if left:
            positive += _new(sp.expand(sign * left[0]) if len(left) == 1 else sign * sp.Mul(*left), positive)
    return positive, [x for x in nonzero if x not in positive and -x not in positive]


def _new(x: sp.Expr, known: list[sp.Expr]) -> list[sp.Expr]:
    """The primitive part of x, if it is not known yet."""
    content, primitive = x.as_content_primitive() if x.is_Add else (sp.Integer(1), x)
    each = primitive if content > 0 else -primitive
    return [] if each in known else [each]


def _without_implied(kept: Kept) -> Kept:
    """Leave out what is positive already because some symbols are."""
    positive, nonzero = kept
    signs: dict[sp.Expr, sp.Expr] = {x: sp.Dummy(str(x), positive=True) for x in positive if x.is_Symbol}
    signs |= {-x: -sp.Dummy(str(-x), positive=True) for x in positive if (-x).is_Symbol}

    def implied(x: sp.Expr) -> bool:
        return x not in signs and -x not in signs and sign_of(sp.expand(x.xreplace(signs))) == 1

    return [x for x in positive if not implied(x)], [x for x in nonzero if sign_of(x.xreplace(signs)) is None]


def _solved(x: sp.Expr, wanted: Sequence[sp.Symbol]) -> Condition:
    """X > 0, solved for the one wanted parameter in it where it is linear in it."""
    inside: list[Any] = [k for k in wanted if k in x.free_symbols] or sorted(x.free_symbols, key=str)
    if len(inside) == 1:
        (k,) = inside
        if x.is_polynomial(k) and sp.degree(x, k) == 1:
            a, b = sp.Poly(x, k).all_coeffs()
            sign = sign_of(a)
            if sign:
                bound = sp.factor(-b / a)
                return sp.Gt(k, bound) if sign > 0 else sp.Lt(k, bound)
    return sp.Gt(x, 0)
