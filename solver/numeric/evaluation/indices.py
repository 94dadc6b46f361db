"""Operations whose index goes through whole numbers, which may be others at each point."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from solver.numeric.evaluation.combining import joined
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Undefined, Value
from solver.numeric.evaluation.walk import walk

MOST_TERMS = 200


def at_each_point(
    environment: Environment, limits: tuple[Any, Any], found: Callable[[Environment, int, int], Value]
) -> Value:
    """Return what is found at each point alone from the two limits there.

    Raises Undefined where a limit is no whole number, or the first is above the second, or far below it.
    """
    first, last = (_whole(environment, limit) for limit in limits)
    if any(b < a or b - a > MOST_TERMS for a, b in zip(first, last, strict=True)):
        raise Undefined("no terms, or too many of them")
    each = [found(_alone(environment, p), a, b) for p, (a, b) in enumerate(zip(first, last, strict=True))]
    values, magnitudes = (
        np.stack([np.reshape(part, np.shape(part)[1:]) for part in parts]) for parts in zip(*each, strict=True)
    )
    return Value(values, magnitudes)


def _whole(environment: Environment, limit: Any) -> list[int]:
    values = np.asarray(environment.arithmetic.approximate(environment.full(walk(limit, environment).value)))
    if np.any(np.abs(values - np.round(values.real)) > 1e-9):
        raise Undefined("an index that is not whole")
    return [round(float(each.real)) for each in values]


def _alone(environment: Environment, p: int) -> Environment:
    """Return the environment of one of the points."""
    point = {symbol: environment.full(value)[p : p + 1] for symbol, value in environment.values.items()}
    return Environment(point, 1, environment.arithmetic)


def accumulated(
    environment: Environment,
    operand: Any,
    index: Any,
    limits: tuple[Any, Any],
    join: Callable[[Value, Value], Value],
) -> Value:
    """Return the operand at i = lower … upper, joined from left to right."""

    def at(here: Environment, lower: int, upper: int) -> Value:
        return joined(join, (walk(operand, here.having({index: i})) for i in range(lower, upper + 1)))

    return at_each_point(environment, limits, at)
