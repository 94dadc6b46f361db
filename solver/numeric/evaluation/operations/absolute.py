"""|x|."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, value: Any) -> Value:
    """|x| of a scalar."""
    x = walk(value, environment)
    if x.is_matrix:
        raise ShapeMismatch("the absolute value of a matrix")
    return Value(abs(x.value) + 0 * x.value, x.magnitude)
