"""The point that a system is linearized at."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Report, did_you_mean
from solver.systems import Equations
from solver.systems.equations import jet_symbol

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
        known = context.system.functions if isinstance(context.system, Equations) else None
        report = Report()
        values: dict[Symbol, Any] = {}
        for entry in node:
            with report:
                function, order = context.jet(entry.key)
                plain = function.removesuffix("_dot")
                if known is not None and function not in known and plain not in known:
                    message = f"'{function[:40]}' is neither an unknown nor an input of the equations"
                    raise entry.key.fault(message, suggestion=did_you_mean(function, known))
                symbol = jet_symbol((function, order), discrete=context.discrete)
                values[symbol] = context.expression(entry.value)
        report.conclude()
        return values
