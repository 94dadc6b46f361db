"""Names of parameters and states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node, SequenceNode, scalar
from solver.problem.source import did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Names(OptionKind[tuple[str, ...]]):
    """A list of names: parameters, or states by name or number."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "a list of names"

    @property
    def schema(self) -> Schema:
        """A name or a list of names."""
        return VALUES

    @property
    def example(self) -> str:
        """A parameter."""
        return "[k]"

    def read(self, node: Node, name: str, context: Context) -> tuple[str, ...]:  # noqa: ARG002 - the place says it
        """Return the names; unknown ones are refused where the system is known."""
        items = node.items if isinstance(node, SequenceNode) else (node,)
        words = tuple(scalar(item).text for item in items)
        if not words:
            raise node.fault("the list is empty")
        known, numbers = context.names_in_the_system()
        for item, word in zip(items, words, strict=True):
            if known is not None and word not in known and word not in numbers:
                note = f"it has: {', '.join(known)}" if known else ""
                message = f"'{word[:40]}' is no name in the system"
                raise item.fault(message, suggestion=did_you_mean(word, known), note=note)
        for position, item in enumerate(items):
            if words[position] in words[:position]:
                raise item.fault(f"'{words[position]}' is given twice")
        return words
