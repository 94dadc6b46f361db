"""Integrands along known functions, and their integrals."""

from __future__ import annotations

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.variations.exponential_sums import read
from solver.exact.variations.table_of_integrals import table_integral


def along(integrand: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """Return an expression in t as a sum of functions a table of integrals has, where it is one; else in factors."""
    if integrand.is_polynomial(t):
        return sp.expand(integrand)
    try:
        found: sp.Expr = read(integrand, [t]).expression
    except NotExact:
        found = sp.factor(sp.together(integrand))
    return found


def definite_integral(integrand: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> sp.Expr | None:
    """Return the integral of an expression over t; None where no antiderivative is known, or it has no values there."""
    terms = sp.Add.make_args(sp.expand(integrand))
    found = [each for term in terms if (each := _antiderivative(term, t)) is not None]
    if len(found) < len(terms):
        return None
    whole = sp.Add(*found)
    values = [whole.xreplace({t: end}) for end in (stop, start)]
    if any(value.has(sp.nan, sp.zoo, sp.oo) for value in values):
        return None
    return sp.expand(values[0] - values[1])


def _antiderivative(term: sp.Expr, t: sp.Symbol) -> sp.Expr | None:
    """Of a constant, a power of t, or what the table has."""
    constant, rest = term.as_independent(t, as_Add=False)
    base, exponent = rest.as_base_exp()
    if rest == 1:
        return constant * t
    if base == t and not exponent.has(t):
        return constant * (sp.log(t) if exponent == -1 else t ** (exponent + 1) / (exponent + 1))
    return table_integral(term, t)


def tidy_in_time(function: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """Return a function of t, polynomials multiplied out; where it is no polynomial, as it stands."""
    return sp.expand(function) if function.is_polynomial(t) and not function.atoms(sp.Float) else function
