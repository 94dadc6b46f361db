"""The angle of x in degrees."""

from __future__ import annotations

import math
from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import argument
from solver.numeric.evaluation.values import Value


def evaluate(environment: Environment, value: Any) -> Value:
    """180°/π times arg x."""
    angle, magnitude = argument.evaluate(environment, value)
    degrees = 180 / environment.arithmetic.constant("pi")
    return Value(angle * degrees, magnitude * (180 / math.pi))
