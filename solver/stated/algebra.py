"""Sums, products, quotients and powers, of scalars and of matrices."""

from __future__ import annotations

from typing import Any

from solver.formula.building import (
    as_factor,
    is_negative,
    is_sum,
    joined,
    over,
    parenthesized,
    row,
    summed,
    walk,
    without_sign,
)
from solver.formula.building import (
    power as raised,
)
from solver.formula.nodes import Fenced, Row, Scripts, Table
from solver.lazy import sympy as sp
from solver.stated.declaration import Show, Stated, operation


def product(*factors: Any) -> Stated:
    """F₁ F₂ … in the order written; factors are scalars or matrices of fitting shapes."""
    return Stated("product", factors)


def total(*terms: Any) -> Stated:
    """T₁ + T₂ + … in the order written."""
    return Stated("total", terms)


def difference(left: Any, right: Any) -> Stated:
    """L − R."""
    return Stated("difference", (left, right))


def quotient(numerator: Any, denominator: Any) -> Stated:
    """A fraction; the numerator may be a matrix, the denominator is a scalar."""
    return Stated("quotient", (numerator, denominator))


def power(base: Any, exponent: Any) -> Stated:
    """Bᵏ; a square matrix takes an integer exponent."""
    return Stated("power", (base, exponent))


def exponential(exponent: Any) -> Stated:
    """e^X of a scalar or of a square matrix."""
    return Stated("exponential", (exponent,))


@operation(product)
def _product(show: Show, *factors: Any) -> Row:
    shown = [each for factor in factors if (each := show(factor)) != row("1")]
    if not shown:
        return row("1")
    first, *others = shown
    if not others:
        return first
    rest = [as_factor(factor) for factor in others]
    if first == row("-1"):
        return row("-", joined(rest))
    alone = is_negative(first) and not is_sum(without_sign(first)) and not _begins_with_minus(rest[0])
    return joined([first if alone else as_factor(first), *rest])


def _begins_with_minus(factor: Row) -> bool:
    """Whether a factor is a bracket that begins with a minus."""
    first = factor.items[0]
    return isinstance(first, Fenced) and is_negative(first.body)


def _is_number(operand: Any, number: int) -> bool:
    return isinstance(operand, int | sp.Integer) and bool(operand == number)


@operation(total)
def _total(show: Show, *terms: Any) -> Row:
    return summed([show(term) for term in terms if not _is_number(term, 0)])


@operation(difference)
def _difference(show: Show, left: Any, right: Any) -> Row:
    return row(show(left), "-", as_factor(show(right)))


@operation(quotient)
def _quotient(show: Show, numerator: Any, denominator: Any) -> Row:
    above, below = show(numerator), show(denominator)
    if below == row("1"):
        return above
    if is_negative(above) and not is_sum(without_sign(above)):
        return row("-", _quotient(lambda part: part, without_sign(above), below))
    if is_negative(below) and not is_sum(without_sign(below)):
        return row("-", as_factor(_quotient(lambda part: part, above, without_sign(below))))
    if any(isinstance(node, Table) for node in walk(above)):  # too high for a numerator
        return row(over(row("1"), below), as_factor(above))
    return over(above, below)


@operation(power)
def _power(show: Show, base: Any, exponent: Any) -> Row:
    if exponent == 1:
        return show(base)
    if exponent == 0 and isinstance(base, sp.Symbol) and base.name[0].isupper():
        return row("I")  # a capital stands for a matrix
    return raised(show(base), show(exponent))


@operation(exponential)
def _exponential(show: Show, exponent: Any) -> Row:
    shown = show(exponent)
    if any(isinstance(node, Table) for node in walk(shown)):
        return row(r"\exp", parenthesized(shown))
    if not isinstance(exponent, sp.Expr):
        return raised(row("e"), shown)
    whole = show(sp.exp(exponent, evaluate=False))
    in_decimals = exponent.is_number and not any(isinstance(node, Scripts) for node in walk(whole))
    return raised(row("e"), shown) if in_decimals else whole
