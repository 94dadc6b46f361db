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
        number: sp.Expr
        number, rest = each.as_coeff_Mul()
        terms[frozenset(rest.as_powers_dict().items())] = number
    while (found := next(_mergers(terms), None)) is not None:
        first, second, one = found
        number = terms.pop(first)
        del terms[second]
        terms[one] = terms.get(one, sp.S.Zero) + number
        if not terms[one]:
            del terms[one]
    return sp.Add(*(sp.Mul(number, *(base**k for base, k in term)) for term, number in terms.items()))


def _mergers(terms: Mapping[Term, sp.Expr]) -> Iterator[tuple[Term, Term, Term]]:
    """Yield two terms that are one, and this: c cos a cos b with ±c sin a sin b, c sin a cos b with ±c cos a sin b."""
    for term, number in terms.items():
        inside = [base for base, k in term if isinstance(base, sp.sin | sp.cos) and k.is_Integer and k > 0]
        ordered = sorted(inside, key=lambda f: (isinstance(f, sp.cos), sp.default_sort_key(f)))
        for f, g in combinations(ordered, 2):
            if isinstance(g, sp.sin) or f.args == g.args:
                continue  # the products of two sines are found with those of the cosines
            rest = _without(term, f, g)
            other = _with(rest, _other(f), _other(g))
            if other in terms and terms[other] in (number, -number):
                one = _merged(f, g, same=terms[other] == number)
                if one.as_coeff_Mul()[0] == 1:
                    yield term, other, _with(rest, one)


def _merged(f: Any, g: Any, *, same: bool) -> sp.Expr:
    """Cos a cos b ± sin a sin b, or sin a cos b ± cos a sin b, as one."""
    a, b = f.args[0], g.args[0]
    if isinstance(f, sp.cos):
        return sp.cos(a - b if same else a + b)
    return sp.sin(a + b if same else a - b)


def _other(f: Any) -> Any:
    return sp.cos(f.args[0]) if isinstance(f, sp.sin) else sp.sin(f.args[0])


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
