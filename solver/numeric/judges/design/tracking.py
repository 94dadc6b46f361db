"""Steady states with the output at the reference, judged by least squares; gains completed from poles."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, equilibration, multiple
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import remainder
from solver.numeric.evaluation.points import holds_decimals
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.design.placement import rational_points

Matrices = tuple[Any, Any, Any, Any]
MANY = multiple(50)
NOTHING = 1e-30
"""A part of a vector of unit length that is smaller than this is rounding."""


def _in_numbers(M: Any, point: Mapping[Any, Any], *, exact: bool) -> Array:
    """Return a matrix at a point: with 50 digits where all is exact, else in doubles."""
    if not exact:
        return _floats(M, point)
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=object)
    return np.asarray(np.broadcast_to(value_of(M, Environment.at([point], MANY)).value, (1, *M.shape))[0])


def _floats(M: Any, point: Mapping[Any, Any]) -> Array:
    return np.array(sp.Matrix(M).subs(point).evalf(20).tolist(), dtype=complex).reshape(M.shape)


def _steady(matrices: Matrices, point: Mapping[Any, Any], *, discrete: bool, exact: bool) -> tuple[Array, Array]:
    """Return [[A₀, B], [C, D]] and [0; I] at a point."""
    A, B, C, D = (_in_numbers(M, point, exact=exact) for M in matrices)
    n, p = len(A), len(C)
    right = np.vstack([np.zeros((n, p), dtype=int), np.eye(p, dtype=int)])
    M = np.block([[A - int(discrete) * np.eye(n, dtype=int), B], [C, D]])
    return (M, MANY.array(right)) if exact else (M, right.astype(float))


def least_squares(M: Array, right: Array, rcond: float | None = None) -> Array:
    """Return X with M X = right, or next to it; rows and unknowns are scaled so that the entries are of like size."""
    rows, columns = (factors[0][:, None] for factors in equilibration(M[None]))
    scaled = M * rows * columns.T
    X = np.zeros((M.shape[1], right.shape[1]))
    for _ in range(2):  # once more with what is left over
        X = X + columns * np.linalg.lstsq(scaled, (right - M @ X) * rows, rcond=rcond)[0]
    return X


def _misfit(M: Array, right: Array) -> float:
    """Return the largest entry of M X − right for the best X, relative to the largest of right."""
    if M.dtype == object:
        left = remainder(M, right, MANY.context, NOTHING)
        return float(max(map(abs, left.ravel())) / max(1, *map(abs, right.ravel())))
    if not M.shape[1]:
        return float(np.max(np.abs(right), initial=0.0))
    X = least_squares(M, right)
    scale = max(1.0, float(np.max(np.abs(right), initial=0.0)), float(np.max(np.abs(M) @ np.abs(X), initial=0.0)))
    return float(np.max(np.abs(M @ X - right), initial=0.0)) / scale


def steady_residual(matrices: Matrices, known: Mapping[str, Any], *, discrete: bool) -> float:
    """Return how far F, N or both (`known`, by name) are from those of a steady state with y = r."""
    n, p, m = matrices[0].rows, matrices[2].rows, matrices[1].cols
    shapes = {"F": (n, p), "N": (m, p)}
    if any(value.shape != shapes[name] for name, value in known.items()):
        return float("inf")
    worst, exact = 0.0, not holds_decimals([matrices, known])
    for point in rational_points(*matrices, *known.values()):
        M, right = _steady(matrices, point, discrete=discrete, exact=exact)
        columns = {"F": M[:, :n], "N": M[:, n:]}
        free = np.hstack([M[:, :0], *(part for name, part in columns.items() if name not in known)])
        left_over = right - sum(columns[name] @ _in_numbers(V, point, exact=exact) for name, V in known.items())
        worst = worst_of((worst, _misfit(free, left_over)))
    return with_many_digits(worst, matrices, known)


def feedforward_residual(matrices: Matrices, K_o: Any, K: Any, poles: Sequence[Any] = (), *, discrete: bool) -> float:
    """Return how far K_o is from N + K F for a steady state; K None: the gain of one input that places the poles.

    Raises NotEvaluable where the poles do not fix the gain.
    """
    A, B, C, _ = matrices
    if K_o.shape != (B.cols, C.rows):
        return float("inf")
    worst, exact = 0.0, K is not None and not holds_decimals([matrices, K_o, K])
    for point in rational_points(*matrices, K_o, *((K,) if K is not None else ()), list(poles)):
        gain = _in_numbers(K, point, exact=exact) if K is not None else gain_of_poles(A, B, poles, point)
        M, right = _steady(matrices, point, discrete=discrete, exact=exact)
        stacked = np.vstack([M, np.hstack([gain, np.eye(B.cols, dtype=int)])])
        worst = worst_of((worst, _misfit(stacked, np.vstack([right, _in_numbers(K_o, point, exact=exact)]))))
    return with_many_digits(worst, matrices, K_o, K) if exact else worst


def gain_of_poles(A: Any, B: Any, poles: Sequence[Any], point: Mapping[Any, Any]) -> Array:
    """Return the row K that places n poles by one input: det(xI − A + bK) is affine in K, tried at n points x."""
    n = A.rows
    if B.cols != 1 or len(poles) != n:
        raise NotEvaluable("several gains place these poles, and the gain is not among the answers")
    rows, right = affine_determinants(_floats(A, point), _floats(B, point), _roots(poles, point))
    if np.linalg.cond(rows) > 1e12:
        raise NotEvaluable("the poles do not fix the gain")
    return np.linalg.solve(rows, right).reshape(1, n)


def _roots(poles: Sequence[Any], point: Mapping[Any, Any]) -> list[complex]:
    return [complex(sp.N((sp.Integer(0) + pole).subs(point), 20)) for pole in poles]


def affine_determinants(A: Array, b: Array, roots: Sequence[complex]) -> tuple[Array, Array]:
    """Return M and r of M Kᵀ = r, one equation det(xI − A + bK) = Π(x − root) for each of n points x on a circle."""
    n = len(A)
    radius = 1.0 + float(np.max(np.abs(A), initial=1.0))
    xs = radius * np.exp(2j * np.pi * (np.arange(n) + 0.3) / n)
    rows, right = [], []
    for x in xs:
        pencil = x * np.eye(n) - A
        base = np.linalg.det(pencil)
        rows.append([np.linalg.det(pencil + b @ np.eye(n)[[i]]) - base for i in range(n)])
        right.append(np.prod([x - root for root in roots]) - base)
    return np.array(rows), np.array(right)


def completed_residual(A: Any, B: Any, known: Mapping[int, Any], poles: Sequence[Any]) -> float:
    """Return how far some entries of the row K (one input; by column) are from those of a K that places the poles."""
    if B.cols != 1:
        raise NotEvaluable("with several inputs the gain can only be judged as a whole")
    worst = 0.0
    for point in rational_points(A, B, list(known.values()), list(poles)):
        rows, right = affine_determinants(_floats(A, point), _floats(B, point), _roots(poles, point))
        values = {j: complex(sp.N((sp.Integer(0) + value).subs(point), 20)) for j, value in known.items()}
        free = [j for j in range(A.rows) if j not in values]
        scale = float(np.max(np.abs(rows)))
        rest = right - sum((rows[:, j] * value for j, value in values.items()), np.zeros(len(right)))
        worst = worst_of((worst, _misfit(rows[:, free] / scale, (rest / scale).reshape(-1, 1))))
    return worst
