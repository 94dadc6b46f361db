"""Derivatives with respect to time by the chain rule."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from solver.exact.modelling.derivatives import partial


def time_derivative(expression: sp.Expr, following: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """d/dt of an expression in functions of time: ∂e/∂q · q' summed; `following` has q' for each q."""
    symbols = expression.free_symbols
    return sp.Add(*(partial(expression, q) * following[q] for q in following if q in symbols))
