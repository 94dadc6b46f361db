"""arg x."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Undefined, Value
from solver.numeric.evaluation.walk import floored, on_the_cut, walk


def evaluate(environment: Environment, value: Any) -> Value:
    """The angle in radians, −π < arg x ≤ π; 0 has none."""
    x, arithmetic = walk(value, environment), environment.arithmetic
    if x.is_matrix:
        raise ShapeMismatch("the angle of a matrix")
    if np.any(arithmetic.size(x.value) == 0):
        raise Undefined("0 has no angle")
    angle = arithmetic.apply("arg", on_the_cut(x, arithmetic))
    return Value(angle, arithmetic.size(angle) + x.magnitude / floored(x, arithmetic))
