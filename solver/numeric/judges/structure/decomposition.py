"""Kalman's decompositions judged: any coordinates are right that keep apart what is hidden.

With R the reachable subspace and N the unseen one, the columns of T = [T₁, T₂, …] must lie in subspaces that R and N
prescribe, and T must be invertible. Where T itself is not given, the other answers are right if some such T leads to
them: with S = T₀⁻¹T for one numeric T₀, the conditions A₀S = SA, SB = B₀, C = C₀S are linear in S.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.ranks import independent, rank
from solver.numeric.judges.linear_algebra.similar import SMALL, misfit
from solver.numeric.judges.structure.controllability import hidden_of_both_residual

PATTERNS: Mapping[str, tuple[tuple[int, ...], ...]] = {
    "controllable": ((0,), (0, 1)),
    "observable": ((0, 1), (1,)),
    "full": ((0, 1), (1,), (0, 1, 2, 3), (1, 3)),
}
"""For each part, the parts of T₀ of which its columns of T may be combinations."""


def krylov(A: Any, B: Any) -> Any:
    """[B, AB, …, Aⁿ⁻¹B]."""
    blocks = [sp.Matrix(B)]
    for _ in range(A.rows - 1):
        blocks.append(A * blocks[-1])
    return sp.Matrix.hstack(*blocks)


def observability(A: Any, C: Any) -> Any:
    """[C; CA; …; CAⁿ⁻¹]."""
    return krylov(A.T, C.T).T


def kalman_orders(part: str, A: Any, B: Any, C: Any) -> list[int]:
    """Return the dimensions of the parts by ranks, parameters at random values. Raises NotEvaluable."""
    n = A.rows
    if part == "controllable":
        r = rank(krylov(A, B))
        return [r, n - r]
    q = rank(observability(A, C))
    if part == "observable":
        return [q, n - q]
    r, both = rank(krylov(A, B)), rank(observability(A, C) * krylov(A, B))
    return [both, r - both, q - both, n - r - q + both]


def separation_residual(part: str, T: Any, A: Any, B: Any, C: Any) -> float:
    """How far columns of T (n×n) lie outside of their subspaces, as the sine of an angle; infinite if T is singular.

    Zero where ranks with 50 digits find them inside. Raises NotEvaluable.
    """
    if T.shape != A.shape or not independent(T):
        return float("inf")
    if _separates(part, T, A, B, C):
        return 0.0
    return worst_of(_largest_sine(part, at(T, point), whole) for point, whole in references(part, A, B, C, [T]))


def _separates(part: str, T: Any, A: Any, B: Any, C: Any) -> bool:
    """Whether the columns of T lie where the decomposition wants them, by ranks."""
    orders = kalman_orders(part, A, B, C)
    ends = [sum(orders[:i]) for i in range(len(orders) + 1)]
    if part != "observable":
        r = ends[1] if part == "controllable" else ends[2]
        if r and rank(sp.Matrix.hstack(krylov(A, B), T[:, :r])) > r:
            return False
    unseen = {"controllable": [], "observable": [1], "full": [1, 3]}[part]
    columns = [j for i in unseen for j in range(ends[i], ends[i + 1])]
    return not columns or rank(observability(A, C) * T[:, columns]) == 0


def _largest_sine(part: str, T: Array, whole: Reference) -> float:
    """The largest part of a column of T, of unit length, that lies in bases of T₀ where it should not."""
    S = np.linalg.inv(whole.T) @ (T / np.linalg.norm(T, axis=0))
    outside = np.where(_mask(part, whole.orders), 0.0, S)
    return max(2 * SMALL, float(np.max(np.linalg.norm(outside, axis=0), initial=0.0)))


@dataclass(frozen=True)
class Reference:
    """The plant at one point in coordinates T₀ of the decomposition: orthonormal bases of its subspaces."""

    orders: tuple[int, ...]
    T: Array
    A: Array
    B: Array
    C: Array

    @property
    def visible(self) -> Reference:
        """The first part alone."""
        k = self.orders[0]
        return Reference((k,), np.eye(k), self.A[:k, :k], self.B[:k, :], self.C[:, :k])


def references(part: str, A: Any, B: Any, C: Any, others: Sequence[Any] = ()) -> list[tuple[Any, Reference]]:
    """Return points and the plant there, in coordinates of the decomposition. `others` share the parameters."""
    n = A.rows
    B, C = (B if B is not None else sp.zeros(n, 0)), (C if C is not None else sp.zeros(0, n))
    orders = tuple(kalman_orders(part, A, B, C))
    symbols = frozenset().union(*map(free_symbols, (A, B, C, *others)))
    return [(point, _reference(part, orders, *(at(M, point) for M in (A, B, C)))) for point in admissible(symbols, 2)]


def at(M: Any, point: Any) -> Array:
    """Return the matrix at a point, in doubles (rows×columns)."""
    if 0 in M.shape:
        return np.zeros(M.shape)
    values: Array = value_of(M, Environment.at([point])).value[0]
    return values


def _reference(part: str, orders: tuple[int, ...], A: Array, B: Array, C: Array) -> Reference:
    n = len(A)
    if part == "controllable":
        reached = _basis(A, B, orders[0])
        bases = [reached, _complement(reached)]
    elif part == "observable":
        seen = _basis(A.conj().T, C.conj().T, orders[0])
        bases = [seen, _complement(seen)]
    else:
        reached = _basis(A, B, orders[0] + orders[1])
        unseen = _complement(_basis(A.conj().T, C.conj().T, orders[0] + orders[2]))
        # R ∩ N: the directions of R that lie in N, by the angles between the subspaces
        left, _, _ = np.linalg.svd(reached.conj().T @ unseen) if reached.size and unseen.size else (None, 0, 0)
        both = reached @ left[:, : orders[1]] if left is not None else np.zeros((n, 0))
        first = reached @ left[:, orders[1] :] if left is not None else reached
        fourth = _orthonormal(unseen - both @ (both.conj().T @ unseen), orders[3])
        bases = [first, both, _complement(_orthonormal(np.hstack([first, both, fourth]), n - orders[2])), fourth]
    T = np.hstack(bases)
    inverse = np.linalg.inv(T)
    return Reference(orders, T, inverse @ A @ T, inverse @ B, C @ T)


def _basis(A: Array, B: Array, dimension: int) -> Array:
    """An orthonormal basis (n×dimension) of the span of B, AB, A²B, …, built up block by block."""
    Q = np.zeros((len(A), 0), dtype=complex)
    block = B
    while Q.shape[1] < dimension and block.shape[1]:
        rest = block - Q @ (Q.conj().T @ block)
        rest = rest - Q @ (Q.conj().T @ rest)
        lengths = np.linalg.norm(block, axis=0)
        rest = rest[:, lengths > 0] / lengths[lengths > 0]
        left, sizes, _ = np.linalg.svd(rest, full_matrices=False)
        new = left[:, sizes > 1e-9][:, : dimension - Q.shape[1]]
        if not new.shape[1]:
            break
        Q, block = np.hstack([Q, new]), A @ new
    return Q


def _orthonormal(M: Array, dimension: int) -> Array:
    return np.asarray(np.linalg.svd(M, full_matrices=True)[0][:, :dimension]) if M.size else np.zeros((len(M), 0))


def _complement(Q: Array) -> Array:
    """An orthonormal basis of the complement of orthonormal columns."""
    if not Q.shape[1]:
        return np.eye(len(Q))
    return np.asarray(np.linalg.svd(Q, full_matrices=True)[0][:, Q.shape[1] :])


def coordinates_residual(part: str, plant: tuple[Any, Any, Any], answers: Mapping[str, Any]) -> float:
    """How far the answers A, B, C (any of them) are from what some T of the decomposition leads to; zero if one does.

    A singular value of the conditions on T; infinite where shapes misfit or only singular T satisfy them.
    """
    pairs = references(part, *plant, others=list(answers.values()))
    return worst_of(misfit(whole, _mask(part, whole.orders), _at(answers, point)) for point, whole in pairs)


def visible_part_residual(part: str, plant: tuple[Any, Any, Any], answers: Mapping[str, Any]) -> float:
    """How far A, B, C (any of them) are from describing the first part of the decomposition in some coordinates."""
    pairs = references(part, *plant, others=list(answers.values()))
    k = pairs[0][1].orders[0]
    return worst_of(misfit(whole.visible, np.ones((k, k), dtype=bool), _at(answers, point)) for point, whole in pairs)


def _at(answers: Mapping[str, Any], point: Any) -> dict[str, Array]:
    return {name: at(M, point) for name, M in answers.items()}


def hidden_polynomial_residual(part: str, plant: tuple[Any, Any, Any], modes: Sequence[Any]) -> float:
    """Return the largest relative difference of det(xI − A) of the hidden parts and Π(x − λᵢ) at random x."""
    A, B, C = plant
    return hidden_of_both_residual(A, B if part != "observable" else None, C if part != "controllable" else None, modes)


def _mask(part: str, orders: tuple[int, ...]) -> Array:
    owner = [i for i, order in enumerate(orders) for _ in range(order)]
    return np.array([[i in PATTERNS[part][j] for j in owner] for i in owner], dtype=bool).reshape(len(owner), -1)
