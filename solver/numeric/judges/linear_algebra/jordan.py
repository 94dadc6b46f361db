"""The Jordan structure of a matrix by numbers: clusters of eigenvalues with 60 digits, ranks of powers.

The mean of a cluster of computed eigenvalues is accurate to all digits, unlike each of them (Kato, Perturbation
Theory, II §2.1); so the ranks of (A − λI)ᵏ tell the sizes of the blocks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import evaluate, value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.ranks import independent

DIGITS = 100
CLUSTER = 1e-6
"""Computed eigenvalues closer than this, relative to the largest of them (at least 1), are one multiple eigenvalue."""
ZERO = 1e-60
"""Singular values of (A − λI)ᵏ below this, relative to the norm of A to the power k, are zero."""

NEAR = 1e-9
"""Relative distance of eigenvalues that are the same one."""

Blocks = list[tuple[complex, tuple[int, ...]]]


def jordan_blocks(A: Any, point: Mapping[Any, complex]) -> Blocks:
    """Return each eigenvalue of A (n×n) with the sizes of its Jordan blocks, largest first, at values of parameters."""
    arithmetic = multiple(DIGITS)
    mp = arithmetic.context
    matrix = mp.matrix(value_of(A, Environment.at([dict(point)], arithmetic)).value[0].tolist())
    n, scale = matrix.rows, max(mp.mnorm(matrix), 1)
    values = list(mp.eig(matrix, left=False, right=False)) if n > 1 else [matrix[0, 0]]
    blocks: Blocks = []
    radius = CLUSTER * max(1, *(abs(value) for value in values))
    while values:
        near = [value for value in values if abs(value - values[0]) <= radius]
        values = [value for value in values if abs(value - near[0]) > radius]
        mean = sum(near) / len(near)
        blocks.append((complex(mean), _sizes((matrix - mean * mp.eye(n)) / scale, len(near), mp)))
    return blocks


def _sizes(nilpotent: Any, multiplicity: int, mp: Any) -> tuple[int, ...]:
    """Return the sizes of the blocks from the ranks of powers: rank Nᵏ⁻¹ − rank Nᵏ blocks have a size of k or more."""
    if multiplicity == 1:
        return (1,)
    n = nilpotent.rows
    ranks, power = [n], nilpotent
    while ranks[-1] > n - multiplicity:
        singular = mp.svd_c(power, compute_uv=False)
        ranks.append(sum(1 for value in singular if value > ZERO))
        power = power * nilpotent
        if len(ranks) > n + 1:
            break
    at_least = [before - after for before, after in pairwise(ranks)]
    return tuple(sum(1 for count in at_least if count > block) for block in range(at_least[0]))


def diagonalizable(A: Any) -> bool:
    """Whether A (n×n, parameters at random values) has n independent eigenvectors. Raises NotEvaluable."""
    return all(
        all(size == 1 for _, sizes in jordan_blocks(A, point) for size in sizes)
        for point in admissible(free_symbols(A), 2)
    )


def same_jordan_structure(A: Any, J: Any) -> bool:
    """Whether J has the eigenvalues of A, and as many Jordan blocks of each size. Raises NotEvaluable."""
    if A.shape != J.shape:
        return False
    return all(
        _matched(jordan_blocks(A, point), jordan_blocks(J, point)) for point in admissible(free_symbols([A, J]), 2)
    )


def _matched(left: Blocks, right: Blocks) -> bool:
    rest = list(right)
    for value, sizes in left:
        partner = next(
            (each for each in rest if each[1] == sizes and abs(each[0] - value) <= 1e-9 * (1 + abs(value))), None
        )
        if partner is None:
            return False
        rest.remove(partner)
    return not rest


def chains_residual(A: Any, V: Any, *, rows: bool = False) -> float:
    """Return how far V⁻¹ A V (n×n) is from a Jordan form; with `rows`, V A V⁻¹: the rows are chains of left vectors.

    Relative to the entries of A. The ones may stand above or below the diagonal. Infinite if V is not invertible.
    """
    if V.shape != A.shape:
        return float("inf")
    if not independent(V.T if rows else V):
        return float("inf")
    return worst_of(_chains_at(A, V, point, rows=rows) for point in admissible(free_symbols([A, V]), 2))


def are_in_order(A: Any, V: Any, eigenvalues: Sequence[Any], *, rows: bool = False) -> bool:
    """Whether the columns of V (or its rows) belong to the eigenvalues at the same places, rounded as these may be.

    None other of the eigenvalues may be nearer to what V⁻¹ A V has on its diagonal. Raises NotEvaluable.
    """
    if V.shape != A.shape or len(eigenvalues) != A.rows:
        return False
    for point in admissible(free_symbols([A, V, list(eigenvalues)]), 2):
        X = _in_coordinates(A, V, point, rows=rows)
        if X is None:
            return False
        listed = np.array([evaluate(each, point) for each in eigenvalues])
        apart = np.abs(np.diag(X)[:, None] - listed[None, :])
        if np.any(np.diag(apart) > apart.min(axis=1) + NEAR * (1 + np.abs(listed))):
            return False
    return True


def _chains_at(A: Any, V: Any, point: Mapping[Any, complex], *, rows: bool) -> float:
    X = _in_coordinates(A, V, point, rows=rows)
    if X is None:
        return float("inf")
    scale = max(1.0, float(np.max(np.abs(X))))
    return float(min(_from_jordan(X), _from_jordan(X.T)) / scale)


def _in_coordinates(A: Any, V: Any, point: Mapping[Any, complex], *, rows: bool) -> Array | None:
    """V⁻¹ A V at a point (with `rows` V A V⁻¹), found with 50 digits; None where V has no inverse."""
    arithmetic = multiple(50)
    mp = arithmetic.context
    here = Environment.at([dict(point)], arithmetic)
    A_here, V_here = (mp.matrix(value_of(M, here).value[0].tolist()) for M in (A, V))
    try:
        similar = V_here * A_here * V_here**-1 if rows else V_here**-1 * A_here * V_here
    except ZeroDivisionError:
        return None
    return np.array([[complex(similar[i, j]) for j in range(A.rows)] for i in range(A.rows)])


def _from_jordan(X: Array) -> float:
    """Return the largest entry that keeps X from being in upper Jordan form."""
    wanted = np.diag(np.diag(X)).astype(complex)
    for i in range(len(X) - 1):
        if abs(X[i, i] - X[i + 1, i + 1]) <= 1e-9 * (1 + abs(X[i, i])) and abs(X[i, i + 1]) > 0.5:
            wanted[i, i + 1] = 1
    return float(np.max(np.abs(X - wanted)))


def is_jordan_form(J: Any, eigenvalues: Sequence[Any] | None = None) -> bool:
    """Whether J has ones or zeros above its diagonal (ones only between equal entries) and zeros elsewhere.

    With `eigenvalues`, its diagonal must be these in order.
    """
    n = J.rows
    if J.cols != n or (eigenvalues is not None and not _same(sp.ImmutableMatrix([list(J.diagonal())]), eigenvalues)):
        return False
    links = [J[i, i + 1] for i in range(n - 1)]
    linked = all(link == 0 or (link == 1 and _same([J[i, i]], [J[i + 1, i + 1]])) for i, link in enumerate(links))
    return linked and all(J[i, j] == 0 for i in range(n) for j in range(n) if j not in (i, i + 1))


def _same(left: Any, right: Sequence[Any]) -> bool:
    if len(left) != len(right):
        return False
    return all(
        abs(value_of(a, here).value - value_of(b, here).value) <= 1e-9 * (1 + abs(value_of(a, here).value))
        for point in admissible(free_symbols([left, list(right)]), 2)
        for here in [Environment.at([dict(point)])]
        for a, b in zip(left, right, strict=True)
    )
