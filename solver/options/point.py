"""The point that a system is linearized at."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.named_functions import check_assumed, known_jet, symbol_of
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Report

if TYPE_CHECKING:
    from sympy import Symbol

    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class PointOf(OptionKind["Mapping[Symbol, Any]"]):
    """Values of states and inputs by their names, a derivative as x_dot; or a point that an earlier part found."""

    referable: ClassVar[bool] = True
    item: ClassVar[str] = "point"

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "values of states and inputs by name, or {from: part, point: 1}"

    @property
    def schema(self) -> Schema:
        """A mapping of values."""
        return {"type": "object", "additionalProperties": VALUE, "not": {"required": ["from"]}}

    @property
    def example(self) -> str:
        """A point at rest."""
        return "{x: 0}"

    def read(self, node: Node, name: str, context: Context) -> Mapping[Symbol, Any]:
        """Return the values by the symbols that they are for."""
        if not isinstance(node, MappingNode):
            raise node.fault(f"'{name}' has values of states and inputs, as {{theta: pi, u: 0}}, not {node.what}")
        report = Report()
        values: dict[Symbol, Any] = {}
        for entry in node:
            with report:
                symbol = symbol_of(known_jet(entry.key, context), context)
                values[symbol] = context.expression(entry.value)
                check_assumed(symbol, values[symbol], entry.value)
        report.conclude()
        return values
