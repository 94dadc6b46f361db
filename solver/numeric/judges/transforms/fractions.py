"""Whether a sum is one of partial fractions: each term has one pole, or a pair that stays together, to a power."""

from __future__ import annotations

from typing import Any

import sympy as sp


def are_partial(total: Any, x: Any, *, sampled: bool = False) -> bool:
    """Return whether each term has a power of one factor below the line, and above it less than the factor in degree.

    A factor is irreducible over the coefficients as they are typed. Factors without x and dead times are none. Terms
    without a denominator are right. What is `sampled` may have z above the line, z/(z − a), and be late by z below it.
    """
    late = {each: sp.Dummy() for each in total.atoms(sp.exp) if each.has(x)}
    return all(_is_partial(term, x, sampled) for term in sp.Add.make_args(sp.expand_mul(total.xreplace(late))))


def _is_partial(term: Any, x: Any, sampled: bool) -> bool:
    numerator, denominator = term.as_numer_denom()
    factors = [factor for factor, _ in sp.factor_list(denominator, x)[1] if factor.has(x)]
    poles = [factor for factor in factors if not (sampled and factor == x)]
    if len(poles) != 1:
        return not poles
    return bool(sp.degree(numerator, x) < sp.degree(poles[0], x) + sampled)
