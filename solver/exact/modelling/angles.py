"""Products of sines and cosines of two angles written by their sum or difference: cos a cos b + sin a sin b."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations
from typing import Any

import sympy as sp

Term = frozenset[Any]
"""A product as its bases with their exponents."""


def by_differences(expression: sp.Expr) -> sp.Expr:
    """Return a sum with cos(a ∓ b) and sin(a ± b) in place of the two products that make one; multiplied out before."""
    if len({f.args[0] for f in expression.atoms(sp.sin, sp.cos)}) < 2:
        return expression
    terms: dict[Term, sp.Expr] = {}
    for each in sp.Add.make_args(sp.expand(expression)):
        number, rest = each.as_coeff_Mul()
        terms[frozenset(rest.as_powers_dict().items())] = number
    while (found := next(_mergers(terms), None)) is not None:
        first, second, one = found
        number = terms.pop(first)
        del terms[second]
        key = frozenset(one.items())
        terms[key] = terms.get(key, sp.S.Zero) + number
        if not terms[key]:
            del terms[key]
    return sp.Add(*(sp.Mul(number, *(base**k for base, k in term)) for term, number in terms.items()))


def _mergers(terms: Mapping[Term, sp.Expr]) -> Iterator[tuple[Term, Term, dict[Any, Any]]]:
    """Yield two terms that are one, and this: c cos a cos b with ±c sin a sin b, c sin a cos b with ±c cos a sin b."""
    for term, number in terms.items():
        inside = [base for base, k in term if isinstance(base, sp.sin | sp.cos) and k.is_Integer and k > 0]
        for f, g in combinations(sorted(inside, key=sp.default_sort_key), 2):
            a, b = f.args[0], g.args[0]
            if a == b or not isinstance(f, sp.cos | sp.sin):
                continue
            rest = _without(term, f, g)
            alike = type(f) is type(g)
            if alike and isinstance(f, sp.sin):
                continue
            if not alike and isinstance(f, sp.cos):  # sin a cos b leads
                f, g, a, b = g, f, b, a
            other = _with(rest, _other(f)(a), _other(g)(b))
            if other in terms and terms[other] in (number, -number):
                same = terms[other] == number
                one = sp.cos(a - b if same else a + b) if alike else sp.sin(a + b if same else a - b)
                sign, bare = one.as_coeff_Mul()
                if sign == 1:
                    yield term, other, dict(_with(rest, bare))


def _other(f: Any) -> Any:
    return sp.cos if isinstance(f, sp.sin) else sp.sin


def _without(term: Term, *bases: Any) -> dict[Any, Any]:
    left = dict(term)
    for base in bases:
        left[base] -= 1
        if not left[base]:
            del left[base]
    return left


def _with(rest: Mapping[Any, Any], *bases: Any) -> Term:
    whole = dict(rest)
    for base in bases:
        if base != 1:
            whole[base] = whole.get(base, sp.S.Zero) + 1
    return frozenset(whole.items())
