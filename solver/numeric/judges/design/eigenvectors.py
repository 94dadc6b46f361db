"""Eigenvectors that a feedback gives the closed loop, judged without the null space that they are found from.

v is attainable for λ if (λI − A) v = −B w for some w, that is if Yᴴ(λI − A) v = 0 with the columns of Y orthogonal to
those of B. So the vectors (λI − A)ᴴ Y y are all that is orthogonal to the attainable ones, and the nearest attainable
vector is the wanted one less its least-squares fit by these.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import scipy.linalg
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Point
from solver.numeric.judges.design.placement import rational_points

NEGLIGIBLE = 1e-11
"""Singular values below this part of the largest are zero."""


def nearest_attainable(A: Array, B: Array, pole: complex, wanted: Array) -> Array:
    """Return the vector nearest to `wanted` (n) that a feedback can give the pole as eigenvector (A n×n, B n×m)."""
    orthogonal = (pole * np.eye(len(A)) - A).conj().T @ scipy.linalg.null_space(B.conj().T, rcond=NEGLIGIBLE)
    fit = np.linalg.lstsq(orthogonal, wanted, rcond=NEGLIGIBLE)[0]
    return wanted - orthogonal @ fit


def assigned_residual(A: Any, B: Any, poles: Sequence[Any], wanted: Any, loop: Any) -> float:
    """Return how far loop · v is from λ v, v the attainable vector nearest to each column of `wanted` (n×n).

    Relative to the sizes of the factors. Infinite for a loop that is not n×n.
    """
    if loop.shape != A.shape:
        return float("inf")
    worst = 0.0
    for point in rational_points(A, B, list(poles), wanted, loop):
        closed = _floats(loop, point)
        for pole, v in _nearest_at(A, B, poles, wanted, point):
            scale = (np.linalg.norm(closed) + abs(pole)) * np.linalg.norm(v)
            worst = worst_of((worst, float(np.linalg.norm(closed @ v - pole * v) / scale)))
    return worst


def nearest_residual(A: Any, B: Any, poles: Sequence[Any], wanted: Any, V: Any) -> float:
    """Return the largest sine of the angle between a column of V (n×n) and the vector it should be a multiple of."""
    if V.shape != wanted.shape:
        return float("inf")
    worst = 0.0
    for point in rational_points(A, B, list(poles), wanted, V):
        for column, (_, v) in zip(_floats(V, point).T, _nearest_at(A, B, poles, wanted, point), strict=True):
            if not column.any():
                return float("inf")
            along = v * (v.conj() @ column) / (v.conj() @ v)
            worst = worst_of((worst, float(np.linalg.norm(column - along) / np.linalg.norm(column))))
    return worst


def _nearest_at(
    A: Any, B: Any, poles: Sequence[Any], wanted: Any, point: dict[Any, Any]
) -> list[tuple[complex, Array]]:
    """Each pole at the point, and its vector."""
    plant = _floats(A, point), _floats(B, point)
    values = [complex((sp.Integer(0) + pole).subs(point).evalf(20)) for pole in poles]
    columns = _floats(wanted, point).T
    return [(pole, nearest_attainable(*plant, pole, v)) for pole, v in zip(values, columns, strict=True)]


def _floats(M: Any, point: Point) -> Array:
    return np.array(sp.Matrix(M.subs(point)).evalf(20).tolist(), dtype=complex)
