"""Im x."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, value: Any) -> Value:
    """Entry by entry; no part is less exact than the whole."""
    x = walk(value, environment)
    return Value(environment.arithmetic.apply("im", x.value), x.magnitude)
