"""Numbers and quotients in the form shown."""

from __future__ import annotations

import sympy as sp


def constant_form(found: sp.Expr) -> sp.Expr:
    """A number multiplied out; one fraction where a sum with powers of e stands below a line: (e⁴ − 2)/(e² − 1)²."""
    expanded: sp.Expr = sp.expand(found)
    if not found.has(sp.exp, sp.E) or not any(
        each.base.is_Add and each.exp.is_negative for each in expanded.atoms(sp.Pow)
    ):
        return expanded
    return sp.cancel(sp.together(found))


def number_multiplied_in(factored: sp.Expr) -> sp.Expr:
    """The expression with a number alone before a sum multiplied in: (p + q)/2 is p/2 + q/2."""
    number, rest = factored.as_coeff_Mul()
    return sp.Mul(number, rest) if rest.is_Add else factored


def common_factors_below(value: sp.Expr) -> sp.Expr:
    """The value with 1/(a − 1)² in place of 1/(a² − 2a + 1), and a (a − 2) above it."""
    if value.is_Rational:
        return value
    above, below = sp.fraction(value)
    return sp.factor(above) / sp.factor(below) if below.is_Add and below.free_symbols else value
