"""Numbers in the form shown."""

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
