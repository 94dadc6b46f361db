"""A ⊗ B."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, left: Any, right: Any) -> Value:
    """The blocks aᵢⱼ B; a scalar counts as a matrix 1×1."""
    A, B = (_matrix(walk(each, environment), environment) for each in (left, right))
    size = environment.arithmetic.size
    return Value(
        _blocks(A.value, B.value),
        _blocks(size(A.value), B.magnitude) + _blocks(A.magnitude, size(B.value)),
    )


def _matrix(value: Value, environment: Environment) -> Value:
    return value if value.is_matrix else environment.stack([value], (1, 1))


def _blocks(A: Any, B: Any) -> Any:
    """A ⊗ B at each point of arrays (P, m, n) and (P, p, q)."""
    products = A[:, :, None, :, None] * B[:, None, :, None, :]
    points, m, p, n, q = products.shape
    return np.asarray(products).reshape(points, m * p, n * q)
