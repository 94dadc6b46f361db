"""Exact numbers and percentages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node, ScalarNode, scalar

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Number(OptionKind[Any]):
    """An exact number or an expression in parameters, read as a sympy expression; `percent` also allows "14%"."""

    referable: ClassVar[bool] = True

    percent: bool = False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return 'a number, or a percentage such as "14%"' if self.percent else "a number"

    @property
    def schema(self) -> Schema:
        """A number or a text."""
        return VALUE

    @property
    def example(self) -> str:
        """A number."""
        return "14%" if self.percent else "1/2"

    def read(self, node: Node, name: str, context: Context) -> Any:  # noqa: ARG002 - the place says what is wrong
        """Return an expression; "14%" is 7/50."""
        text = scalar(node)
        if not self.percent or not text.text.rstrip().endswith("%"):
            return context.expression(node)
        return context.expression(ScalarNode(node.place, text.text.rstrip().removesuffix("%"), text.style)) / 100
