"""`Stated` formulas as LaTeX: as a person writes them down before carrying them out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from solver.derivation.stated import Stated
from solver.render.pieces import as_base, as_factor, is_sum, joined, parenthesized, summed

Print = Callable[[Any], str]
"""Prints an operand: an expression, a matrix, a number or a further formula."""


def stated_tex(formula: Stated, show: Print) -> str:
    """Return a formula as LaTeX. Raises KeyError for an operation that has no notation here."""
    return NOTATION[formula.operation](show, *formula.operands)


def _named(operator: str) -> Callable[[Print, Any], str]:
    """An operator before a matrix: `det [..]`, `adj(..)`."""

    def write(show: Print, operand: Any) -> str:
        return f"{operator}{_argument(show(operand))}"

    return write


def _argument(tex: str) -> str:
    return tex if _is_matrix(tex) else parenthesized(tex)


def _is_matrix(tex: str) -> bool:
    return as_base(tex) == tex and tex.startswith(r"\begin")


def _partitioned(show: Print, matrix: Any, rows: Any, columns: Any) -> str:
    """Return the matrix with lines; those at its edges are left out, and brackets alone need no array."""
    whole = show(matrix)
    body = whole.removeprefix(r"\begin{bmatrix}").removesuffix(r"\end{bmatrix}")
    across = {i for i in rows if 0 < i < matrix.rows}
    letters = "".join("c|" if 0 < j < matrix.cols and j in columns else "c" for j in range(1, matrix.cols + 1))
    if body == whole or not (across or "|" in letters):
        return whole
    lines = body.split(r" \\ ")
    ruled = r" \\ ".join(rf"\hline {line}" if i in across else line for i, line in enumerate(lines))
    return rf"\left[\begin{{array}}{{{letters}}}{ruled}\end{{array}}\right]"


def _inverse(show: Print, matrix: Any) -> str:
    return f"{as_base(show(matrix))}^{{-1}}"


def _transpose(show: Print, matrix: Any) -> str:
    return f"{as_base(show(matrix))}^{{T}}"


def _product(show: Print, *factors: Any) -> str:
    shown = [show(factor) for factor in factors if not _is_one(factor)]
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


def _is_one(factor: Any) -> bool:
    return isinstance(factor, int | sp.Integer) and factor == 1


def _total(show: Print, *terms: Any) -> str:
    return summed([show(term) for term in terms if not _is_zero(term)])


def _is_zero(term: Any) -> bool:
    return isinstance(term, int | sp.Integer) and term == 0


def _difference(show: Print, left: Any, right: Any) -> str:
    return f"{show(left)} - {as_factor(show(right))}"


def _quotient(show: Print, numerator: Any, denominator: Any) -> str:
    above, below = show(numerator), show(denominator)
    if below == "1":
        return above
    sign = ""
    if above.startswith("-") and not is_sum(above[1:]):
        sign, above = "-", above[1:]
    if r"\begin{bmatrix}" in above:  # too high for a numerator
        return rf"{sign}\frac{{1}}{{{below}}}{as_factor(above)}"
    return rf"{sign}\frac{{{above}}}{{{below}}}"


def _power(show: Print, base: Any, exponent: Any) -> str:
    if exponent == 1:
        return show(base)
    if exponent == 0 and isinstance(base, sp.Symbol) and base.name[0].isupper():
        return "I"  # a capital stands for a matrix
    return f"{as_base(show(base))}^{{{show(exponent)}}}"


def _exponential(show: Print, exponent: Any) -> str:
    tex = show(exponent)
    if r"\begin" in tex:
        return rf"\exp{parenthesized(tex)}"
    return show(sp.exp(exponent, evaluate=False)) if isinstance(exponent, sp.Expr) else f"e^{{{tex}}}"


def _transformed(letter: str) -> Callable[..., str]:
    def write(show: Print, image: Any, *_variables: Any) -> str:
        return rf"\mathcal{{{letter}}}^{{-1}}\left\{{{show(image)}\right\}}"

    return write


def _derivative(show: Print, function: Any, variable: Any, order: Any = 1) -> str:
    x = show(variable)
    if order == 0:
        return show(function)
    times = f"^{{{order}}}" if order != 1 else ""
    argument = as_factor(show(function))
    return rf"\frac{{d{times}}}{{d{x}{times}}}{argument}"


def _integral(show: Print, integrand: Any, variable: Any, lower: Any, upper: Any) -> str:
    return rf"\int_{{{show(lower)}}}^{{{show(upper)}}}{as_factor(show(integrand))}\,d{show(variable)}"


def _summation(show: Print, term: Any, index: Any, lower: Any, upper: Any) -> str:
    return rf"\sum_{{{show(index)} = {show(lower)}}}^{{{show(upper)}}}{as_factor(show(term))}"


def _value_at(show: Print, function: Any, variable: Any, value: Any) -> str:
    return rf"\left.{as_factor(show(function))}\right|_{{{show(variable)} = {show(value)}}}"


NOTATION: dict[str, Callable[..., str]] = {
    "determinant": _named(r"\det"),
    "adjugate": _named(r"\operatorname{adj}"),
    "partitioned": _partitioned,
    "rank": _named(r"\operatorname{rank}"),
    "trace": _named(r"\operatorname{tr}"),
    "inverse": _inverse,
    "transpose": _transpose,
    "product": _product,
    "total": _total,
    "difference": _difference,
    "quotient": _quotient,
    "power": _power,
    "exponential": _exponential,
    "inverse_laplace": _transformed("L"),
    "inverse_z": _transformed("Z"),
    "derivative": _derivative,
    "integral": _integral,
    "value_at": _value_at,
    "summation": _summation,
}
"""One function for each operation of `solver.derivation.stated`; a test compares the two."""
