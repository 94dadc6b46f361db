"""Π F(i) over whole numbers i."""

from __future__ import annotations

from functools import partial
from typing import Any

from solver.numeric.evaluation.combining import multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.indices import accumulated
from solver.numeric.evaluation.values import Value


def evaluate(environment: Environment, factor: Any, index: Any, lower: Any, upper: Any) -> Value:
    """The factors from left to right at each point; an empty product has no value here."""
    multiplied = partial(multiply, arithmetic=environment.arithmetic)
    return accumulated(environment, factor, index, (lower, upper), multiplied)
