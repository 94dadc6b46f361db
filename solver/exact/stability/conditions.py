"""When several rational functions of parameters are positive together: the condition in its shortest form."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import prod
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

    `wanted` are the parameters asked for: a condition linear in one of them alone is solved for it. Where none are,
    a parameter that conditions bound from both sides is taken.
    """
    if any(x.has(sp.I) for x in conditions):
        raise NotExact("stability/not_real")
    generator = generator_of(conditions)
    if generator is not None:
        return relational(positive_intervals(conditions, generator), generator)
    kept = _conjunction(conditions)
    if kept is None:
        return sp.false
    decided = _decided(kept[0])
    if decided is None:
        return sp.false
    positive, nonzero = _without_implied((decided, [x for x in kept[1] if x not in decided and -x not in decided]))
    return sp.And(*_relations(positive, wanted or _enclosed(positive)), *(sp.Ne(x, 0) for x in nonzero))


MOST_FACTORS = 6
"""Of more factors the signs are not tried one by one."""

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


def _decided(positive: list[sp.Expr]) -> list[sp.Expr] | None:
    """The products taken apart where their factors can have these signs only; None where no signs are possible."""
    products = [[each for each in signed_factors(x) if sign_of(each[0]) is None] for x in positive]
    factors = list(dict.fromkeys(factor for each in products for factor, _ in each))
    if all(len(each) < 2 for each in products) or len(factors) > MOST_FACTORS:
        return positive
    known = [sign_of(sp.Mul(*(f**n for f, n in signed_factors(x) if sign_of(f) is not None))) for x in positive]
    possible = []
    for signs in product((1, -1), repeat=len(factors)):
        at = dict(zip(factors, signs, strict=True))
        held = (k == prod(at[f] for f, n in each if n % 2) for k, each in zip(known, products, strict=True))
        listed = [sign * factor for factor, sign in at.items()]
        if all(held) and not _contradictory(listed):
            possible.append(listed)
    if len(possible) == 1:
        return [sp.expand(x) for x in possible[0]]
    return positive if possible else None


def _contradictory(positive: list[sp.Expr]) -> bool:
    """Whether it is seen that these cannot be positive together."""
    signs = _signs_of_symbols(positive)
    if any(sign_of(sp.expand(x.xreplace(signs))) == -1 for x in positive if x not in signs and -x not in signs):
        return True
    alone = [(generator_of(each), each) for symbol, each in _by_symbol(positive).items() if symbol is not None]
    return any(g is not None and not positive_intervals(each, g) for g, each in alone)


def _relations(positive: list[sp.Expr], wanted: Sequence[sp.Symbol]) -> Iterator[Condition]:
    """The conditions, those on one symbol alone as an interval of it where they are several."""
    for symbol, each in _by_symbol(positive).items():
        generator = generator_of(each) if symbol is not None and len(each) > 1 else None
        if generator is not None:
            yield relational(positive_intervals(each, generator), generator)
        else:
            yield from (_solved(x, wanted) for x in each)


def _enclosed(positive: list[sp.Expr]) -> list[sp.Symbol]:
    """A parameter that is bounded from below and from above, by other parameters at least once: 0 < K < ab."""
    symbols: set[Any] = set().union(*(each.free_symbols for each in positive))
    for x in sorted(symbols, key=str):
        solved = [_solved(each, [x]) for each in positive if x in each.free_symbols]
        bounds = [each for each in solved if isinstance(each, sp.Rel) and each.lhs == x]
        if len({type(each) for each in bounds}) == 2 == len(solved) and any(each.rhs.free_symbols for each in bounds):
            return [x]
    return []


def _by_symbol(positive: list[sp.Expr]) -> dict[Any, list[sp.Expr]]:
    """The expressions by their only symbol; None for those with several."""
    groups: dict[Any, list[sp.Expr]] = {}
    for x in positive:
        groups.setdefault(next(iter(x.free_symbols)) if len(x.free_symbols) == 1 else None, []).append(x)
    return groups


def _signs_of_symbols(positive: list[sp.Expr]) -> dict[sp.Expr, sp.Expr]:
    """Symbols of the signs that are said of them, by those of the problem."""
    signs: dict[sp.Expr, sp.Expr] = {x: sp.Dummy(str(x), positive=True) for x in positive if x.is_Symbol}
    return signs | {-x: -sp.Dummy(str(-x), positive=True) for x in positive if (-x).is_Symbol}


def _without_implied(kept: Kept) -> Kept:
    """Leave out what is positive already because some symbols are."""
    positive, nonzero = kept
    signs = _signs_of_symbols(positive)

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
