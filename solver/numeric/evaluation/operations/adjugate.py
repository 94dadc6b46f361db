"""adj M, the transposed matrix of cofactors."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import hadamard, inverted, square
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value

ORACLE = Oracle(40, "numpy.linalg.det")


def evaluate(environment: Environment, matrix: Any) -> Value:
    """Adj M by minors; with many digits det M · M⁻¹ where M is safely invertible."""
    M = square(matrix, environment)
    n = M.value.shape[1]
    if environment.arithmetic is not DOUBLE and n > 3:
        det = environment.arithmetic.determinant(M.value)
        if np.all(environment.arithmetic.size(det) > 1e-20 * hadamard(M.magnitude)):
            M_inverse = inverted(M, environment.arithmetic)
            scale = hadamard(M.magnitude)[:, None, None]
            return Value(M_inverse.value * det[:, None, None], M_inverse.magnitude * scale)
    return _by_minors(M, environment)


def _by_minors(M: Value, environment: Environment) -> Value:
    """Adj M: the entry (j, i) is (−1)^{i+j} times the determinant of M without row i and column j."""
    n = M.value.shape[1]
    if n == 1:
        return Value(np.full_like(M.value, environment.arithmetic.number(1)), np.ones_like(M.magnitude))
    rows, columns, signs = _places_of_minors(n)

    def minors(part: Array) -> Array:
        return part[:, rows, columns].reshape(-1, n - 1, n - 1)

    shape = (environment.points, n, n)
    value = environment.arithmetic.determinant(minors(M.value)).reshape(shape) * signs
    return Value(value, lambda: hadamard(minors(M.magnitude)).reshape(shape))


@cache
def _places_of_minors(n: int) -> tuple[Array, Array, Array]:
    """Return the rows and columns that the minors of adj M keep, entry by entry, and their signs."""
    keep = np.array([[k for k in range(n) if k != i] for i in range(n)])
    rows, columns = np.tile(keep, (n, 1)), np.repeat(keep, n, axis=0)
    signs = np.array([[(-1) ** (i + j) for j in range(n)] for i in range(n)])
    return rows[:, :, None], columns[:, None, :], signs


poles = poles_of_operands
