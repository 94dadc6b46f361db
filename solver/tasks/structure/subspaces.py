"""The reachable and the unseen subspace: controllability and observability matrix with their independent columns."""

from __future__ import annotations

from typing import Any

from solver.arithmetic.row_operations import row_operations
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.matrices import rank
from solver.tasks.structure.pairs import Pair, controllability_pair, observability_pair
from solver.tasks.structure.rank_exceptions import rank_exceptions
from solver.tasks.structure.rank_test import matrix_of


@lemma("subspaces")
def subspaces_of(plant: Any, part: str) -> Derivation[None]:
    """The ranks and independent columns (rows) that the part of the decomposition asks for."""
    if part != "observable":
        pair = controllability_pair(plant)
        yield from matrix_of(pair)
        yield Step("reachable", claims=_claims(pair), steps=_row_operations(pair), **_values(pair, part))
    if part != "controllable":
        pair = observability_pair(plant)
        yield from matrix_of(pair)
        yield Step("seen", claims=_claims(pair), steps=_row_operations(pair), **_values(pair, part))


def _claims(pair: Pair) -> dict[str, Claim]:
    return {"rank": Claim(rank(pair.matrix), sp.Integer(len(_chosen(pair))), "rank")}


def _chosen(pair: Pair) -> tuple[int, ...]:
    """The numbers (from 0) of the independent columns (dual: rows)."""
    return exact.independent_columns(pair.turned(pair.matrix))


def _row_operations(pair: Pair) -> tuple[Step, ...]:
    matrix = pair.turned(pair.matrix)
    return row_operations(matrix, exact.row_reduction(matrix))


def _values(pair: Pair, part: str) -> dict[str, Any]:
    return {
        "chosen": [j + 1 for j in _chosen(pair)],
        "n": pair.n,
        "part": part,
        "exceptions": rank_exceptions(pair.matrix),
    }
