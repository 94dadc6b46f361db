"""The arctangent of x in degrees."""

from __future__ import annotations

import math
from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, value: Any) -> Value:
    """180°/π times arctan x of a real x, whose slope is 1 at most."""
    x, arithmetic = walk(value, environment), environment.arithmetic
    if x.is_matrix:
        raise ShapeMismatch("the arctangent of a matrix")
    degrees = 180 / arithmetic.constant("pi")
    angle = arithmetic.apply("atan", x.value)
    return Value(angle * degrees, (arithmetic.size(angle) + x.magnitude) * (180 / math.pi))
