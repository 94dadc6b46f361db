"""The rank of the controllability or observability matrix: by its determinant where it is square, else by rows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.arithmetic.determinants import expanded, first_line
from solver.arithmetic.row_operations import row_operations
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.matrices import determinant, rank
from solver.tasks.linear_algebra.characteristic_polynomial import shape_of
from solver.tasks.structure.pairs import Pair
from solver.tasks.structure.rank_exceptions import rank_exceptions

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


LARGEST_EXPANDED = 4
"""The determinant of a larger matrix is not expanded."""


@dataclass(frozen=True)
class Rank:
    """What the test found; `determinant` is None where the matrix is not square, `exceptions` without parameters."""

    matrix: ImmutableMatrix
    determinant: Any
    rank: int
    exceptions: list[Any] | None


@lemma("rank_test")
def rank_of(pair: Pair) -> Derivation[Rank]:
    """Build the matrix block by block, find its rank, and the parameters for which this is lower."""
    matrix = pair.matrix
    yield _matrix(pair, matrix)
    det = None
    if matrix.rows == matrix.cols:
        det = sp.factor(exact.determinant(matrix))
        spread = exact.multiplied_out(det)
        yield Step(
            "determinant",
            claims={"value": Claim(determinant(matrix), det, "determinant"), **expansion(matrix)},
            steps=expanded(matrix, spread) if expansion(matrix) else (),
            dual=pair.dual,
            det=det,
            spread=spread,
            n=pair.n,
            zero_row=has_zero_row(matrix),
            **shape_of(matrix),
        )
    r = exact.rank(matrix)
    if not det:
        yield _reduction(pair, matrix, r)
    exceptions = None
    if pair.parameters:
        exceptions = rank_exceptions(matrix)
        yield Step(
            "exceptions",
            unclaimed="the conditions are checked with the answers",
            exceptions=exceptions,
            dual=pair.dual,
            det=det,
            r=r,
            n=pair.n,
        )
    yield Step(
        "verdict",
        claims={"rank": Claim(rank(matrix), sp.Integer(r), "rank")},
        dual=pair.dual,
        r=r,
        n=pair.n,
        generic=bool(exceptions),
    )
    return Rank(matrix, det, r, exceptions)


def expansion(matrix: ImmutableMatrix) -> dict[str, Claim]:
    """The first line of a small determinant; none for a large one, or where a row of zeros says it all."""
    if not 2 <= matrix.rows <= LARGEST_EXPANDED or has_zero_row(matrix):
        return {}
    return {"stated": Claim(determinant(matrix), first_line(matrix), "the determinant multiplied out")}


def has_zero_row(matrix: ImmutableMatrix) -> bool:
    """Whether a row of zeros shows that the determinant is zero."""
    return any(matrix.row(i).is_zero_matrix for i in range(matrix.rows))


@lemma("rank_test")
def matrix_of(pair: Pair) -> Derivation[ImmutableMatrix]:
    """The controllability (observability) matrix, block by block."""
    matrix = pair.matrix
    yield _matrix(pair, matrix)
    return matrix


@lemma("rank_test")
def rank_in_short(pair: Pair) -> Derivation[Rank]:
    """The matrix and its rank, where another test has given the verdict."""
    matrix = pair.matrix
    det = sp.factor(exact.determinant(matrix)) if matrix.rows == matrix.cols else None
    r = exact.rank(matrix)
    claims = {"rank": Claim(rank(matrix), sp.Integer(r), "rank")}
    if det is not None:
        claims["determinant"] = Claim(determinant(matrix), det, "determinant")
    exceptions = rank_exceptions(matrix) if pair.parameters else None
    yield Step("agreement", claims=claims, pair=pair, matrix=matrix, exceptions=exceptions, r=r, n=pair.n)
    return Rank(matrix, det, r, exceptions)


def _matrix(pair: Pair, matrix: ImmutableMatrix) -> Step:
    """The matrix, block by block."""
    return Step(
        "matrix",
        claims=pair.block_claims,
        unclaimed="for one state there is nothing to multiply",
        names=pair.names,
        entries=pair.block_entries,
        matrix=matrix,
        pair=pair,
        n=pair.n,
    )


def _reduction(pair: Pair, matrix: ImmutableMatrix, r: int) -> Step:
    """Row operations on the matrix (of the dual: too) leave as many rows as the rank."""
    reduction = exact.row_reduction(matrix)
    reduced = sp.ImmutableMatrix(reduction.reduced)
    return Step(
        "reduction",
        claims={"rank": Claim(rank(matrix), rank(reduced), "row operations leave the rank as it is")},
        steps=row_operations(matrix, reduction),
        reduced=reduced,
        pivots=[j + 1 for j in reduction.pivots],
        r=r,
        dual=pair.dual,
    )
