"""Row operations one by one, for the tutor's level of detail; and the parameters that lower a rank."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


@lemma("row_operations")
def row_operations_of(start: ImmutableMatrix, reduction: exact.RowReduction) -> Derivation[None]:
    """From the matrix to its reduced row echelon form."""
    stages = [
        (operation, sp.ImmutableMatrix(stage))
        for operation, stage in zip(reduction.operations, reduction.stages[1:], strict=True)
    ]
    yield Step(
        "row_operations",
        detail="tutor",
        unclaimed="the row operations are checked by what they lead to",
        start=start,
        stages=stages,
    )


def row_operations(start: ImmutableMatrix, reduction: exact.RowReduction | None) -> tuple[Step, ...]:
    """The same as a substep; none where there is nothing to do."""
    return tuple(row_operations_of(start, reduction)) if reduction and reduction.operations else ()


def rank_exceptions(matrix: ImmutableMatrix) -> list[Any] | None:
    """Return the conditions on parameters under which the rank is lower; None if they cannot be found."""
    try:
        return list(exact.rank_conditions(matrix))
    except exact.NotExact:
        return None
