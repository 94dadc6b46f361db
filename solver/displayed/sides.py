"""What can stand on a side of a chain, beside what is written: values, lists, refusals."""

from __future__ import annotations

from math import log10
from operator import is_
from typing import Any

import sympy as sp

from solver.displayed.tree import Unreadable
from solver.lazy import numeric
from solver.stated import Stated

DIGITS = 30
"""No decimal is written with more places."""


def has_value(formula: Any) -> bool:
    """Whether a side of a chain has a value or formula to be evaluated."""
    return formula is not None and not isinstance(formula, Unreadable)


def frozen(value: Any) -> Any:
    """Return a value that can be looked up; some matrices of steps are mutable."""
    if isinstance(value, Stated):
        operands = tuple(map(frozen, value.operands))
        same = all(map(is_, operands, value.operands))
        return value if same else Stated(value.operation, operands)
    return sp.ImmutableMatrix(value) if isinstance(value, sp.MutableDenseMatrix) else value


def listed(value: Any) -> bool:
    """Whether a value is no formula: a list, a mapping, a text, a truth value."""
    return isinstance(value, list | tuple | dict | str | bool)


def half_unit(value: Any) -> float:
    """Return half a unit in the last digit of a decimal, relative to its size; no difference for other values."""
    if isinstance(value, sp.Float) and value != 0:
        return max(numeric.TOLERANCE, 10.0 ** (2 - value._prec * log10(2)) / 2)
    if not isinstance(value, int | sp.Rational) or value == 0:
        return float(numeric.TOLERANCE)
    places = next((d for d in range(DIGITS) if 10**d % sp.Rational(value).q == 0), None)
    return float(numeric.TOLERANCE) if places is None else 10.0**-places / 2 / abs(float(value))
