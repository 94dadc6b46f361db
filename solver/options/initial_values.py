"""Values of unknowns and of their derivatives at the beginning."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.named_functions import known_jet
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Report

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class InitialValues(OptionKind["Mapping[tuple[str, int], Any]"]):
    """Values by the names of unknowns (a derivative x' or x_dot, a sample y(0), y(-1)); what is not named is zero."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "values of unknowns and their derivatives by name"

    @property
    def schema(self) -> Schema:
        """A mapping of values."""
        return {"type": "object", "additionalProperties": VALUE}

    @property
    def example(self) -> str:
        """A start away from zero."""
        return "{x: 1}"

    def read(self, node: Node, name: str, context: Context) -> Mapping[tuple[str, int], Any]:
        """Return the values by function and order of the derivative."""
        if not isinstance(node, MappingNode):
            raise node.fault(f"'{name}' has values by name, as {{x: 1, \"x'\": 0}}, not {node.what}")
        report = Report()
        values: dict[tuple[str, int], Any] = {}
        for entry in node:
            with report:
                values[known_jet(entry.key, context, samples=True)] = context.expression(entry.value)
        report.conclude()
        return values
