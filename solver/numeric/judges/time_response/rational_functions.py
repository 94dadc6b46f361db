"""Is F = f(A) for a rational function f of a matrix of rational numbers? Judged in fractions, without any rounding."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.multiple_precision import inverse


def is_rational(A: Any, function: Any, variable: Any, F: Any) -> bool:
    """Whether all is rational, so that it can be judged without rounding."""
    numbers = all(entry.is_Rational for M in (A, F) for entry in M.flat())
    return bool(numbers and function.is_rational_function(variable) and function.free_symbols <= {variable})


def equals_in_fractions(A: Any, function: Any, variable: Any, F: Any) -> bool:
    """Whether F is f(A), entry by entry."""
    return bool(np.all(_walk(function, variable, _fractions(A)) == _fractions(F)))


def _fractions(M: Any) -> Array:
    flat = [_fraction(entry) for entry in M.flat()]
    return np.array(flat, dtype=object).reshape(M.shape)


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.p), int(number.q))


def _walk(function: Any, variable: Any, A: Array) -> Array:
    """Return the function with the matrix in place of its variable; a number is a multiple of I."""
    if function == variable:
        return A
    if function.is_Rational:
        return _one(A) * _fraction(function)
    if function.is_Pow:
        base, order = _walk(function.base, variable, A), int(function.exp)
        return _whole(base if order >= 0 else inverse(base), abs(order))
    parts = [_walk(part, variable, A) for part in function.args]
    found = parts[0]
    for part in parts[1:]:
        found = found + part if function.is_Add else found @ part
    return found


def _one(A: Array) -> Array:
    n = len(A)
    return np.array([[Fraction(int(i == j)) for j in range(n)] for i in range(n)], dtype=object)


def _whole(B: Array, order: int) -> Array:
    found = _one(B)
    while order:
        found, B, order = found @ B if order % 2 else found, B @ B, order // 2
    return found
