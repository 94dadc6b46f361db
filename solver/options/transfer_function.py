"""Transfer functions of one channel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class TransferFunctionOption(OptionKind[Any]):
    """A transfer function in any of the spellings of a system, read as a rational function in lowest terms."""

    referable: ClassVar[bool] = True

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "a transfer function"

    @property
    def schema(self) -> Schema:
        """An expression, or numerator and denominator, or zeros, poles and gain."""
        return {"anyOf": [VALUE, {"$ref": "#/$defs/ZerosPolesGain"}, {"$ref": "#/$defs/Fraction"}]}

    @property
    def example(self) -> str:
        """A lag."""
        return "1/(s + 1)"

    def read(self, node: Node, name: str, context: Context) -> Any:  # noqa: ARG002 - the place says what is wrong
        """Return the rational function."""
        return context.transfer_function(node)
