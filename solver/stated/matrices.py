"""Operations on a matrix: its determinant, inverse, rank and what else has a name."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.formula.building import as_factor, is_matrix, over, parenthesized, power, row, walk
from solver.formula.nodes import Fenced, Fraction, Row, Table
from solver.stated.declaration import Printer, Show, Stated, operation


def determinant(matrix: Any) -> Stated:
    """det M of a square matrix."""
    return Stated("determinant", (matrix,))


def adjugate(matrix: Any) -> Stated:
    """adj M, the transposed matrix of cofactors."""
    return Stated("adjugate", (matrix,))


def partitioned(matrix: Any, rows: Sequence[int], columns: Sequence[int]) -> Stated:
    """M itself, drawn with lines after some rows and columns (counted from 1, e.g. (2,) and (2,))."""
    return Stated("partitioned", (matrix, tuple(rows), tuple(columns)))


def rank(matrix: Any) -> Stated:
    """rank M; with parameters the generic one."""
    return Stated("rank", (matrix,))


def trace(matrix: Any) -> Stated:
    """tr M."""
    return Stated("trace", (matrix,))


def inverse(matrix: Any) -> Stated:
    """M⁻¹."""
    return Stated("inverse", (matrix,))


def transpose(matrix: Any) -> Stated:
    """Mᵀ."""
    return Stated("transpose", (matrix,))


def minor(matrix: Any, row: int, column: int) -> Stated:
    """The determinant of M without a row and a column (counted from 1)."""
    return Stated("minor", (matrix, row, column))


def cofactor(matrix: Any, row: int, column: int) -> Stated:
    """(−1)^{i+j} times the minor of row i and column j (counted from 1)."""
    return Stated("cofactor", (matrix, row, column))


def matrix_of(rows: Sequence[Sequence[Any]]) -> Stated:
    """The matrix with these entries, which may be formulas; rows of one length."""
    return Stated("matrix_of", (len(rows[0]), *(entry for line in rows for entry in line)))


def kronecker(left: Any, right: Any) -> Stated:
    """A ⊗ B: the blocks aᵢⱼ B."""
    return Stated("kronecker", (left, right))


def entrywise_product(left: Any, right: Any) -> Stated:
    """A ∘ B of two matrices of one shape: the products of the entries at the same place."""
    return Stated("entrywise_product", (left, right))


def vectorized(matrix: Any) -> Stated:
    """vec M: the columns of M below each other."""
    return Stated("vectorized", (matrix,))


def _named(operator: str) -> Printer:
    """An operator before a matrix: `det [..]`, `adj(..)`."""

    def write(show: Show, matrix: Any) -> Row:
        return row(operator, _argument(show(matrix)))

    return write


def _argument(shown: Row) -> Row:
    return shown if is_matrix(shown) else row(parenthesized(shown))


operation(determinant)(_named(r"\det"))
operation(adjugate)(_named(r"\operatorname{adj}"))
operation(rank)(_named(r"\operatorname{rank}"))
operation(trace)(_named(r"\operatorname{tr}"))
operation(vectorized)(_named(r"\operatorname{vec}"))


@operation(partitioned)
def _partitioned(show: Show, matrix: Any, rows: Any, columns: Any) -> Row:
    """Return the matrix with lines; those at its edges are left out, and brackets alone need no array."""
    whole = show(matrix)
    across = tuple(i for i in sorted(set(rows)) if 0 < i < matrix.rows)
    letters = "".join("c|" if 0 < j < matrix.cols and j in columns else "c" for j in range(1, matrix.cols + 1))
    table = whole.items[0]
    if not isinstance(table, Table) or not (across or "|" in letters):
        return whole
    return row(Fenced("[", row(Table("array", table.rows, letters, across)), "]", tall=True))


@operation(inverse)
def _inverse(show: Show, matrix: Any) -> Row:
    """Return the matrix with the exponent −1; one entry alone as a fraction, unless it is one itself."""
    if getattr(matrix, "shape", None) != (1, 1):
        return power(show(matrix), row("-1"))
    entry = show(matrix[0, 0])
    if any(isinstance(node, Fraction) for node in walk(entry)):
        return power(entry, row("-1"))
    return row("1") if matrix[0, 0] == 1 else over(row("1"), entry)


@operation(transpose)
def _transpose(show: Show, matrix: Any) -> Row:
    return power(show(matrix), row("T"))


@operation(minor)
def _minor(show: Show, matrix: Any, i: int, j: int) -> Row:
    return row(rf"\operatorname{{minor}}_{{{i}{j}}}", _argument(show(matrix)))


@operation(cofactor)
def _cofactor(show: Show, matrix: Any, i: int, j: int) -> Row:
    return row(rf"\operatorname{{cof}}_{{{i}{j}}}", _argument(show(matrix)))


@operation(matrix_of)
def _matrix_of(show: Show, columns: int, *entries: Any) -> Row:
    """Return the matrix; one entry alone stands without brackets."""
    if len(entries) == 1:
        return show(*entries)
    cells = [show(entry) for entry in entries]
    return row(Table("bmatrix", tuple(tuple(cells[i : i + columns]) for i in range(0, len(cells), columns))))


@operation(kronecker)
def _kronecker(show: Show, left: Any, right: Any) -> Row:
    return row(as_factor(show(left)), r"\otimes", as_factor(show(right)))


@operation(entrywise_product)
def _entrywise_product(show: Show, left: Any, right: Any) -> Row:
    return row(as_factor(show(left)), r"\circ", as_factor(show(right)))
