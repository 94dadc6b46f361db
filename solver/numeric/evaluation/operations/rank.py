"""rank M."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.ranks import rank_at
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value

ORACLE = Oracle(20, "numpy.linalg.svd")


def evaluate(environment: Environment, matrix: Any) -> Value:
    """Rank M at each point."""
    full = {symbol: environment.full(value) for symbol, value in environment.values.items()}
    counts = [
        rank_at(matrix, {symbol: values[p] for symbol, values in full.items()}) for p in range(environment.points)
    ]
    return Value(environment.arithmetic.array(counts), np.zeros(environment.points))
