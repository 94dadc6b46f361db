"""Diagonal matrices of any shape, and their diagonals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


def diagonal_of(answer: Any, shape: tuple[int, int]) -> list[Any] | None:
    """The diagonal of a matrix, or the list itself; None where the shape is wrong or an entry stands beside it."""
    if not isinstance(answer, sp.MatrixBase):
        return list(answer) if len(answer) == min(shape) else None
    entries = enumerate(answer.flat())
    beside = any(entry != 0 for at, entry in entries if at // answer.cols != at % answer.cols)
    return None if answer.shape != shape or beside else [answer[i, i] for i in range(min(shape))]


def on_the_diagonal(entries: Sequence[Any], shape: tuple[int, int]) -> ImmutableMatrix:
    """The matrix with these entries on its diagonal."""
    return sp.ImmutableMatrix(*shape, lambda i, j: entries[i] if i == j and i < len(entries) else 0)
