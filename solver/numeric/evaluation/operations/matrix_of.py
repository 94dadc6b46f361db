"""The matrix with entries that are formulas."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, columns: int, *entries: Any) -> Value:
    """Each entry in its place."""
    return environment.stack([walk(entry, environment) for entry in entries], (len(entries) // columns, columns))


poles = poles_of_operands
