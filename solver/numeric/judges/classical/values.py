"""Gains judged: the transfer function itself near the origin, and the first Markov parameter that is not zero."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.values import Undefined
from solver.numeric.judges.representation.minimal import (
    MANY,
    NOTHING,
    numbers_at,
    points_of,
    quadruple_at,
    value_at_one,
)

NEAR = "1e-22"
LARGE = 1e12
"""Larger than this near the origin, and as much larger as the point is nearer, is infinite."""
BESIDE_ONE, LARGE_BESIDE_ONE = "1e-11", 1e5
"""The same beside one, where what is left of (z − 1)³ must be more than is rounded away."""
WRONG = float("inf")


def dc_gain_residual(G: Any, answer: Any, x: Any = None, where: int = 0) -> float:
    """Return the relative difference of an answer and of G (1×1, a matrix or a stated formula in x) near 0, or 1."""
    x = sp.Symbol("s") if x is None else x
    worst = 0.0
    infinite = answer in (sp.oo, -sp.oo)
    if answer is sp.nan or (answer.is_finite is False and not infinite):
        return WRONG
    for point in points_of(value_at_one(G, x), sp.Integer(0) if infinite else answer):
        try:
            beside, large = (BESIDE_ONE, LARGE_BESIDE_ONE) if infinite and where else (NEAR, LARGE)
            near, nearer = (
                _value(G, x, point, where + MANY.context.mpf(beside) * by) for by in (1, MANY.context.mpf("1e-3"))
            )
        except Undefined:
            return WRONG
        if infinite:
            right = near.real * (1 if answer == sp.oo else -1) > large and abs(nearer) > 100 * abs(near)
            worst = worst_of((worst, 0.0 if right else WRONG))
        else:
            value = numbers_at([answer], point)[0]
            worst = worst_of((worst, float(abs(near - value) / max(1, abs(near), abs(value)))))
    return with_many_digits(worst, G, answer)


def _value(G: Any, x: Any, point: Any, at: Any) -> Any:
    """G at a point of the real axis, just right of the one asked for."""
    found = value_of(G, Environment.at([{**dict(point), x: MANY.context.mpc(at)}], MANY)).value
    return found.reshape(-1)[0]


def leading_gain_residual(plant: Any, gain: Any) -> float:
    """Return the relative difference of a gain and the first of D, CB, CAB, … that is not zero (A, B, C, D numbers)."""
    worst = 0.0
    for point in points_of(plant, gain):
        A, B, C, D = quadruple_at(plant, point)
        size = max([MANY.context.mpf(1), *(abs(entry) for entry in A.reshape(-1))])
        found, column, scale = D.reshape(-1)[0], B, max(abs(entry) for entry in [*C.reshape(-1), *B.reshape(-1), 1])
        for _ in range(len(A)):
            if abs(found) > NOTHING * scale:
                break
            found, column, scale = (C @ column).reshape(-1)[0], A @ column, scale * size
        value = numbers_at([gain], point)[0]
        worst = worst_of((worst, float(abs(found - value) / max(abs(found), abs(value), MANY.context.mpf("1e-30")))))
    return with_many_digits(worst, *plant, gain)
