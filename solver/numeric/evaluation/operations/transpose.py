"""Mᵀ."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk


def evaluate(environment: Environment, matrix: Any) -> Value:
    """Mᵀ."""
    M = walk(matrix, environment)
    return Value(np.swapaxes(M.value, 1, 2), np.swapaxes(M.magnitude, 1, 2)) if M.is_matrix else M


poles = poles_of_operands
