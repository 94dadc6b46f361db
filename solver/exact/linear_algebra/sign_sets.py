"""Which signs an expression may have, for all values of its symbols that their assumptions allow.

A set of signs is never too small: what is not proved stays possible. The rules are: signs of factors, of the terms of
polynomials in symbols of known sign, no real roots, a negative discriminant, u + v √g by u² − v² g.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any

import sympy as sp

Signs = frozenset[int]
"""A subset of {−1, 0, 1}."""

ANY: Signs = frozenset({-1, 0, 1})
POSITIVE: Signs = frozenset({1})
NEGATIVE: Signs = frozenset({-1})
ZERO: Signs = frozenset({0})

DIGITS = 60
LONGEST = 300
"""Expressions with more operations are not looked into."""

DEPTH = 3
"""How often a rule may ask for the sign of an expression that it made itself."""


def of_product(a: Signs, b: Signs) -> Signs:
    """Return the signs of a product of factors with these signs."""
    return frozenset(x * y for x in a for y in b)


def of_sum(a: Signs, b: Signs) -> Signs:
    """Return the signs of a sum of terms with these signs."""
    if (1 in a and -1 in b) or (-1 in a and 1 in b):
        return ANY
    return frozenset(x + y if abs(x + y) < 2 else x for x in a for y in b)


def of_power(a: Signs, exponent: int) -> Signs:
    """Return the signs of a power; what stands below the bar is not zero."""
    found = frozenset(x if exponent % 2 else x * x for x in a) if exponent else POSITIVE
    return found - ZERO if exponent < 0 else found


def of_number(x: sp.Expr) -> Signs:
    """Return the sign of a real number."""
    if x.is_Rational:
        return frozenset({int(bool(x > 0)) - int(bool(x < 0))})
    value = sp.N(x, DIGITS)
    if not value.is_real:
        return ANY
    return ZERO if abs(value) < sp.Float(10) ** -40 else POSITIVE if value > 0 else NEGATIVE


def signs_by_assumptions(x: sp.Expr, depth: int = DEPTH) -> Signs:
    """Return the signs that an expression in real symbols may have."""
    if not x.free_symbols:
        return of_number(x)
    if x.count_ops() > LONGEST:
        return ANY
    found = POSITIVE
    for factor, exponent in factors(x):
        found = of_product(found, of_power(_of_factor(factor, depth), exponent))
    return found


def factors(x: sp.Expr) -> Iterator[tuple[sp.Expr, int]]:
    """Yield the factors with their exponents, negative below the bar."""
    for factor, exponent in sp.factor(sp.together(x)).as_powers_dict().items():
        yield (factor, int(exponent)) if exponent.is_Integer else (factor**exponent, 1)


@lru_cache(maxsize=4096)
def _of_factor(x: sp.Expr, depth: int) -> Signs:
    if not x.free_symbols:
        return of_number(x)
    found = assumed(x)
    if len(found) == 1 or depth == 0 or x.is_extended_real is False:
        return found
    found &= _with_a_root(x, depth) if _roots(x) else _of_polynomial(x, depth)
    return found


def assumed(x: sp.Expr) -> Signs:
    """Return the signs that sympy's own assumptions leave."""
    if x.is_positive or x.is_negative:
        return POSITIVE if x.is_positive else NEGATIVE
    if x.is_zero:
        return ZERO
    left = ANY - (NEGATIVE if x.is_nonnegative else frozenset()) - (POSITIVE if x.is_nonpositive else frozenset())
    return left - ZERO if x.is_nonzero else left


def _roots(x: sp.Expr) -> list[sp.Expr]:
    """The radicands of the square roots with symbols, the longest first."""
    found = {each.base for each in x.atoms(sp.Pow) if each.exp.is_Rational and each.exp.q == 2 and each.free_symbols}
    return sorted(found, key=lambda base: (-base.count_ops(), sp.default_sort_key(base)))


def _with_a_root(x: sp.Expr, depth: int) -> Signs:
    """The signs of u + v √g; where u and v √g oppose each other, u² − v² g decides."""
    g, r = _roots(x)[0], sp.Dummy("r", nonnegative=True)

    def is_root(each: Any) -> bool:
        return bool(each.is_Pow and each.base == g and each.exp.is_Rational and each.exp.q == 2)

    written: Any = x.replace(is_root, lambda each: r**each.exp.p)
    if not written.is_polynomial(r) or -1 in (of_g := signs_by_assumptions(g, depth - 1)):
        return ANY
    parts = [sp.Integer(0), sp.Integer(0)]
    for (power,), coefficient in sp.Poly(written, r).terms():
        parts[power % 2] += coefficient * g ** (power // 2)
    u, v = map(sp.expand, parts)
    of_u, of_v = signs_by_assumptions(u, depth - 1), of_product(signs_by_assumptions(v, depth - 1), of_g)
    together = of_sum(of_u, of_v)
    if together != ANY or len(of_u) > 1 or len(of_v) > 1:
        return together
    return of_product(of_u, signs_by_assumptions(sp.expand(u**2 - v**2 * g), depth - 1))


def _of_polynomial(x: sp.Expr, depth: int) -> Signs:
    named = {each: _stand_in(each) for each in x.atoms(sp.Function) if each.free_symbols}
    written = x.xreplace(named)
    symbols = sorted(written.free_symbols, key=sp.default_sort_key)
    if not all(symbol.is_real for symbol in symbols) or not written.is_polynomial(*symbols):
        return ANY
    p = sp.Poly(written, *symbols)
    found = ZERO
    for powers, coefficient in p.terms():
        term = of_number(coefficient)
        for symbol, power in zip(symbols, powers, strict=True):
            term = of_product(term, of_power(assumed(symbol), power))
        found = of_sum(found, term)
    if len(found) > 1 and len(symbols) == 1:
        found &= _without_roots(p, symbols[0])
    if len(found) > 1:
        for symbol in symbols:
            found &= _of_square(written, symbol, depth)
    return found


def _stand_in(x: sp.Expr) -> sp.Dummy:
    """A symbol with what is known of a function."""
    known = {"positive": True} if x.is_positive else {"nonnegative": True} if x.is_nonnegative else {}
    return sp.Dummy("f", **(known or ({"real": True} if x.is_extended_real else {"complex": True})))


def _without_roots(p: sp.Poly, x: sp.Symbol) -> Signs:
    """The sign of a polynomial in one symbol that has no root among the symbol's values."""
    if not (p.domain.is_QQ or p.domain.is_ZZ):
        return ANY
    low = 0 if x.is_nonnegative else None
    high = 0 if x.is_nonpositive else None
    count = p.count_roots(low, high)
    if count and (x.is_positive or x.is_negative) and not p.nth(0):
        count -= 1
    if count:
        return ANY
    return of_number(p.as_expr().xreplace({x: sp.Integer(-1 if x.is_nonpositive else 1)}))


def _of_square(x: sp.Expr, symbol: sp.Symbol, depth: int) -> Signs:
    """The signs of a k² + b k + c, where b² − 4ac is not positive those of a."""
    p = sp.Poly(x, symbol)
    if p.degree() != 2:
        return ANY
    a, b, c = p.all_coeffs()
    below = signs_by_assumptions(sp.expand(b**2 - 4 * a * c), depth - 1)
    of_a = signs_by_assumptions(a, depth - 1)
    if 1 in below or (0 in below and 0 in of_a):
        return ANY
    return of_a | ZERO if 0 in below else of_a - ZERO
