"""Is a given matrix Φ(t) the matrix exponential e^{At}, is Φ(k) the power Aᵏ? Judged by values, not by form."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.stated.algebra import exponential, power, product

TIMES = (0.0, 2.3, 0.61)
"""Times in units of 1/ρ(A), the spectral radius (A nilpotent: of one over its norm); last the one of many digits."""

LAST_EXPONENT = 8


def exponential_residual(A: Any, Phi: Any, t: Any) -> float:
    """Return the largest entrywise relative difference of Φ(t) (n×n in the symbol t) and e^{At} (scipy.linalg.expm).

    At several t, 0 among them (there e^{A0} = I), suited to the fast and to the slow modes, and at random values of
    parameters. Infinite if the shapes differ or Φ is not defined at such a t. Raises NotEvaluable.
    """
    points = [{**point, t: time} for point in _parameters(A, Phi, t) for time in _times(A, point)]
    return equality_residual(exponential(product(t, A)), Phi, points)


def power_residual(A: Any, Phi: Any, k: Any) -> float:
    """Return the largest entrywise relative difference of Φ(k) (n×n in the symbol k) and Aᵏ for k = 0, 1, …, 8."""
    points = [{**point, k: step} for point in _parameters(A, Phi, k) for step in range(LAST_EXPONENT + 1)]
    return equality_residual(power(A, k), Phi, points)


def _parameters(A: Any, Phi: Any, variable: Any) -> list[Any]:
    return admissible((free_symbols(A) | free_symbols(Phi)) - {variable}, 2)


def _times(A: Any, point: Point) -> list[float]:
    """Return times at which the modes of A, fast and slow, are neither dead nor out of range."""
    A_here = value_of(A, Environment.at([point])).value[0]
    size = _balanced_norm(np.abs(A_here))
    if size == 0.0:
        return list(TIMES)
    eigenvalues = np.linalg.eigvals(A_here)
    sizes = np.abs(eigenvalues)
    certain = sizes[sizes > 8.0 * size * 2.0 ** (-52 / len(sizes))]  # less may be the rounding of a multiple zero
    if not len(certain):
        return [time / size for time in TIMES]
    fast, slow = float(np.max(certain)), float(np.min(certain))
    growth = max(float(np.max(eigenvalues.real)), 1e-6 * fast)
    latest = min(1.7 / slow, 30.0 / growth, 300.0 / fast)
    return ([latest] if latest > 5.0 / fast else []) + [time / fast for time in TIMES]


def _balanced_norm(sizes: Array) -> float:
    """Return the largest row sum of D⁻¹ |A| D, D diagonal, after some sweeps of Osborne's balancing."""
    rows: list[list[float]] = sizes.tolist()  # short: numpy would take longer
    for _ in range(4):
        for i, line in enumerate(rows):
            row, column = sum(line) - line[i], sum(each[i] for each in rows) - line[i]
            if row > 0.0 and column > 0.0:
                factor = (column / row) ** 0.5
                rows[i] = [size * factor for size in line]
                for each in rows:
                    each[i] /= factor
    return max(map(sum, rows), default=0.0)
