"""Π F(x) over a list."""

from __future__ import annotations

from functools import partial
from typing import Any

from solver.numeric.evaluation.combining import joined, multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import value_at
from solver.numeric.evaluation.values import Undefined, Value


def evaluate(environment: Environment, factor: Any, variable: Any, values: tuple[Any, ...]) -> Value:
    """F at each value, multiplied in the order written."""
    if not values:
        raise Undefined("a product over nothing")
    factors = (value_at.evaluate(environment, factor, variable, value) for value in values)
    return joined(partial(multiply, arithmetic=environment.arithmetic), factors)
