"""Expressions in variables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Expression(OptionKind[Any]):
    """An expression, read as sympy's; `variables` are the names with a meaning of their own in it (`t`, `s`, `A`)."""

    referable: ClassVar[bool] = True

    variables: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "an expression" + (f" in {', '.join(self.variables)}" if self.variables else "")

    @property
    def schema(self) -> Schema:
        """A number or a text."""
        return VALUE

    @property
    def example(self) -> str:
        """A function of the first variable."""
        return f"exp(-{self.variables[0]})" if self.variables else "1"

    def read(self, node: Node, name: str, context: Context) -> Any:  # noqa: ARG002 - the place says what is wrong
        """Return the expression."""
        return context.expression(node, self.variables)
