"""Differential equations in one unknown as sums Σ cᵢ(t) x⁽ⁱ⁾ = f(t), where they are such.

The derivatives of the unknown are symbols of their own ("jets"): x, x', x'', … in this order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.signs import possible_signs


@dataclass(frozen=True)
class LinearForm:
    """Σ cᵢ x⁽ⁱ⁾ = `right`; `coefficients` c₀ … cₙ may hold t, and cₙ = 1."""

    coefficients: tuple[sp.Expr, ...]
    right: sp.Expr

    @property
    def order(self) -> int:
        """The order n of the equation."""
        return len(self.coefficients) - 1

    @property
    def lowest(self) -> int:
        """The order of the lowest derivative that occurs."""
        return next(i for i, c in enumerate(self.coefficients) if c != 0)

    def of(self, jets: Sequence[sp.Expr]) -> sp.Expr:
        """Σ cᵢ x⁽ⁱ⁾ with these values for x, x', …."""
        return sp.Add(*(c * jet for c, jet in zip(self.coefficients, jets, strict=False)))

    def is_constant(self, t: sp.Symbol) -> bool:
        """Whether the coefficients are free of t."""
        return not any(c.has(t) for c in self.coefficients)


def highest_jet(equation: sp.Expr, jets: Sequence[sp.Symbol]) -> int:
    """The order of the highest derivative in an expression; −1 if the unknown is not in it."""
    return max((i for i, jet in enumerate(jets) if equation.has(jet)), default=-1)


def factors_that_vanish(equation: sp.Expr, jets: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...]:
    """The factors with the unknown in them of the numerator of an equation, without those that have no zero."""
    moving = [factor for factor in sp.Mul.make_args(sp.factor(sp.numer(sp.together(equation)))) if factor.has(*jets)]
    bases = [factor.as_base_exp()[0] for factor in moving if not factor.as_base_exp()[1].could_extract_minus_sign()]
    return tuple(base for base in bases if 0 in possible_signs(base))


def linear_form(equation: sp.Expr, jets: Sequence[sp.Symbol]) -> LinearForm | None:
    """An expression that is zero as such a sum, divided by the coefficient of the highest derivative; None if none."""
    order = highest_jet(equation, jets)
    if order < 0:
        return None
    inside = list(jets[: order + 1])
    found = [sp.diff(equation, jet) for jet in inside]
    if any(c.has(*inside) for c in found) and any(sp.cancel(c).has(*inside) for c in found):
        return None
    coefficients = [tidy(sp.cancel(c)) if c.has(*inside) else c for c in found]
    right = -equation.subs(dict.fromkeys(inside, sp.S.Zero))
    if right.has(sp.nan, sp.zoo, sp.oo):
        return None
    lead = coefficients[-1]
    monic = tuple(_quotient(c, lead) for c in coefficients[:-1])
    return LinearForm((*monic, sp.S.One), _quotient(right, lead))


def _quotient(above: sp.Expr, below: sp.Expr) -> sp.Expr:
    """The quotient as a person writes it: term by term over a number, else cancelled."""
    if above == 0 or below == 1:
        return sp.expand(above)
    found = sp.expand(above / below)
    if below.is_number:
        return found
    cancelled = sp.cancel(above / below)
    return cancelled if sp.count_ops(cancelled) < sp.count_ops(found) else found
