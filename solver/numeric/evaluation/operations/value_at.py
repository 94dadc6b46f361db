"""f(x) at a value of x."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Value, shape_of
from solver.numeric.evaluation.walk import walk

ENTRYWISE = True


def evaluate(environment: Environment, function: Any, variable: Any, value: Any) -> Value:
    """F(x) at x = value. Where x is a decimal, it is known to its own digits only, and F as far as it moves with x."""
    x, arithmetic = _scalar(walk(value, environment)), environment.arithmetic
    found = walk(function, environment.having({variable: x.value}))
    unsure = np.broadcast_to(np.asarray(x.magnitude - 4 * arithmetic.size(x.value), dtype=float), environment.points)
    if arithmetic is DOUBLE or not np.any(unsure > 0):
        return found
    shift = arithmetic.array(np.maximum(unsure, 0.0) * arithmetic.eps)
    moved = walk(function, environment.having({variable: x.value + shift}))
    return Value(found.value, found.magnitude + arithmetic.size(moved.value - found.value) / arithmetic.eps)


def _scalar(x: Value) -> Value:
    """Return a value for a scalar variable; a 1×1 matrix is its entry. Raises ShapeMismatch."""
    shape = shape_of(x)
    if not shape:
        return x
    if shape != (1, 1):
        raise ShapeMismatch("a function of a scalar at a matrix")
    return Value(x.value[:, 0, 0], np.broadcast_to(x.magnitude, np.shape(x.value))[:, 0, 0])
