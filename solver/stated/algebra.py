"""Sums, products, quotients and powers, of scalars and of matrices."""

from __future__ import annotations

from typing import Any

from solver.formula.pieces import as_base, as_factor, is_sum, joined, parenthesized, summed
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
def _product(show: Show, *factors: Any) -> str:
    shown = [show(factor) for factor in factors if not _is_number(factor, 1)]
    if not shown:
        return "1"
    first, *others = shown
    if not others:
        return first
    if first == "-1":
        return f"-{joined([as_factor(factor) for factor in others])}"
    rest = [as_factor(factor) for factor in others]
    alone = first.startswith("-") and not is_sum(first[1:]) and not rest[0].startswith(("(-", r"\left(-"))
    return joined([first if alone else as_factor(first), *rest])


def _is_number(operand: Any, number: int) -> bool:
    return isinstance(operand, int | sp.Integer) and bool(operand == number)


@operation(total)
def _total(show: Show, *terms: Any) -> str:
    return summed([show(term) for term in terms if not _is_number(term, 0)])


@operation(difference)
def _difference(show: Show, left: Any, right: Any) -> str:
    return f"{show(left)} - {as_factor(show(right))}"


@operation(quotient)
def _quotient(show: Show, numerator: Any, denominator: Any) -> str:
    above, below = show(numerator), show(denominator)
    if below == "1":
        return above
    sign = ""
    if above.startswith("-") and not is_sum(above[1:]):
        sign, above = "-", above[1:]
    if r"\begin{bmatrix}" in above:  # too high for a numerator
        return rf"{sign}\frac{{1}}{{{below}}}{as_factor(above)}"
    return rf"{sign}\frac{{{above}}}{{{below}}}"


@operation(power)
def _power(show: Show, base: Any, exponent: Any) -> str:
    if exponent == 1:
        return show(base)
    if exponent == 0 and isinstance(base, sp.Symbol) and base.name[0].isupper():
        return "I"  # a capital stands for a matrix
    return f"{as_base(show(base))}^{{{show(exponent)}}}"


@operation(exponential)
def _exponential(show: Show, exponent: Any) -> str:
    tex = show(exponent)
    if r"\begin" in tex:
        return rf"\exp{parenthesized(tex)}"
    return show(sp.exp(exponent, evaluate=False)) if isinstance(exponent, sp.Expr) else f"e^{{{tex}}}"
