"""Matrices of a shape that the plant decides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from solver.derivation.options import OptionKind, Schema
from solver.problem.nodes import Node
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.problem.context import Context
    from solver.systems import System

SIZES = {"n": 2, "m": 1, "p": 1}
"""States, inputs and outputs of the plant in examples."""


@dataclass(frozen=True, slots=True)
class MatrixOf(OptionKind["ImmutableMatrix"]):
    """A matrix. `rows` and `columns` are numbers or the system's "n", "m" (inputs), "p" (outputs); None is any.

    `flat` says what a flat list stands for: "row" or "column".
    """

    referable: ClassVar[bool] = True

    rows: int | str | None = None
    columns: int | str | None = None
    flat: str = "row"

    @property
    def words(self) -> str:
        """What is written, in words."""
        rows, columns = ("any" if size is None else str(size) for size in (self.rows, self.columns))
        size = "" if self.rows is None and self.columns is None else f" {rows}×{columns}"
        return f"a matrix{size}; a flat list is a {self.flat}"

    @property
    def schema(self) -> Schema:
        """Lists of values, in a list."""
        return {"$ref": "#/$defs/Matrix"}

    @property
    def example(self) -> str:
        """A part of the identity, which suits as a weight and as a transformation."""
        rows, columns = (
            SIZES[size] if isinstance(size, str) else size or SIZES["n"] for size in (self.rows, self.columns)
        )
        entries = [[str(int(i == j)) for j in range(columns)] for i in range(rows)]
        return "[" + ", ".join(f"[{', '.join(row)}]" for row in entries) + "]"

    def read(self, node: Node, name: str, context: Context) -> ImmutableMatrix:
        """Return a matrix of the shape asked for; a flat list of the right length fits a column or a row."""
        return context.matrix(node, name, (self.rows, self.columns), self.flat)

    def misfit(self, name: str, value: ImmutableMatrix, system: System) -> Reason | None:
        """Return what shape the system asks for, where the matrix has another one."""
        sizes = (system.size(of) if isinstance(of, str) else of for of in (self.rows, self.columns))
        wanted = tuple(own if size is None else size for size, own in zip(sizes, value.shape, strict=True))
        if wanted == value.shape:
            return None
        return Reason("engine/misfit", {"name": name, "shape": value.shape, "wanted": wanted})
