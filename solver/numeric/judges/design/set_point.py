"""Set points and gains of a reference judged by the equations of rest, whichever of several solutions was chosen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import evaluate, value_of
from solver.numeric.evaluation.multiple_precision import remainder
from solver.numeric.evaluation.points import admissible, free_symbols, holds_decimals
from solver.numeric.evaluation.values import ShapeMismatch, Undefined
from solver.numeric.judges.design.tracking import MANY, NOTHING, least_squares
from solver.numeric.judges.optimal.refined import refined
from solver.numeric.judges.optimal.regulator import Weights, optima
from solver.words import Phrase

Condition = tuple[Any, Any]
"""Rows L and a value V with L [F; N] = V."""


def set_point_residual(M: Any, p: int, conditions: Sequence[Condition]) -> float:
    """Return the least relative residual of M X = [0; I] and L X = V over X = [F; N], all conditions (L, V) together.

    M is [[A, B], [C, D]] (discrete: A − I) with p outputs. Zero if the values given are part of one set point.
    """
    symbols = free_symbols(M).union(*(free_symbols(L) | free_symbols(V) for L, V in conditions))
    points = admissible(symbols, 2)
    exact = not holds_decimals([M, conditions])
    worst = 0.0
    for point in points:
        pairs = [(_at(L, point, exact=exact), _at(V, point, exact=exact)) for L, V in conditions]
        worst = worst_of((worst, _gap(_at(M, point, exact=exact), p, pairs)))
    return with_many_digits(worst, M, conditions)


def reference_residual_at_optimum(weights: Weights, M: Any, p: int, K_o: Any) -> float:
    """Return the least relative residual of M X = [0; I] and [K, I] X = K_o with scipy's optimal K."""
    identity = np.eye(weights.B.cols, dtype=int)
    worst, exact = 0.0, not holds_decimals([*weights, M, K_o])
    for optimum in optima(weights, (M, K_o)):
        K = refined(weights, optimum).K if exact else optimum.K
        pair = np.hstack([K, identity]), _at(K_o, optimum.point, exact=exact)
        worst = worst_of((worst, _gap(_at(M, optimum.point, exact=exact), p, [pair])))
    return with_many_digits(worst, *weights, M, K_o)


def _at(matrix: Any, point: Any, *, exact: bool) -> Array:
    """Return the values, with 50 digits where all is exact; nan where there are none."""
    listed = matrix if hasattr(matrix, "shape") else sp.ImmutableMatrix([[matrix]])
    try:
        if exact:
            found = value_of(listed, Environment.at([dict(point)], MANY))
            return np.asarray(np.broadcast_to(found.value, (1, *listed.shape))[0])
        return np.asarray(evaluate(listed, point))
    except Undefined:
        return np.full(listed.shape, np.nan)


def _gap(M: Array, p: int, conditions: Sequence[tuple[Array, Array]]) -> float:
    target = np.vstack([np.zeros((M.shape[0] - p, p), dtype=int), np.eye(p, dtype=int)])
    for L, V in conditions:
        if V.shape != (L.shape[0], p):
            raise ShapeMismatch(Phrase("it must be {rows}×{columns}", rows=L.shape[0], columns=p))
        if not np.all(np.isfinite(V.astype(complex))):
            return float("inf")
    stacked = np.vstack([M, *(L for L, _ in conditions)])
    target = np.vstack([target, *(V for _, V in conditions)])
    if stacked.dtype == object:
        left = remainder(stacked, MANY.array(target), MANY.context, NOTHING)
        return float(max(map(abs, left.ravel())) / max(1, *map(abs, target.ravel())))
    X = least_squares(stacked, target, rcond=1e-13)
    size = np.abs(stacked) @ np.abs(X) + np.abs(target)
    return float(np.max(np.abs(stacked @ X - target), initial=0.0) / np.max(size, initial=1e-300))
