"""The reachable and the unseen subspace: controllability and observability matrix with their independent columns."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.derivation.stated import product, rank
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.structure.pairs import Pair
from solver.tasks.structure.row_operations import row_operations

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


def input_pair(plant: Any) -> Pair:
    """(A, B)."""
    return Pair(plant.A, plant.B, dual=False, discrete=plant.discrete)


def output_pair(plant: Any) -> Pair:
    """(A, C), dual."""
    return Pair(plant.A, plant.C, dual=True, discrete=plant.discrete)


@lemma("subspaces")
def subspaces_of(plant: Any, part: str) -> Derivation[None]:
    """The ranks and independent columns (rows) that the part of the decomposition asks for."""
    if part != "observable":
        pair = input_pair(plant)
        yield Step("reachable", claims=_claims(pair), steps=_row_operations(pair), **_values(pair, part))
    if part != "controllable":
        pair = output_pair(plant)
        yield Step("seen", claims=_claims(pair), steps=_row_operations(pair), **_values(pair, part))


def rank_exceptions(matrix: ImmutableMatrix) -> Sequence[Any] | None:
    """Conditions on parameters under which the rank is lower; None if there are too many minors to tell."""
    try:
        conditions: Sequence[Any] = exact.rank_conditions(matrix)
    except exact.NotExact:
        return None
    return conditions


def _claims(pair: Pair) -> dict[str, Claim]:
    """Each block from the one before it, and the rank."""
    blocks, names = pair.blocks, pair.names
    claims = {}
    for i in range(1, pair.n):
        stated = product(blocks[i - 1], pair.A) if pair.dual else product(pair.A, blocks[i - 1])
        claims[f"block{i}"] = Claim(stated, blocks[i], f"${names[i]}$")
    return claims | {"rank": Claim(rank(pair.matrix), sp.Integer(len(_chosen(pair))), "rank")}


def _chosen(pair: Pair) -> tuple[int, ...]:
    """The numbers (from 0) of the independent columns (dual: rows)."""
    return exact.independent_columns(pair.turned(pair.matrix))


def _row_operations(pair: Pair) -> tuple[Step, ...]:
    matrix = pair.turned(pair.matrix)
    return row_operations(matrix, exact.row_reduction(matrix))


def _values(pair: Pair, part: str) -> dict[str, Any]:
    return {
        "names": pair.names,
        "matrix": pair.matrix,
        "chosen": [j + 1 for j in _chosen(pair)],
        "n": pair.n,
        "part": part,
        "exceptions": rank_exceptions(pair.matrix),
        "discrete": pair.discrete,
    }
