"""‖x‖."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Arithmetic, Array, Double
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(25, "numpy.linalg.norm")


def evaluate(environment: Environment, value: Any, kind: str) -> Value:
    """The norm 1, 2, ∞ (`oo`) that vectors induce, or Frobenius' (`F`); a list is a vector, of a scalar it is |x|."""
    x, arithmetic = walk(value, environment), environment.arithmetic
    entries, magnitude = (_as_matrix(part) for part in x)
    size = arithmetic.size(entries)
    error = np.sqrt((magnitude**2).sum(axis=(1, 2))) * max(entries.shape[1:])  # bounds all four norms of the error
    if kind == "F" or (kind == "2" and 1 in entries.shape[1:]):
        return Value(arithmetic.apply("sqrt", _squares(entries, arithmetic).sum(axis=(1, 2))), error)
    if kind in ("1", "oo"):
        sums = _absolute(entries, arithmetic).sum(axis=1 if kind == "1" else 2)
        return Value(sums[np.arange(len(sums)), np.argmax(size.sum(axis=1 if kind == "1" else 2), axis=1)], error)
    return Value(_largest_singular_values(entries, arithmetic), error)


def _as_matrix(part: Any) -> Array:
    """Return an array (P, rows, columns) of scalars (P,), lists (P, k) or matrices."""
    array = np.atleast_1d(part)
    return array.reshape((*array.shape, *(1 for _ in range(3 - array.ndim))))


def _absolute(entries: Array, arithmetic: Arithmetic) -> Array:
    return np.asarray(arithmetic.apply("sqrt", _squares(entries, arithmetic)))


def _squares(entries: Array, arithmetic: Arithmetic) -> Array:
    """|x|² in the arithmetic."""
    return np.asarray(entries * arithmetic.apply("conj", entries))


def _largest_singular_values(matrices: Array, arithmetic: Arithmetic) -> Array:
    if isinstance(arithmetic, Double):
        return np.linalg.norm(matrices, 2, axis=(1, 2)).astype(complex)
    found = [max(arithmetic.context.svd_c(arithmetic.context.matrix(M.tolist()), compute_uv=False)) for M in matrices]
    return np.array([arithmetic.number(each) for each in found], dtype=object)
