"""Row operations, those for one pivot together, and what the reduced rows say of the unknowns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


@where_exact
def row_operations(start: ImmutableMatrix, reduction: exact.RowReduction | None) -> tuple[Step, ...]:
    """From the matrix to its reduced row echelon form; none where there is nothing to do."""
    return tuple(_row_operations(start, reduction)) if reduction and reduction.operations else ()


@where_exact
def null_vectors(reduction: exact.RowReduction, chosen: Sequence[ImmutableMatrix]) -> tuple[Step, ...]:
    """M v = 0: the pivot unknowns by the free ones, and for each of these the vector with its chosen scale."""
    return tuple(_null_vectors(reduction, chosen))


@lemma("arithmetic/row_operations")
def _row_operations(start: ImmutableMatrix, reduction: exact.RowReduction) -> Derivation[None]:
    stages = [replace(stage, after=sp.ImmutableMatrix(stage.after)) for stage in reduction.by_pivot()]
    unclaimed = "the row operations are checked by what they lead to"
    yield Step("row_operations", detail="tutor", unclaimed=unclaimed, start=start, stages=stages)


@lemma("arithmetic/row_operations")
def _null_vectors(reduction: exact.RowReduction, chosen: Sequence[ImmutableMatrix]) -> Derivation[None]:
    width = len(reduction.reduced[0])
    free = [j for j in range(width) if j not in reduction.pivots]
    unknowns = sp.symbols(f"x_1:{width + 1}")
    solved = [
        (unknowns[j], sp.Add(*(-row[k] * unknowns[k] for k in free)))
        for j, row in zip(reduction.pivots, reduction.reduced, strict=False)
    ]
    scaled = [_scaled(reduction, j, vector) for j, vector in zip(free, chosen, strict=True)]
    yield Step(
        "null_vectors",
        detail="tutor",
        claims={
            f"scale{i}": Claim(product(factor, basis), vector, Phrase("the scale of a vector"))
            for i, (factor, basis, vector) in enumerate(scaled, 1)
        },
        solved=solved,
        free=[unknowns[j] for j in free],
        scales=[
            (unknowns[j], factor, "fractions" if any(map(_has_denominator, basis.flat())) else "")
            for j, (factor, basis, _) in zip(free, scaled, strict=True)
        ],
    )


def _scaled(reduction: exact.RowReduction, free: int, vector: ImmutableMatrix) -> tuple[Expr, ImmutableMatrix, Any]:
    """The factor by which the vector differs from that with the free unknown one and the others zero, and both."""
    entries = [sp.Integer(int(j == free)) for j in range(vector.rows)]
    for j, row in zip(reduction.pivots, reduction.reduced, strict=False):
        entries[j] = -row[free]
    return vector[free, 0], sp.ImmutableMatrix(entries), vector


def _has_denominator(entry: Expr) -> bool:
    return bool(sp.fraction(sp.together(entry))[1] != 1)
