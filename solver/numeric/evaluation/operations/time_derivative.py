"""df/dt along functions of time: f at q + ε q', differentiated by ε."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.contour import unit_roots
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations.derivative import ORACLE, SAMPLED, by_cauchy, points_on
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

__all__ = ["ORACLE", "SAMPLED", "evaluate"]


def evaluate(environment: Environment, function: Any, following: Any) -> Value:
    """df/dt by Cauchy's integral formula in ε; every q of `following` moves with the velocity that stands beside it."""
    moving = {q: environment.full(walk(rate, environment).value) for q, rate in following}
    return by_cauchy(environment, 1, lambda radius: _moved(environment, function, moving, radius))


def _moved(environment: Environment, function: Any, moving: dict[Any, Any], radius: float) -> Value:
    arithmetic = environment.arithmetic
    count = points_on(arithmetic)
    steps = arithmetic.rational(1, round(1 / radius)) * unit_roots(count, arithmetic)
    values = {each: np.repeat(environment.full(value), count) for each, value in environment.values.items()}
    for q, rate in moving.items():
        if q in values:
            values[q] = values[q] + (rate[:, None] * steps[None, :]).reshape(-1)
    return walk(function, Environment(values, environment.points * count, arithmetic))
