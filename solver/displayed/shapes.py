"""The shapes of formulas, of block matrices too; an identity or a zero takes the shape of its place."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.displayed.tree import Unreadable
from solver.matrices import identity
from solver.stated import Stated

Shape = tuple[int, int] | None
"""Rows and columns; None for what takes the shape that its place asks for: the identity I, and 0."""

SCALAR = (1, 1)
OF_A_MATRIX = frozenset({"determinant", "trace", "rank"})


def shape_of(value: Any) -> Shape:
    """Return the shape of a value or stated formula."""
    if isinstance(value, sp.MatrixBase):
        return int(value.rows), int(value.cols)
    if not isinstance(value, Stated):
        return SCALAR
    return _of_stated(value.operation, value.operands)


def _of_stated(operation: str, operands: Sequence[Any]) -> Shape:
    if operation in OF_A_MATRIX:
        return SCALAR
    if operation == "matrix_of":
        columns, *entries = operands
        return len(entries) // columns, columns
    if operation == "transpose":
        shape = shape_of(operands[0])
        return shape and shape[::-1]
    if operation == "product":
        return of_product([shape_of(factor) for factor in operands])
    if operation in ("total", "difference"):
        return next((shape for shape in map(shape_of, operands) if shape != SCALAR), SCALAR)
    return shape_of(operands[0])


def of_product(shapes: Sequence[Shape]) -> Shape:
    """Return the shape of a product of factors with these shapes."""
    matrices = [shape for shape in shapes if shape is not None and shape != SCALAR]
    if matrices:
        return matrices[0][0], matrices[-1][1]
    return None if None in shapes else SCALAR


def complete(sizes: list[int], whole: int) -> None:
    """Fill in the one size that is open."""
    if sizes.count(0) == 1:
        sizes[sizes.index(0)] = whole - sum(sizes)


@lru_cache(maxsize=256)
def selections(sizes: tuple[int, ...]) -> list[Any]:
    """Return the columns of the identity that belong to each of some blocks of rows with these heights."""
    whole, starts = identity(sum(sizes)), [sum(sizes[:i]) for i in range(len(sizes))]
    return [whole[:, start : start + size] for start, size in zip(starts, sizes, strict=True)]


def known(shape: Shape) -> tuple[int, int]:
    """Return a shape that must be known. Raises Unreadable."""
    if shape is None:
        raise Unreadable("the size of an identity or zero matrix is open")
    return shape
