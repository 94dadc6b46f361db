"""Equations between expressions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node, SequenceNode, scalar
from solver.problem.source import Report

if TYPE_CHECKING:
    from sympy import Expr

    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Relations(OptionKind["tuple[tuple[Expr, Expr], ...]"]):
    """A list of equations, each left = right or an expression that is zero, read as pairs of sides."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "a list of equations, left = right"

    @property
    def schema(self) -> Schema:
        """A text or a list of texts."""
        return VALUES

    @property
    def example(self) -> str:
        """Two linear equations."""
        return '["x + y = 3", "x - y = 1"]'

    def read(self, node: Node, name: str, context: Context) -> tuple[tuple[Expr, Expr], ...]:  # noqa: ARG002 - the place says it
        """Return the sides of each equation."""
        items = node.items if isinstance(node, SequenceNode) else (node,)
        if not items:
            raise node.fault("the list is empty")
        report = Report()
        found: list[Any] = []
        for item in items:
            with report:
                left, right = context.relation(scalar(item))
                if left == right:
                    raise item.fault("both sides of this equation are the same")
                found.append((left, right))
        report.conclude()
        return tuple(found)
