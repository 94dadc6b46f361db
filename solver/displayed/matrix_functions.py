"""Functions of a matrix as formulas that an oracle has rules for: parts, sines by exponentials, roots by squares."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import is_
from typing import Any

import sympy as sp

from solver.displayed.shapes import known, shape_of
from solver.lazy import numeric
from solver.matrices import identity
from solver.stated import Stated
from solver.stated.algebra import difference, exponential, power, product, total
from solver.stated.complex_numbers import imaginary_part, real_part
from solver.stated.matrices import inverse

INVERTED: dict[str, Callable[[Any], Stated]] = {"sqrt": lambda F: product(F, F), "log": exponential}
"""Functions that are known by those that undo them: F = √M says F F = M, but not which of several F it is."""


def _sine(X: Any) -> Stated:
    return product(-sp.I / 2, difference(exponential(product(sp.I, X)), exponential(product(-sp.I, X))))


def _cosine(X: Any) -> Stated:
    return product(sp.S.Half, total(exponential(product(sp.I, X)), exponential(product(-sp.I, X))))


BY_EXPONENTIALS: dict[str, Callable[[Any], Stated]] = {
    "sin": _sine,
    "cos": _cosine,
    "tan": lambda X: product(_sine(X), inverse(_cosine(X))),
    "sinh": lambda X: product(sp.S.Half, difference(exponential(X), exponential(product(-1, X)))),
    "cosh": lambda X: product(sp.S.Half, total(exponential(X), exponential(product(-1, X)))),
}


PARTS: dict[str, Callable[[Any], Stated]] = {"re": real_part, "im": imaginary_part}
"""Functions of a matrix of any shape, taken entry by entry."""


def function_of_matrix(name: str, X: Any) -> Stated | None:
    """Return the function of a matrix, a square one but for its parts, as a formula; None where it is not known."""
    if name in PARTS:
        return PARTS[name](X)
    if name in INVERTED:
        return Stated(name, (X,))
    return BY_EXPONENTIALS[name](X) if name in BY_EXPONENTIALS else None


def undone(left: Any, right: Any) -> tuple[Any, Any]:
    """Return what F = √M or F = log M says of F, in place of it: F F = M, e^F = M."""
    for formula, value in ((left, right), (right, left)):
        if isinstance(formula, Stated) and formula.operation in INVERTED:
            return INVERTED[formula.operation](value), formula.operands[0]
    return left, right


def is_left(formula: Any) -> bool:
    """Whether a root or logarithm of a matrix is left within a formula."""
    if not isinstance(formula, Stated):
        return False
    return formula.operation in INVERTED or any(map(is_left, formula.operands))


def with_matrices(value: Any, matrices: Mapping[str, Any]) -> Any:
    """Return a value with matrices in place of the symbols that stand for them, as in α₀ + α₁A, A¹⁰ and sin At.

    An expression with several of them is left as it is, since the order of factors is lost in it.
    """
    if isinstance(value, Stated):
        operands = tuple(with_matrices(each, matrices) for each in value.operands)
        same = all(map(is_, operands, value.operands))
        return value if same else Stated(value.operation, operands)
    if not isinstance(value, sp.Expr) or value.is_Number:
        return value
    inside: list[Any] = [symbol for symbol in numeric.free_symbols(value) if symbol.name in matrices]
    if len(inside) != 1:
        return value
    found = _written(value, inside[0], matrices[inside[0].name])
    return value if found is None else found


def _written(value: Any, symbol: Any, M: Any) -> Any:
    """A function of one matrix as a formula; None where it is not known."""
    if symbol not in value.free_symbols:
        return value
    if value == symbol:
        return M
    parts = [_written(each, symbol, M) for each in value.args]
    return None if any(each is None for each in parts) else _joined(value, parts, M)


def _joined(value: Any, parts: list[Any], M: Any) -> Any:
    """The formula of an expression from those of its arguments."""
    if isinstance(value, sp.Pow):
        base, exponent = parts
        halves = exponent.is_Rational and exponent.q == 2
        return Stated("sqrt", (power(base, exponent.p),)) if halves else power(base, exponent)
    if isinstance(value, sp.Mul):
        return product(*parts)
    if isinstance(value, sp.Add):
        unit = identity(known(shape_of(M))[0])
        return total(*(product(each, unit) if isinstance(each, sp.Expr) else each for each in parts))
    return exponential(*parts) if isinstance(value, sp.exp) else function_of_matrix(type(value).__name__, parts[0])
