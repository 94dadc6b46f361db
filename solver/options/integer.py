"""Whole numbers within bounds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import OptionKind, Schema
from solver.problem.nodes import Node, whole_number

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Integer(OptionKind[int]):
    """A whole number within bounds; it is read as an int."""

    minimum: int | None = None
    maximum: int | None = None

    @property
    def words(self) -> str:
        """What is written, in words."""
        bounds = [f"from {self.minimum}"] if self.minimum is not None else []
        bounds += [f"{'' if bounds else 'up '}to {self.maximum}"] if self.maximum is not None else []
        return " ".join(["a whole number", *bounds])

    @property
    def schema(self) -> Schema:
        """An integer with its bounds."""
        bounds = {"minimum": self.minimum, "maximum": self.maximum}
        return {"type": "integer", **{key: value for key, value in bounds.items() if value is not None}}

    @property
    def example(self) -> str:
        """The least one."""
        return str(self.minimum if self.minimum is not None else 1)

    def read(self, node: Node, name: str, context: Context) -> int:  # noqa: ARG002 - a number is a number
        """Return the number."""
        return whole_number(node, name, self.minimum, self.maximum)
