"""Formulas of scalars as expressions."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import sympy as sp

from solver.displayed.tree import Unreadable
from solver.stated import Stated
from solver.words import Phrase

FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    **{"sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "sinh": sp.sinh, "cosh": sp.cosh, "log": sp.log},
    **{"acos": sp.acos, "atan": sp.atan, "re": sp.re, "im": sp.im, "abs": sp.Abs, "sqrt": sp.sqrt},
}
_CARRIED_OUT: dict[str, Callable[..., Any]] = {
    **{"product": sp.Mul, "total": sp.Add, "power": sp.Pow, "exponential": sp.exp},
    **{"difference": operator.sub, "quotient": operator.truediv},
}


def plain(formula: Any) -> Any:
    """Return a scalar formula as an expression, where it is made of numbers and products only."""
    if not isinstance(formula, Stated):
        return formula
    if formula.operation not in _CARRIED_OUT:
        raise Unreadable(Phrase("the operation {name} in this place", name=formula.operation))
    return _CARRIED_OUT[formula.operation](*map(plain, formula.operands))
