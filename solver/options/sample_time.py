"""The sampling period."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class SampleTime(OptionKind[Any]):
    """A positive number, or a symbol: of one that nothing is said of the reader assumes that it is positive."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "a positive number or a name"

    @property
    def schema(self) -> Schema:
        """A number or a text."""
        return VALUE

    @property
    def example(self) -> str:
        """A number."""
        return "1/10"

    def read(self, node: Node, name: str, context: Context) -> Any:
        """Return an expression that is positive; raises Fault for any other."""
        value = context.expression(node)
        if not value.is_positive:
            note = f"assume that its names are positive, or write one name: {name}: T" if value.free_symbols else ""
            raise node.fault(f"{name} must be positive", note=note)
        return value
