"""Σ T(i) over whole numbers i."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.combining import add
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.indices import accumulated
from solver.numeric.evaluation.values import Value


def evaluate(environment: Environment, term: Any, index: Any, lower: Any, upper: Any) -> Value:
    """Added up one by one at each point; an empty sum has no shape, so there it has no value."""
    return accumulated(environment, term, index, (lower, upper), add)
