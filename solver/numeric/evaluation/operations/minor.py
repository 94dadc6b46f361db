"""The determinant of M without a row and a column."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import hadamard, square
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value

ORACLE = Oracle(30, "numpy.linalg.det")

poles = poles_of_operands


def evaluate(environment: Environment, matrix: Any, row: int, column: int) -> Value:
    """The determinant of what is left of M; of a matrix 1×1 it is 1."""
    M = square(matrix, environment)
    if M.value.shape[1] == 1:
        return Value(environment.arithmetic.number(1), 1.0)
    value, magnitude = (np.delete(np.delete(part, row - 1, 1), column - 1, 2) for part in M)
    return Value(environment.arithmetic.determinant(value), hadamard(magnitude))
