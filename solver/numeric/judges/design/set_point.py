"""Set points and gains of a reference judged by the equations of rest, whichever of several solutions was chosen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import ShapeMismatch, Undefined
from solver.numeric.judges.design.tracking import least_squares
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
    return worst_of(_gap(_at(M, point), p, [(_at(L, point), _at(V, point)) for L, V in conditions]) for point in points)


def reference_residual_at_optimum(weights: Weights, M: Any, p: int, K_o: Any) -> float:
    """Return the least relative residual of M X = [0; I] and [K, I] X = K_o with scipy's optimal K."""
    identity = np.eye(weights.B.cols)
    return worst_of(
        _gap(_at(M, optimum.point), p, [(np.hstack([optimum.K, identity]), _at(K_o, optimum.point))])
        for optimum in optima(weights, (M, K_o))
    )


def _at(matrix: Any, point: Any) -> Array:
    """Return the values, nan where there are none."""
    listed = matrix if hasattr(matrix, "shape") else sp.ImmutableMatrix([[matrix]])
    try:
        return np.asarray(evaluate(listed, point))
    except Undefined:
        return np.full(listed.shape, np.nan)


def _gap(M: Array, p: int, conditions: Sequence[tuple[Array, Array]]) -> float:
    target = np.vstack([np.zeros((M.shape[0] - p, p)), np.eye(p)])
    for L, V in conditions:
        if V.shape != (L.shape[0], p):
            raise ShapeMismatch(Phrase("it must be {rows}×{columns}", rows=L.shape[0], columns=p))
        if not np.all(np.isfinite(V)):
            return float("inf")
    stacked = np.vstack([M, *(L for L, _ in conditions)])
    target = np.vstack([target, *(V for _, V in conditions)])
    X = least_squares(stacked, target, rcond=1e-13)
    size = np.abs(stacked) @ np.abs(X) + np.abs(target)
    return float(np.max(np.abs(stacked @ X - target), initial=0.0) / np.max(size, initial=1e-300))
