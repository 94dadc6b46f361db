"""What the operations on a square matrix share: its values, the bound of its determinant, its inverse."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Undefined, Value, shape_of
from solver.numeric.evaluation.walk import walk
from solver.words import Phrase


def square(operand: Any, environment: Environment) -> Value:
    """Return the values of a square matrix, finite; a scalar stands for a matrix 1×1."""
    result = walk(operand, environment)
    if not result.is_matrix:
        result = environment.stack([result], (1, 1))
    rows, columns = shape_of(result)
    if rows != columns:
        raise ShapeMismatch(Phrase("a matrix {rows}×{columns} is not square", rows=rows, columns=columns))
    if environment.arithmetic is DOUBLE and not np.isfinite(result.value).all():
        raise Undefined("the matrix is not finite here")
    return result


def hadamard(magnitude: Array) -> Array:
    """Π of the norms of the rows: no determinant of a matrix of such entries is larger."""
    return np.asarray(np.prod(np.sqrt((magnitude**2).sum(axis=-1)), axis=-1))


def inverted(M: Value, arithmetic: Arithmetic) -> Value:
    """M⁻¹ with magnitude |M⁻¹| m |M⁻¹|, m the largest magnitude in M: elimination spreads rounding to zeros too."""
    value = arithmetic.inverse(M.value)

    def magnitude() -> Array:
        size = arithmetic.size(value)
        largest = M.magnitude.max(axis=(1, 2), keepdims=True)
        return np.asarray(size + largest * size.sum(axis=2, keepdims=True) * size.sum(axis=1, keepdims=True))

    return Value(value, magnitude)
