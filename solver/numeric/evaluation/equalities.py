"""Whether two formulas are equal at given points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.numeric.evaluation.arithmetic import Arithmetic
from solver.numeric.evaluation.compare import Point, worst_residual
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.precision import precision_of
from solver.numeric.evaluation.values import ShapeMismatch, Undefined, Value


def equality_residual(left: Any, right: Any, points: Sequence[Point]) -> float:
    """Return the largest residual of left = right at given points; infinite where a side is undefined or misshapen."""

    def sides(some: Sequence[Point], arithmetic: Arithmetic) -> tuple[Value, Value]:
        environment = Environment.at(some, arithmetic)
        return value_of(left, environment), value_of(right, environment)

    try:
        return worst_residual(sides, points, precision_of(left, right))[0]
    except (ShapeMismatch, Undefined):
        return float("inf")
