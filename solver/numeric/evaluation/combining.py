"""Sums and products of values: of scalars, of matrices, of one with the other."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Arithmetic
from solver.numeric.evaluation.values import ShapeMismatch, Value, shape_of
from solver.words import Phrase

MOST_WAITING = 50
"""The magnitude of so many values may wait for each other: each waits within a call of the one before."""


def joined(join: Callable[[Value, Value], Value], values: Iterable[Value]) -> Value:
    """Return what values, at least one, are joined to from left to right."""
    result, *others = values
    for i, other in enumerate(others, 1):
        result = join(result, other)
        if i % MOST_WAITING == 0:
            result = result.known()
    return result


def multiply(left: Value, right: Value, arithmetic: Arithmetic) -> Value:
    """Return the product of matrices, or of a scalar and anything."""
    if left.is_matrix and right.is_matrix:
        if left.value.shape[2] != right.value.shape[1]:
            raise _misfit("a product of matrices {left} and {right}", left, right)
        combined: Any = np.matmul
    else:
        left, right = aligned(left, right)
        combined = np.multiply

    def magnitude() -> Any:
        size = arithmetic.size
        return combined(size(left.value), right.magnitude) + combined(left.magnitude, size(right.value))

    return Value(combined(left.value, right.value), magnitude)


def aligned(left: Value, right: Value) -> tuple[Value, Value]:
    """Give a scalar beside a matrix (or list) the axes it needs to broadcast."""
    left_depth, right_depth = (getattr(side.value, "ndim", 0) for side in (left, right))
    if left_depth == right_depth:
        return left, right
    depth = max(left_depth, right_depth)
    return _deepened(left, depth), _deepened(right, depth)


def _deepened(scalar: Value, depth: int) -> Value:
    if np.ndim(scalar.value) != 1 or depth < 2:
        return scalar
    axes = (slice(None), *(None for _ in range(depth - 1)))

    def magnitude() -> Any:
        return scalar.magnitude[axes] if np.ndim(scalar.magnitude) else scalar.magnitude

    return Value(scalar.value[axes], magnitude)


def _misfit(pattern: str, left: Value, right: Value) -> ShapeMismatch:
    return ShapeMismatch(Phrase(pattern, left=size_in_words(left), right=size_in_words(right)))


def size_in_words(value: Value) -> str:
    """Return `2×3` of matrices 2×3."""
    return "×".join(map(str, shape_of(value))) or "1×1"


def add(left: Value, right: Value) -> Value:
    """Return the sum; raises ShapeMismatch unless the shapes agree (1×1 and a scalar do)."""
    if (shape_of(left) or (1, 1)) != (shape_of(right) or (1, 1)):
        raise _misfit("a sum of matrices {left} and {right}", left, right)
    left, right = aligned(left, right)
    return Value(np.add(left.value, right.value), lambda: left.magnitude + right.magnitude)
