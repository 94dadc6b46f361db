"""Partial derivatives of quotients at a point, put in before anything is multiplied out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import sympy as sp

from solver.exact.modelling.derivatives import partial
from solver.exact.modelling.quotients import normal

Values = Mapping[sp.Symbol, sp.Expr]
CORNERS = (sp.Abs, sp.sign, sp.Heaviside, sp.Min, sp.Max)
"""Functions with a corner or a jump where an argument vanishes."""
LONG = 10**9
"""Denominators that only decimals with many digits have."""
DIGITS = 15
"""Digits of a value that decimals give."""


class NotDifferentiable(Exception):  # noqa: N818 - no error: the function has no derivative at the point
    """A function has no value or no derivative at the point."""


@dataclass(frozen=True)
class Quotient:
    """A function as it is differentiated: numerator, denominator, and both at the point."""

    function: sp.Expr
    numerator: sp.Expr
    denominator: sp.Expr
    at: Values = field(repr=False)

    @cached_property
    def above(self) -> sp.Expr:
        """The numerator at the point."""
        return put_in(self.numerator, self.at)

    @cached_property
    def below(self) -> sp.Expr:
        """The denominator at the point."""
        return put_in(self.denominator, self.at)


@dataclass(frozen=True)
class Partial:
    """∂f/∂x: the `formula` and its `value` at the point.

    Where f = N/D and N is zero at the point, `of_numerator` is true: the formula is ∂N/∂x, and ∂f/∂x is that over D
    there; `above` and `below` are what ∂N/∂x and D are at the point.
    """

    formula: sp.Expr
    value: sp.Expr
    of_numerator: bool = False
    above: sp.Expr = sp.S.Zero
    below: sp.Expr = sp.S.One


def put_in(expression: sp.Expr, at: Values) -> sp.Expr:
    """Return the value of an expression at a point, in normal form. Raises NotDifferentiable where it has none."""
    for corner in expression.atoms(*CORNERS):
        if normal(corner.args[0].xreplace(dict(at))) == 0:
            raise NotDifferentiable
    value = expression.xreplace(dict(at))
    if value.has(sp.zoo, sp.nan, sp.oo, -sp.oo, sp.I):
        raise NotDifferentiable
    return normal(value)


def quotient_at(function: sp.Expr, at: Values) -> Quotient:
    """Return a function as numerator and denominator. Raises NotDifferentiable where it has no value at the point."""
    above, below = sp.fraction(function, exact=True)
    found = Quotient(function, above, below, at)
    if found.below == 0:
        raise NotDifferentiable
    return found


def partial_at(quotient: Quotient, x: sp.Symbol) -> Partial:
    """Return ∂f/∂x and its value at the point. Raises NotDifferentiable."""
    n, d = quotient.numerator, quotient.denominator
    if not d.has(x):
        formula = partial(quotient.function, x)
        return Partial(formula, put_in(formula, quotient.at))
    of_n = partial(n, x)
    if quotient.above == 0:
        above, below = put_in(of_n, quotient.at), quotient.below
        return Partial(of_n, normal(above / below), True, above, below)
    of_d = partial(d, x)
    above, below = put_in(of_n, quotient.at), quotient.below
    value = normal(above / below - quotient.above * put_in(of_d, quotient.at) / below**2)
    return Partial((of_n * d - n * of_d) / d**2, value)


def partials_at(
    functions: Sequence[sp.Expr], variables: Sequence[sp.Symbol], at: Values
) -> tuple[list[Quotient], list[list[Partial]]]:
    """Return functions as quotients, and the rows of their partial derivatives. Raises NotDifferentiable."""
    quotients = [quotient_at(f, at) for f in functions]
    nothing = Partial(sp.S.Zero, sp.S.Zero)
    rows = [[_short(partial_at(q, x)) if q.function.has(x) else nothing for x in variables] for q in quotients]
    return quotients, rows


def _short(found: Partial) -> Partial:
    """The value as a decimal where it is a function of decimals, which no one reads as such: 2.36 for e^0.8585…."""
    value = found.value
    long = value.is_number and not value.is_Rational and any(each.q > LONG for each in value.atoms(sp.Rational))
    return replace(found, value=sp.Float(value.evalf(DIGITS), DIGITS)) if long else found


def condition_of(residual: sp.Expr, names: Sequence[sp.Symbol]) -> Any:
    """Return for what names an expression is zero: True always, False never, else Eq(name, value) or Eq(…, 0).

    `names` are those that it is solved for, the first in which it is linear.
    """
    above, _ = sp.fraction(normal(residual), exact=True)
    factors = [f for f in sp.Mul.make_args(above) if not f.is_nonzero and not f.is_number]
    if above == 0:
        return sp.true
    if not factors or above.is_nonzero:
        return sp.false
    named = [f for f in factors if f.has(*names)] if names else []
    rest = sp.Mul(*(named or factors))  # what holds of the names whatever the parameters are
    for name in names:
        slope = partial(rest, name) if rest.has(name) else sp.S.Zero
        if slope != 0 and not slope.has(*names) and not slope.has(name):
            return sp.Eq(name, normal(name - rest / slope), evaluate=False)
    return sp.Eq(rest, 0, evaluate=False)
