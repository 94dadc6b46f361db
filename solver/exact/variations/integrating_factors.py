"""Linear equations of first order, x' + p(t) x = q(t), by the integrating factor e^{∫p dt}."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.variations.linear_forms import LinearForm
from solver.exact.variations.table_of_integrals import table_integral


@dataclass(frozen=True)
class IntegratingFactor:
    """∫p dt, e to this power, that times the right side, and the integral of it."""

    exponent: sp.Expr
    factor: sp.Expr
    right: sp.Expr
    integral: sp.Expr


def integrating_factor(form: LinearForm, t: sp.Symbol) -> IntegratingFactor | None:
    """The factor of x' + p x = q; None where the table lacks an integral."""
    exponent = table_integral(form.coefficients[0], t)
    if exponent is None:
        return None
    factor = sp.exp(exponent)
    if exponent.has(sp.log):
        factor = sp.powsimp(sp.expand(factor, power_exp=True)) if exponent.is_Add else factor
    right = sp.expand(factor * form.right)
    integral = table_integral(right, t)
    return None if integral is None else IntegratingFactor(exponent, factor, right, integral)
