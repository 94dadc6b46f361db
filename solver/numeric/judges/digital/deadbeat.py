"""Motions that are dead after a number of steps."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

from solver.numeric.evaluation.compare import Residual, worst_of
from solver.numeric.evaluation.points import holds_decimals
from solver.numeric.evaluation.precision import EXACT, TOLERANCE
from solver.numeric.evaluation.ranks import rank
from solver.numeric.judges.design.placement import rational_points

DIGITS = 60


def fewest_steps(A: Any, B: Any) -> int | None:
    """Return the least ν with im A^ν in the range of [B, AB, …, A^{ν−1}B], None if there is none (A n×n, B n×m)."""
    return next((steps for steps in range(A.rows + 1) if states_at_rest(A, B, steps) == A.rows), None)


def states_at_rest(A: Any, B: Any, steps: int) -> int:
    """Return the dimension of {x : A^ν x in the range of [B, AB, …, A^{ν−1}B]}."""
    reached, power = sp.ImmutableMatrix(sp.zeros(A.rows, 0)), sp.ImmutableMatrix(sp.eye(A.rows))
    for _ in range(steps):
        reached, power = sp.ImmutableMatrix(reached.row_join(power * B)), sp.ImmutableMatrix(A * power)
    return int(A.rows) - rank(sp.ImmutableMatrix(reached.row_join(power))) + rank(reached)


def remaining(loop: Any, steps: int) -> float:
    """Return the largest entry of the power of a loop (n×n), relative to that power of its own largest one."""
    worst = 0.0
    for point in rational_points(loop):
        with mpmath.workdps(DIGITS):
            M = mpmath.matrix(sp.Matrix(loop.subs(point)).evalf(DIGITS).tolist())
            left = M**steps if steps else mpmath.eye(loop.rows)
            size = max(mpmath.mpf(1), *map(abs, M)) ** steps
            worst = worst_of((worst, float(max(map(abs, left)) / size)))
    return Residual(worst, TOLERANCE if holds_decimals([loop]) else EXACT.tolerance)
