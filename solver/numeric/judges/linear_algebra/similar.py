"""Whether matrices A, B, C belong to a given plant in other coordinates, by the linear conditions on these."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import SEED

SMALL = 1e-9
"""Singular values below this, of matrices whose terms are of the size of one, are zero."""


class Plant(Protocol):
    """Matrices in doubles: A k×k, B k×m, C p×k."""

    @property
    def A(self) -> Array:
        """A."""

    @property
    def B(self) -> Array:
        """B."""

    @property
    def C(self) -> Array:
        """C."""


def misfit(reference: Plant, mask: Array, answers: Mapping[str, Array]) -> float:
    """How far A₀S = SA, SB = B₀, C₀S = C (those given) are from holding for an invertible S that is zero off the mask.

    Right answers leave as many S as the plant's own matrices do; so the singular value counted from there is zero.
    """
    k, m, p = len(reference.A), reference.B.shape[1], len(reference.C)
    shapes = {"A": (k, k), "B": (k, m), "C": (p, k)}
    if any(M.shape != shapes[name] for name, M in answers.items()):
        return float("inf")
    if k == 0:
        return 0.0
    own = {"A": reference.A, "B": reference.B, "C": reference.C}
    _, sizes, _ = _system(reference, mask, {name: own[name] for name in answers})
    scale, small, directions = _system(reference, mask, answers)
    solutions = int(np.sum(sizes <= SMALL))
    value = float(small[len(small) - solutions]) / scale
    if value > SMALL:
        return value
    return 0.0 if _some_invertible(mask, directions[:, small <= SMALL], {"B", "C"} & set(answers)) else float("inf")


def _system(reference: Plant, mask: Array, answers: Mapping[str, Array]) -> tuple[float, Array, Array]:
    """The singular values of the conditions, as many as unknowns (the entries of S and the factor of B₀ and C)."""
    k = len(reference.A)
    columns = []
    for i, j in np.argwhere(mask):
        S = np.zeros((k, k))
        S[i, j] = 1.0
        columns.append(_conditions(reference, S, answers))
    columns.append(_conditions(reference, np.zeros((k, k)), answers, given=1.0))
    system = np.column_stack(columns)
    _, sizes, right = np.linalg.svd(system)
    padded = np.zeros(system.shape[1])
    padded[: len(sizes)] = sizes
    return max(1.0, float(padded[0])), padded, np.asarray(right.conj().T)


def _some_invertible(mask: Array, solutions: Array, fixed: set[str]) -> bool:
    """Whether a solution at random is an invertible S (with a factor that is not zero where it belongs to one)."""
    random = np.random.default_rng(SEED)
    for _ in range(3):
        vector = solutions @ random.standard_normal(solutions.shape[1])
        S = np.zeros(mask.shape, dtype=complex)
        S[mask] = vector[:-1]
        sizes = np.linalg.svd(S, compute_uv=False)
        if sizes[-1] > 1e-7 * sizes[0] and (not fixed or abs(vector[-1]) > 1e-7 * np.linalg.norm(vector)):
            return True
    return False


def _conditions(reference: Plant, S: Array, answers: Mapping[str, Array], given: float = 0.0) -> Array:
    """A₀S − SA, SB − g B₀, C₀S − g C in one column, each relative to its size; linear in S and g."""
    parts = []
    if "A" in answers:
        parts.append((reference.A @ S - S @ answers["A"]) / _size(reference.A, answers["A"]))
    if "B" in answers:
        parts.append((S @ answers["B"] - given * reference.B) / _size(reference.B, answers["B"]))
    if "C" in answers:
        parts.append((reference.C @ S - given * answers["C"]) / _size(reference.C, answers["C"]))
    return np.concatenate([part.reshape(-1) for part in parts])


def _size(*matrices: Array) -> float:
    """The largest norm; one where all are zero."""
    return max(float(np.linalg.norm(M)) for M in matrices) or 1.0
