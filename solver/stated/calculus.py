"""Derivatives, integrals, convolutions and values at a point."""

from __future__ import annotations

from typing import Any

from solver.formula import read
from solver.formula.building import THIN_SPACE, as_factor, over, power, row
from solver.formula.nodes import Fenced, Operator, Row, Scripts
from solver.stated.declaration import Binding, Printer, Show, Stated, operation


def derivative(function: Any, variable: Any, order: int = 1) -> Stated:
    """dᵐf/dxᵐ."""
    return Stated("derivative", (function, variable, order))


def partial_derivative(function: Any, variable: Any, order: int = 1) -> Stated:
    """∂ᵐf/∂xᵐ; the variable may be an unknown function of time or a derivative of it: ∂L/∂q̇."""
    return Stated("partial_derivative", (function, variable, order))


def time_derivative(function: Any, following: Any) -> Stated:
    """df/dt of a function of symbols that vary with time: `following` has pairs (q, q'), (q', q''), ...."""
    return Stated("time_derivative", (function, tuple(following)))


def denoted(name: Any, formula: Any) -> Stated:
    """A formula that is shown by its name (LaTeX), as L in ∂L/∂q, or as it was stated, as ∂L/∂q' in its derivative."""
    return Stated("denoted", (name, formula))


def integral(integrand: Any, variable: Any, lower: Any, upper: Any) -> Stated:
    """∫ f dx from `lower` to `upper`."""
    return Stated("integral", (integrand, variable, lower, upper))


def convolution(left: Any, right: Any, time: Any) -> Stated:
    """(f ∗ g)(t) = ∫ f(τ) g(t − τ) dτ from 0 to t of two functions of t ≥ 0."""
    return Stated("convolution", (left, right, time))


def convolution_sum(left: Any, right: Any, step: Any) -> Stated:
    """(f ∗ g)(k) = Σ f(i) g(k − i) for i = 0 … k of two sequences of k = 0, 1, …."""
    return Stated("convolution_sum", (left, right, step))


def value_at(function: Any, variable: Any, value: Any) -> Stated:
    """f(x) at x = `value`."""
    return Stated("value_at", (function, variable, value))


def _derivative(sign: str) -> Printer:
    def write(show: Show, function: Any, variable: Any, order: Any = 1) -> Row:
        d, x = row(sign), show(variable)
        if order == 0:
            return show(function)
        times = row(str(order))
        by = row(d, x) if order == 1 else row(d, power(x, times))
        above = d if order == 1 else power(d, times)
        if isinstance(function, Stated) and function.operation == "denoted":
            return row(over(row(above, show(function)), by))
        return row(over(above, by), as_factor(show(function)))

    return write


operation(derivative)(_derivative("d"))
operation(partial_derivative)(_derivative(r"\partial"))


@operation(time_derivative)
def _time_derivative(show: Show, function: Any, _following: Any) -> Row:
    if isinstance(function, Stated) and function.operation == "denoted":
        if not isinstance(function.operands[0], str):
            return _time_derivative(show, function.operands[0], _following)
        return row(over(row("d", show(function)), row("d", "t")))
    shown = show(function)
    alone = isinstance(function, Stated) and function.operation in ("partial_derivative", "time_derivative")
    return row(over(row("d"), row("d", "t")), shown if alone else as_factor(shown))


@operation(denoted)
def _denoted(show: Show, name: Any, _formula: Any) -> Row:
    return read(name) if isinstance(name, str) else show(name)


@operation(integral, binding=Binding(1))
def _integral(show: Show, integrand: Any, variable: Any, lower: Any, upper: Any) -> Row:
    sign = Scripts(Operator(r"\int"), show(lower), show(upper))
    return row(sign, as_factor(show(integrand)), THIN_SPACE, "d", show(variable))


@operation(value_at, binding=Binding(1))
def _value_at(show: Show, function: Any, variable: Any, value: Any) -> Row:
    bar = Fenced(".", as_factor(show(function)), "|", tall=True)
    return row(Scripts(bar, row(show(variable), "=", show(value))))


def _convolution(show: Show, left: Any, right: Any, _variable: Any) -> Row:
    return row(as_factor(show(left)), r"\ast", as_factor(show(right)))


operation(convolution)(_convolution)
operation(convolution_sum, whole=(2,))(_convolution)
