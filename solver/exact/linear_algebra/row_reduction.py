"""Row reduction with its operations recorded, over any field; null spaces, column and row spaces.

Rows are numbered from 0. Entries are elements of K (sympy domain elements) or of L = K[x]/(p) (`Algebraic`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Any

Rows = tuple[tuple[Any, ...], ...]


@dataclass(frozen=True, slots=True)
class Swap:
    """R_i ↔ R_j; of columns where `line` is "C"."""

    i: int
    j: int
    line: str = "R"


@dataclass(frozen=True, slots=True)
class Scale:
    """R_i ← c R_i; of columns where `line` is "C"."""

    i: int
    factor: Any
    line: str = "R"


@dataclass(frozen=True, slots=True)
class Add:
    """R_i ← R_i + c R_j; of columns where `line` is "C"."""

    i: int
    j: int
    factor: Any
    line: str = "R"


Operation = Swap | Scale | Add


@dataclass(frozen=True)
class PivotStage:
    """What is done for one pivot: the operations in their order, and the rows (or the matrix) before and after them."""

    row: int
    column: int
    operations: tuple[Operation, ...]
    before: Rows
    after: Any

    @property
    def exchange(self) -> str:
        """Why rows are exchanged: the entry is "zero", or another makes no "fractions"; else nothing."""
        if not isinstance(self.operations[0], Swap):
            return ""
        return "fractions" if self.before[self.row][self.column] else "zero"


@dataclass(frozen=True)
class RowReduction:
    """The reduced row echelon form, its pivot columns and its history: `stages[k]` stands before `operations[k]`."""

    reduced: Rows
    pivots: tuple[int, ...]
    operations: tuple[Operation, ...]
    stages: tuple[Rows, ...]

    def by_pivot(self) -> list[PivotStage]:
        """The operations, those for one pivot together."""
        found, k = [], 0
        for r, group in groupby(self.operations, key=_pivot_row):
            operations = tuple(group)
            before, after = self.stages[k], self.stages[k := k + len(operations)]
            found.append(PivotStage(r, self.pivots[r], operations, before, after))
        return found

    def mapped(self, convert: Callable[[Any], Any]) -> RowReduction:
        """The same reduction with every element converted, to expressions say."""

        def rows(M: Rows) -> Rows:
            return tuple(tuple(convert(a) for a in row) for row in M)

        operations = tuple(
            operation if isinstance(operation, Swap) else replace(operation, factor=convert(operation.factor))
            for operation in self.operations
        )
        return RowReduction(rows(self.reduced), self.pivots, operations, tuple(rows(M) for M in self.stages))


def row_reduce(rows: Rows) -> RowReduction:
    """Gauss–Jordan elimination; of the possible pivots it takes ±1 first, for shorter arithmetic with a pen."""
    M = [list(row) for row in rows]
    columns = len(M[0]) if M else 0
    operations: list[Operation] = []
    stages: list[Rows] = [_frozen(M)]
    pivots: list[int] = []

    def apply(operation: Operation) -> None:
        carry_out(M, operation)
        operations.append(operation)
        stages.append(_frozen(M))

    for column in range(columns):
        r = len(pivots)
        candidates = [i for i in range(r, len(M)) if M[i][column]]
        if not candidates:
            continue
        pivot = min(candidates, key=lambda i: (not _is_unit(M[i][column]), i))
        if pivot != r:
            apply(Swap(r, pivot))
        one = M[r][column] / M[r][column]
        if M[r][column] != one:
            apply(Scale(r, one / M[r][column]))
        for i in range(len(M)):
            if i != r and M[i][column]:
                apply(Add(i, r, -M[i][column]))
        pivots.append(column)
        if len(pivots) == len(M):
            break
    return RowReduction(_frozen(M), tuple(pivots), tuple(operations), tuple(stages))


def _pivot_row(operation: Operation) -> int:
    return operation.j if isinstance(operation, Add) else operation.i


def _is_unit(a: Any) -> bool:
    one = a / a
    return a in (one, -one)


def _frozen(M: list[list[Any]]) -> Rows:
    return tuple(tuple(row) for row in M)


def carry_out(M: list[list[Any]], operation: Operation) -> None:
    """Do the operation to the rows of M, which are changed."""
    match operation:
        case Swap(i, j):
            M[i], M[j] = M[j], M[i]
        case Scale(i, factor):
            M[i] = [factor * a for a in M[i]]
        case Add(i, j, factor):
            M[i] = [a + factor * b for a, b in zip(M[i], M[j], strict=True)]


def null_space(reduction: RowReduction, one: Any) -> list[tuple[Any, ...]]:
    """A basis of {v : M v = 0}, one vector a free column; `one` is the one of the field."""
    columns = len(reduction.reduced[0]) if reduction.reduced else 0
    zero = one - one
    basis = []
    for free in (j for j in range(columns) if j not in reduction.pivots):
        vector = [zero] * columns
        vector[free] = one
        for row, pivot in enumerate(reduction.pivots):
            vector[pivot] = -reduction.reduced[row][free]
        basis.append(tuple(vector))
    return basis
