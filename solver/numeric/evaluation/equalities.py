"""Whether two formulas are equal at given points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.numeric.evaluation.compare import worst_residual
from solver.numeric.evaluation.environment import Point
from solver.numeric.evaluation.precision import precision_of
from solver.numeric.evaluation.sides import Sides
from solver.numeric.evaluation.values import ShapeMismatch, Undefined


def equality_residual(left: Any, right: Any, points: Sequence[Point]) -> float:
    """Return the largest residual of left = right at given points; infinite where a side is undefined or misshapen."""
    try:
        return worst_residual(Sides(left, right), points, precision_of(left, right))[0]
    except (ShapeMismatch, Undefined):
        return float("inf")
