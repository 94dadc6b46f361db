"""A matrix drawn with lines."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, matrix: Any, _rows: Any, _columns: Any) -> Value:
    """M: the lines say nothing about its value."""
    return walk(matrix, environment)
