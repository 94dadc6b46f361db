"""e^X."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import square
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import floored, walk

ORACLE = Oracle(60, "scipy.linalg.expm")


def evaluate(environment: Environment, exponent: Any) -> Value:
    """e^X."""
    X = walk(exponent, environment)
    arithmetic = environment.arithmetic
    if X.is_matrix:
        X = square(exponent, environment)
        found, exponents = arithmetic.exponential(X.value), X

        def magnitude() -> Array:
            cancelled = exponents.magnitude / floored(exponents, arithmetic)
            return np.asarray(found.magnitude * np.maximum(1.0, cancelled.max(axis=(1, 2), keepdims=True)))

        return Value(found.value, magnitude)
    value = arithmetic.apply("exp", X.value)
    return Value(value, lambda: arithmetic.size(value) * (1.0 + X.magnitude))
