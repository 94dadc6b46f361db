"""Time constants judged: by the eigenvalues of the part of the system that its transfer function shows."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.judges.representation.minimal import MANY, minimal_part, numbers_at, points_of, quadruple_at

ON_THE_AXIS = 1e-20
"""A real part that is so much smaller than the pole is zero."""


def shown_poles(plant: Any, point: Any) -> list[Any]:
    """Return the poles of C (xI − A)⁻¹ B + D at a point, with 50 digits."""
    A, B, C, _ = quadruple_at(plant, point)
    small, _, _ = minimal_part(A, B, C)
    return eigenvalues(small)


def eigenvalues(A: Array) -> list[Any]:
    """Return the eigenvalues of a matrix of numbers."""
    if not len(A):
        return []
    found, _ = MANY.context.eig(MANY.context.matrix(A.tolist()))
    return list(found)


def time_constants_residual(plant: Any, answer: Sequence[Any], period: Any = None) -> float:
    """Return the largest relative difference of the time constants and 1/|Re p| of the stable poles, in any order.

    In discrete time, where there is a period, p is (ln z)/T; of poles at z = 0 they are zero.
    """
    worst = 0.0
    for point in points_of(plant, answer, sp.Integer(1) if period is None else period):
        poles = shown_poles(plant, point)
        values = numbers_at(answer, point)
        if period is not None:
            at_once = sum(1 for p in poles if abs(p) < ON_THE_AXIS)
            if sum(1 for v in values if v == 0) != at_once:
                return float("inf")
            (T,), values = numbers_at([period], point), [v for v in values if v != 0]
            poles = [MANY.context.log(abs(p)) / T for p in poles if abs(p) >= ON_THE_AXIS]
        rates = [-MANY.context.re(p) for p in poles if MANY.context.re(p) < -ON_THE_AXIS * (1 + abs(p))]
        if len(values) != len(rates) or any(MANY.context.im(v) for v in values) or any(v == 0 for v in values):
            return float("inf")
        pairs = zip(sorted(rates), sorted(1 / MANY.context.re(v) for v in values), strict=True)
        worst = worst_of((worst, *(float(abs(a - b) / max(abs(a), abs(b))) for a, b in pairs)))
    return with_many_digits(worst, *plant, answer)
