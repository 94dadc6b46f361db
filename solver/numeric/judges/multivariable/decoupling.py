"""Decoupling judged: where inputs act on outputs, by ranks, and what polynomial a decoupled channel has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.numeric.evaluation.ranks import rank


@dataclass(frozen=True)
class Acting:
    """For each output the first r with c A^{r−1} B ≠ 0 (0 where D has the row, None where there is none), those rows.

    `matrix` has them (p×m), zero where there is none.
    """

    degrees: tuple[int | None, ...]
    matrix: Any

    @property
    def decouples(self) -> bool:
        """Whether the rows are independent, at random values of the parameters."""
        return None not in self.degrees and rank(self.matrix) == self.matrix.rows

    @property
    def rows_apart(self) -> Any:
        """The rows, each in a block of its own: the rank falls where one of them vanishes."""
        rows = [self.matrix.row(i) for i, r in enumerate(self.degrees) if r is not None]
        return sp.ImmutableMatrix(sp.diag(*rows)) if rows else sp.ImmutableMatrix(0, 0, [])


def acting_inputs(A: Any, B: Any, C: Any, D: Any) -> Acting:
    """Return how often each output is differentiated until an input acts on it, and how the inputs act then."""
    found = [_first(A, B, C.row(i), D.row(i)) for i in range(C.rows)]
    return Acting(tuple(r for r, _ in found), sp.ImmutableMatrix(sp.Matrix.vstack(*(row for _, row in found))))


def _first(A: Any, B: Any, c: Any, d: Any) -> tuple[int | None, Any]:
    row, states = sp.Matrix(d), sp.Matrix(c)
    for r in range(A.rows + 1):
        if rank(sp.ImmutableMatrix(row)):
            return r, row
        row, states = (states * B).applyfunc(sp.expand), (states * A).applyfunc(sp.expand)
    return None, sp.zeros(1, B.cols)


def channel_polynomials(degrees: Sequence[int], poles: Sequence[Any] | None, x: Any) -> list[Any] | None:
    """Return Π (x − p) for each channel: x^r without poles, else of a list a channel or of a flat list.

    None where the poles do not fit the relative degrees.
    """
    if poles is None:
        return [x**r for r in degrees]
    listed = [list(each) for each in poles] if poles and isinstance(poles[0], tuple | list) else None
    if listed is None:
        flat, ends = list(poles), [sum(degrees[: i + 1]) for i in range(len(degrees))]
        listed = [flat[end - r : end] for r, end in zip(degrees, ends, strict=True)]
        if len(flat) != sum(degrees):
            return None
    if [len(each) for each in listed] != list(degrees):
        return None
    return [sp.Mul(*(x - pole for pole in each)) for each in listed]


def system_matrix_of(A: Any, B: Any, C: Any, D: Any, x: Any) -> Any:
    """Return [xI − A, −B; C, D]."""
    blocks = [[x * sp.eye(A.rows) - A, -sp.Matrix(B)], [sp.Matrix(C), sp.Matrix(D)]]
    return sp.ImmutableMatrix(sp.Matrix(sp.BlockMatrix(blocks).as_explicit()))
