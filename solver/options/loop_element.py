"""What stands in a loop beside the plant: a controller, or what is in the feedback path."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node, ScalarNode, SequenceNode

if TYPE_CHECKING:
    from solver.problem.context import Context

NONE, UNITY = "none", "unity"
WORDS = {NONE, UNITY, "unit", "negative", "positive", "yes", "no", "true", "false", "open", "closed"}
"""What someone may write of a loop who means no parameter of that name."""


@dataclass(frozen=True, slots=True)
class LoopElement(OptionKind[Any]):
    """A quotient of polynomials in s (discrete: z), proper or not, or a matrix of them; `words` may stand for one.

    The value is an expression or a matrix, 1 for the word "unity" and None for "none".
    """

    referable: ClassVar[bool] = True

    switched: bool = False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return ("unity, none, " if self.switched else "") + "an expression in s (discrete: z) or a matrix of them"

    @property
    def schema(self) -> Schema:
        """A number or a text, or rows of them."""
        return {"anyOf": [VALUE, {"type": "array", "items": {"type": "array", "items": VALUE}}]}

    @property
    def example(self) -> str:
        """The simplest loop."""
        return UNITY if self.switched else "2"

    def read(self, node: Node, name: str, context: Context) -> Any:
        """Return the element, None where there is none; a word that may not stand here is no parameter's name."""
        word = node.text if isinstance(node, ScalarNode) else ""
        if self.switched and word in (NONE, UNITY):
            return None if word == NONE else context.quotient(node, unity=True)
        if word.lower() in WORDS:
            also = f", {NONE} or {UNITY}" if self.switched else f", or leave '{name}' out"
            raise node.fault(f"'{word}' cannot stand for the {name}", note=f"write an expression{also}")
        if isinstance(node, SequenceNode):
            return context.quotients(node, name)
        return context.quotient(node)
