"""L − R."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.combining import add
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ENTRYWISE = True


def evaluate(environment: Environment, left: Any, right: Any) -> Value:
    """L − R."""
    subtrahend = walk(right, environment)
    return add(walk(left, environment), Value(-subtrahend.value, lambda: subtrahend.magnitude))


poles = poles_of_operands
