"""A minor with its sign."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import minor
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value

ORACLE = Oracle(30, "numpy.linalg.det")

poles = poles_of_operands


def evaluate(environment: Environment, matrix: Any, row: int, column: int) -> Value:
    """(−1)^{i+j} times the minor."""
    value, magnitude = minor.evaluate(environment, matrix, row, column)
    return Value(value if (row + column) % 2 == 0 else -value, magnitude)
