"""Lemma: the value of a functional along an extremal."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import total
from solver.stated.calculus import integral
from solver.tasks.variations.constants import jets_along

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import Functional
    from solver.tasks.variations.constants import Fitted


@lemma("extremal_value")
def value_of(system: Functional, fitted: Fitted, number: int = 0) -> Derivation[Expr | None]:
    """The integrand along the extremal, its integral, and the terminal cost; `number` tells which of several.

    In decimals where no antiderivative is known; None where that is no number.
    """
    t = system.t
    jets = jets_along(system, fitted.functions, max(system.orders.values()))
    put = system.integrand.xreplace(jets)
    integrand = exact.along(put, t)
    found = exact.definite_integral(integrand, t, system.start, fitted.t_f)
    exactly = found is not None
    if found is None:
        found = exact.decimal_integral(integrand, t, system.start, fitted.t_f)
    if found is None:
        stated = integral(integrand, t, system.start, fitted.t_f)
        yield Step("left", unclaimed="the integral is not carried out", number=number, stated=stated)
        return None
    claims = {}
    if put != integrand:
        claims["along"] = Claim(put, integrand, "the integrand along the extremal")
    claims["integral"] = Claim(integral(integrand, t, system.start, fitted.t_f), found, "the integral")
    cost = system.terminal_cost.xreplace(jets).xreplace({t: fitted.t_f})
    whole: Expr = found if cost == 0 else exact.in_time(sp.expand(found + cost), t)
    if system.terminal_cost != 0:
        claims["whole"] = Claim(total(cost, found), whole, "the integral with the terminal cost")
    yield Step("value", exactly=exactly, claims=claims, number=number, time=fitted.t_f)
    return whole


def chosen(values: Mapping[int, Expr | None]) -> int:
    """Return which of several extremals has the least value, the first where that is not known."""
    known = {i: sp.N(value) for i, value in values.items() if value is not None and value.is_number}
    return min(known, key=lambda i: known[i]) if len(known) == len(values) else 0
