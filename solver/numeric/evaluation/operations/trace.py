"""tr M."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import square
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.values import Value


def evaluate(environment: Environment, matrix: Any) -> Value:
    """Tr M."""
    M = square(matrix, environment)
    diagonal = range(M.value.shape[1])
    return Value(sum(M.value[:, i, i] for i in diagonal), sum(M.magnitude[:, i, i] for i in diagonal))


poles = poles_of_operands
