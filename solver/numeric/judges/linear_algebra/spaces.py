"""How far rounded vectors are from a space, relative to their own size: what rounding explains is small there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import admissible, free_symbols

RANK = 1e-9
"""Singular values below this, relative to the largest, are zero."""


def null_residual(M: Any, V: Any) -> float:
    """Return the largest entry of M V (m×n times n×r), relative to those of M and of each column of V."""
    return worst_of(_null_at(M, V, point) for point in admissible(free_symbols([M, V]), 2))


def range_residual(M: Any, V: Any) -> float:
    """Return how far the columns of V (m×r) are from the range of M (m×n), relative to their lengths."""
    return worst_of(_range_at(M, V, point) for point in admissible(free_symbols([M, V]), 2))


def _null_at(M: Any, V: Any, point: Mapping[Any, complex]) -> float:
    left, vectors = _numbers(M, point), _numbers(V, point)
    sizes = np.max(np.abs(vectors), axis=0) * max(float(np.max(np.abs(left), initial=0.0)), 1e-300)
    return float(np.max(np.abs(left @ vectors) / np.where(sizes == 0, 1.0, sizes), initial=0.0))


def _range_at(M: Any, V: Any, point: Mapping[Any, complex]) -> float:
    U, values, _ = np.linalg.svd(_numbers(M, point))
    across = U[:, int(np.sum(values > RANK * max(values[0], 1e-300))) :]
    vectors = _numbers(V, point)
    lengths = np.linalg.norm(vectors, axis=0)
    return float(np.max(np.abs(across.conj().T @ vectors) / np.where(lengths == 0, 1.0, lengths), initial=0.0))


def _numbers(M: Any, point: Mapping[Any, complex]) -> Array:
    return np.array([[evaluate(M[i, j], point) for j in range(M.cols)] for i in range(M.rows)])
