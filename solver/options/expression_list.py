"""Expressions, one or several."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node, SequenceNode
from solver.problem.source import Report

if TYPE_CHECKING:
    from sympy import Expr

    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class ExpressionList(OptionKind["tuple[Expr, ...]"]):
    """An expression, or a list of them (one an input, say), read as a tuple."""

    referable: ClassVar[bool] = True

    variables: tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "an expression or a list of them" + (f", in {', '.join(self.variables)}" if self.variables else "")

    @property
    def schema(self) -> Schema:
        """A value or a list of values."""
        return VALUES

    @property
    def example(self) -> str:
        """A function of the first variable."""
        return f"exp(-{self.variables[0]})" if self.variables else "1"

    def read(self, node: Node, name: str, context: Context) -> tuple[Expr, ...]:  # noqa: ARG002 - the place says it
        """Return the expressions in their order."""
        items = node.items if isinstance(node, SequenceNode) else (node,)
        if not items:
            raise node.fault("the list is empty")
        report = Report()
        values: list[Any] = []
        for item in items:
            with report:
                values.append(context.expression(item, self.variables))
        report.conclude()
        return tuple(values)
