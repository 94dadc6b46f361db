"""F₁ F₂ …."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.combining import joined, multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of_operands, zeros_of
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ENTRYWISE = True


def evaluate(environment: Environment, *factors: Any) -> Value:
    """F₁ F₂ … from left to right."""
    arithmetic = environment.arithmetic
    if not factors:
        return Value(arithmetic.number(1), 1.0)
    first, *others = (walk(factor, environment) for factor in factors)
    first_factor = Value(first.value, lambda: first.magnitude + arithmetic.size(first.value))
    return joined(partial(multiply, arithmetic=arithmetic), (first_factor, *others))


poles = poles_of_operands


def zeros(operands: tuple[Any, ...], s: Any, point: Environment) -> Array:
    """The zeros of the factors."""
    return np.concatenate([zeros_of(factor, s, point) for factor in operands])
