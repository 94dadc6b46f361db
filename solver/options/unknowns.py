"""What equations are solved for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.named_functions import known_jet, symbol_of
from solver.problem.nodes import Node, ScalarNode, SequenceNode, scalar
from solver.problem.source import Report

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Unknowns(OptionKind["tuple[Symbol, ...]"]):
    """A list of names, read as a tuple of symbols; of a system `dynamic` ones may be derivatives, x' or x_dot."""

    dynamic: bool = False

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
        """An unknown."""
        return "[x]"

    def read(self, node: Node, name: str, context: Context) -> tuple[Symbol, ...]:  # noqa: ARG002 - the place says it
        """Return the symbols in their order."""
        items = node.items if isinstance(node, SequenceNode) else (node,)
        if not items:
            raise node.fault("the list is empty")
        report = Report()
        found: list[Any] = []
        for item in items:
            with report:
                symbol = self._symbol(scalar(item), context)
                if symbol in found:
                    raise item.fault(f"'{scalar(item).text[:40]}' is given twice")
                found.append(symbol)
        report.conclude()
        return tuple(found)

    def _symbol(self, node: ScalarNode, context: Context) -> Any:
        return symbol_of(known_jet(node, context), context) if self.dynamic else context.symbol(node)
