"""Yes or no."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import ImpliedKind, Schema
from solver.problem.nodes import Node, ScalarNode, shown

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Flag(ImpliedKind[bool]):
    """`true` or `false`; false is meant where nothing is said."""

    @property
    def implied(self) -> bool:
        """A flag that is not raised."""
        return False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "true or false"

    @property
    def schema(self) -> Schema:
        """A truth value."""
        return {"type": "boolean"}

    @property
    def example(self) -> str:
        """A flag is written where it is raised."""
        return "true"

    def read(self, node: Node, name: str, context: Context) -> bool:  # noqa: ARG002 - a truth value is one
        """Return the truth value; `yes` and `no` are texts."""
        truth = node.truth if isinstance(node, ScalarNode) else None
        if truth is None:
            raise node.fault(f"{name} must be true or false, not {shown(node)}")
        return truth
