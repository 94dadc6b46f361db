"""f(x) at a value of x."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, function: Any, variable: Any, value: Any) -> Value:
    """F(x) at x = value. Where x is a decimal, it is known to its own digits only, and F as far as it moves with x."""
    x, arithmetic = walk(value, environment), environment.arithmetic
    found = walk(function, environment.having({variable: x.value}))
    unsure = np.broadcast_to(np.asarray(x.magnitude - 4 * arithmetic.size(x.value), dtype=float), environment.points)
    if arithmetic is DOUBLE or not np.any(unsure > 0):
        return found
    shift = arithmetic.array(np.maximum(unsure, 0.0) * arithmetic.eps)
    moved = walk(function, environment.having({variable: x.value + shift}))
    return Value(found.value, found.magnitude + arithmetic.size(moved.value - found.value) / arithmetic.eps)
