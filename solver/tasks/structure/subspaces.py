"""The reachable and the unseen subspace: controllability and observability matrix with their independent columns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.stated import product
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("subspaces")
def subspaces_of(plant: Any, part: str) -> Derivation[None]:
    """The ranks and independent columns (rows) that the part of the decomposition asks for."""
    if part != "observable":
        yield _reachable(plant, part)
    if part != "controllable":
        yield _seen(plant, part)


def observability_matrix(plant: Any) -> ImmutableMatrix:
    """[C; CA; …; CAⁿ⁻¹] (np×n)."""
    return sp.ImmutableMatrix(exact.controllability_matrix(plant.A.T, plant.C.T).T)


def rank_exceptions(matrix: ImmutableMatrix) -> Sequence[Any] | None:
    """Conditions on parameters under which the rank is lower; None if there are too many minors to tell."""
    try:
        conditions: Sequence[Any] = exact.rank_conditions(matrix)
    except exact.NotExact:
        return None
    return conditions


def _reachable(plant: Any, part: str) -> Step:
    """The controllability matrix, its rank and its independent columns."""
    A, n, m = plant.A, plant.order, plant.B.cols
    matrix = exact.controllability_matrix(A, plant.B)
    blocks = [sp.ImmutableMatrix(matrix[:, i * m : (i + 1) * m]) for i in range(n)]
    claims = {f"block{i}": Claim(product(A, blocks[i - 1]), blocks[i], f"${_power(i)}B$") for i in range(1, n)}
    return Step(
        "reachable",
        claims=claims,
        unclaimed="for one state the matrix is B itself",
        names=[f"{_power(i)}B" for i in range(n)],
        matrix=matrix,
        chosen=[j + 1 for j in exact.independent_columns(matrix)],
        n=n,
        part=part,
        exceptions=rank_exceptions(matrix),
        discrete=plant.discrete,
    )


def _seen(plant: Any, part: str) -> Step:
    """The observability matrix, its rank and its independent rows."""
    A, n, p = plant.A, plant.order, plant.C.rows
    matrix = observability_matrix(plant)
    blocks = [sp.ImmutableMatrix(matrix[i * p : (i + 1) * p, :]) for i in range(n)]
    claims = {f"block{i}": Claim(product(blocks[i - 1], A), blocks[i], f"$C{_power(i)}$") for i in range(1, n)}
    return Step(
        "seen",
        claims=claims,
        unclaimed="for one state the matrix is C itself",
        names=[f"C{_power(i)}" for i in range(n)],
        matrix=matrix,
        chosen=[i + 1 for i in exact.independent_columns(matrix.T)],
        n=n,
        part=part,
        exceptions=rank_exceptions(matrix),
        discrete=plant.discrete,
    )


def _power(i: int) -> str:
    return "" if i == 0 else "A" if i == 1 else f"A^{{{i}}}"
