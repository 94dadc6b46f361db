"""det M."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import hadamard, square
from solver.numeric.evaluation.poles import poles_of_operands, zeros_of_determinant
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value

ORACLE = Oracle(30, "numpy.linalg.det")


def evaluate(environment: Environment, matrix: Any) -> Value:
    """Det M, rounding within Hadamard's bound of |M|."""
    M = square(matrix, environment)
    return Value(environment.arithmetic.determinant(M.value), lambda: hadamard(M.magnitude))


poles = poles_of_operands


def zeros(operands: tuple[Any, ...], s: Any, point: Environment) -> Array:
    """The zeros of det M."""
    return zeros_of_determinant(operands[0], s, point)
