"""vec M."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, matrix: Any) -> Value:
    """The columns of M below each other."""
    M = walk(matrix, environment)
    if not M.is_matrix:
        return M
    return Value(*(np.swapaxes(part, 1, 2).reshape(len(part), -1, 1) for part in M))
