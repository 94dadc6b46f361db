"""Σ T(x) over a list."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.combining import add, joined
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import value_at
from solver.numeric.evaluation.values import Undefined, Value


def evaluate(environment: Environment, term: Any, variable: Any, values: tuple[Any, ...]) -> Value:
    """T at each value, added up in the order written."""
    if not values:
        raise Undefined("a sum over nothing")
    return joined(add, (value_at.evaluate(environment, term, variable, value) for value in values))
