"""M⁻¹."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import inverted, square
from solver.numeric.evaluation.poles import poles_of, zeros_of_determinant
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk, whole_power

ORACLE = Oracle(50, "numpy.linalg.inv")


def evaluate(environment: Environment, matrix: Any) -> Value:
    """M⁻¹ (1/m of a scalar)."""
    M = walk(matrix, environment)
    if not M.is_matrix:
        return whole_power(M, -1, environment.arithmetic)
    return inverted(square(matrix, environment), environment.arithmetic)


def poles(operands: tuple[Any, ...], s: Any, point: Environment) -> list[Array]:
    """The poles of M and the zeros of det M."""
    return [*poles_of(operands[0], s, point), zeros_of_determinant(operands[0], s, point)]
