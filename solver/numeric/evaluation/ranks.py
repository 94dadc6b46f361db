"""Ranks and independence: singular values where they leave no doubt, orthogonalization with 50 digits where they do."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols

CLEAR = 1e-6
"""A smallest singular value (of columns of unit length) above this is not zero."""


def rank(M: Any) -> int:
    """Return the rank of M (exact or decimals), parameters at random values. Raises NotEvaluable."""
    if 0 in M.shape:
        return 0
    return max(rank_at(M, point) for point in admissible(free_symbols(M), 2))


def independent(V: Any) -> bool:
    """Whether the columns of V (n×k, exact or decimals, parameters at random values) are linearly independent.

    Raises NotEvaluable.
    """
    if V.cols == 0:
        return True
    if V.cols > V.rows:
        return False
    return all(rank_at(V, point) == V.cols for point in admissible(free_symbols(V), 2))


def rank_at(M: Any, point: Mapping[Any, complex]) -> int:
    """Return the rank of M with its parameters at a point. A column that is mere rounding counts as zero."""
    value = value_of(M, Environment.at([dict(point)]))
    values, sizes = value.value[0], np.broadcast_to(value.magnitude, value.value.shape)[0]
    full = min(values.shape)
    if full == 0:
        return 0
    lengths = np.linalg.norm(values, axis=0)
    certain = np.all(lengths > CLEAR * sizes.max(axis=0)) and np.all(lengths > 0)
    if certain and np.linalg.svd(values / lengths, compute_uv=False)[full - 1] > CLEAR:
        return int(full)
    many = multiple(50)
    exact = value_of(M, Environment.at([dict(point)], many))
    magnitudes = np.broadcast_to(exact.magnitude, exact.value.shape)[0]
    kept, known = [], 1e-30
    for j in range(magnitudes.shape[1]):
        length = float(_length(exact.value[0][:, j], many.context))
        noise = float(np.max(magnitudes[:, j])) * many.eps * 1e4
        if length > noise:
            kept.append(j)
            known = max(known, noise / length)
    return sum(remainder > known for remainder in _remainders(exact.value[0][:, kept]))


def _remainders(V: Array) -> list[float]:
    """Return the lengths that orthogonalization (largest first) leaves of the columns, which had unit length."""
    context = multiple(50).context
    columns = [V[:, j] / length for j in range(V.shape[1]) if (length := _length(V[:, j], context)) > 0]
    left: list[float] = []
    while columns:
        lengths = [_length(column, context) for column in columns]
        largest = int(np.argmax(lengths))
        left.append(float(lengths[largest]))
        if left[-1] < 1e-40:
            break
        q = columns.pop(largest) / lengths[largest]
        columns = [column - q * context.fdot(column, q, conjugate=True) for column in columns]
    return left


def _length(column: Array, context: Any) -> Any:
    return context.sqrt(context.fsum(column, absolute=True, squared=True))
