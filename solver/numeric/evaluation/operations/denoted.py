"""A formula under its name."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, _name: str, formula: Any) -> Value:
    """The value of the formula."""
    return walk(formula, environment)
