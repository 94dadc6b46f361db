"""Discs that hold the eigenvalues of a matrix, made smaller until none reaches the boundary of stability.

For approximations zᵢ of the n zeros of a monic p, the discs around zᵢ of radius n |p(zᵢ)/Πⱼ (zᵢ − zⱼ)| hold all zeros,
and as many in each group of discs that touch as there are discs (B. T. Smith, J. ACM 17, 1970).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, log10
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array, Multiple, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of

STEPS = 10
"""Iterations after which discs that still reach the boundary are taken to hold an eigenvalue on it."""

ON_THE_BOUNDARY = 1e-30
"""What is nearer to the boundary, relative to its size where that is above one, is on it."""

DIGITS = 60
"""Digits of the coefficients beyond those that rounding may cost."""


def excess_of_discs(A: Any, point: Mapping[Any, complex], *, discrete: bool) -> Array | None:
    """Return Re z (discrete: |z| − 1) of the centres of discs off the boundary, None where one can't be kept off it."""
    M = value_of(A, Environment.at([dict(point)])).value[0]
    if not np.all(np.isfinite(M)):
        return None
    n, size = len(M), 16.0 * max(1.0, float(np.linalg.norm(M)))
    arithmetic = multiple(50 * ceil((DIGITS + n * log10(size)) / 50))
    coefficients = characteristic_coefficients(A, point, arithmetic)
    zeros = list(arithmetic.array(np.linalg.eigvals(M)))
    for _ in range(STEPS):
        steps, radii = _steps_and_radii(coefficients, zeros, size, arithmetic)
        excess = np.array([float(abs(z) - 1 if discrete else z.real) for z in zeros])
        nearest = ON_THE_BOUNDARY * np.array([max(1.0, abs(complex(z))) for z in zeros])
        if np.all(np.abs(excess) > np.maximum(radii, nearest)):
            return excess
        zeros = [z - step for z, step in zip(zeros, steps, strict=True)]
    return None


def _steps_and_radii(
    coefficients: Sequence[Any], zeros: Sequence[Any], size: float, arithmetic: Multiple
) -> tuple[list[Any], Array]:
    """Return what Weierstrass' iteration takes off each zero, and the radii; infinite where zeros fall together.

    The coefficients are known to ε n³ (8 ‖A‖)ᵏ: each step of the recursion for them multiplies by A at most twice.
    """
    n, steps, radii = len(zeros), [], []
    for i, z in enumerate(zeros):
        value, distances = arithmetic.number(0), arithmetic.number(1)
        for c in coefficients:
            value = value * z + c
        for j, other in enumerate(zeros):
            distances = distances * (z - other) if j != i else distances
        if not distances:
            return [0] * n, np.full(n, np.inf)
        steps.append(value / distances)
        rounding = arithmetic.eps * n**3 * (abs(complex(z)) + size) ** n / abs(complex(distances))
        radii.append(1.1 * n * (abs(complex(steps[-1])) + rounding))
    return steps, np.array(radii)


def characteristic_coefficients(A: Any, point: Mapping[Any, complex], arithmetic: Multiple) -> list[Any]:
    """Return the coefficients of det(xI − A), the highest power first, by the recursion of Faddeev and LeVerrier."""
    M = value_of(A, Environment.at([dict(point)], arithmetic)).value[0]
    one, n = arithmetic.number(1), len(M)
    found, N = [one], np.array([[one * (i == j) for j in range(n)] for i in range(n)], dtype=object)
    for k in range(1, n + 1):
        N = M @ N
        found.append(-sum(N[i, i] for i in range(n)) / k)
        N[np.diag_indices(n)] += found[-1]
    return found
