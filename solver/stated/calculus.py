"""Derivatives, integrals, sums over an index and values at a point."""

from __future__ import annotations

from typing import Any

from solver.formula.pieces import as_factor
from solver.stated.declaration import Binding, Show, Stated, operation


def derivative(function: Any, variable: Any, order: int = 1) -> Stated:
    """dᵐf/dxᵐ."""
    return Stated("derivative", (function, variable, order))


def integral(integrand: Any, variable: Any, lower: Any, upper: Any) -> Stated:
    """∫ f dx from `lower` to `upper`."""
    return Stated("integral", (integrand, variable, lower, upper))


def summation(term: Any, index: Any, lower: Any, upper: Any) -> Stated:
    """Σ T(i) for i from `lower` to `upper`, whole numbers."""
    return Stated("summation", (term, index, lower, upper))


def value_at(function: Any, variable: Any, value: Any) -> Stated:
    """f(x) at x = `value`."""
    return Stated("value_at", (function, variable, value))


@operation(derivative)
def _derivative(show: Show, function: Any, variable: Any, order: Any = 1) -> str:
    x = show(variable)
    if order == 0:
        return show(function)
    times = f"^{{{order}}}" if order != 1 else ""
    argument = as_factor(show(function))
    return rf"\frac{{d{times}}}{{d{x}{times}}}{argument}"


@operation(integral, binding=Binding(1))
def _integral(show: Show, integrand: Any, variable: Any, lower: Any, upper: Any) -> str:
    return rf"\int_{{{show(lower)}}}^{{{show(upper)}}}{as_factor(show(integrand))}\,d{show(variable)}"


@operation(summation, binding=Binding(1), whole=(2, 3))
def _summation(show: Show, term: Any, index: Any, lower: Any, upper: Any) -> str:
    return rf"\sum_{{{show(index)} = {show(lower)}}}^{{{show(upper)}}}{as_factor(show(term))}"


@operation(value_at, binding=Binding(1))
def _value_at(show: Show, function: Any, variable: Any, value: Any) -> str:
    return rf"\left.{as_factor(show(function))}\right|_{{{show(variable)} = {show(value)}}}"
