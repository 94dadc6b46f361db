"""Intervals in which something is searched."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.jets import jet_symbol
from solver.problem.named_functions import known_jet
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Report

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class Intervals(OptionKind[Mapping[str, Any]]):
    """An interval [a, b] for each of some names, by the names of their symbols; `dynamic` ones are of a system."""

    dynamic: bool = False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "intervals by name"

    @property
    def schema(self) -> Schema:
        """A mapping of pairs."""
        pair = {"type": "array", "items": VALUE, "minItems": 2, "maxItems": 2}
        return {"type": "object", "additionalProperties": pair}

    @property
    def example(self) -> str:
        """An interval."""
        return "{x: [-10, 10]}"

    def read(self, node: Node, name: str, context: Context) -> Mapping[str, Any]:
        """Return the ends of the intervals, numbers in their order."""
        if not isinstance(node, MappingNode):
            raise node.fault(f"'{name}' has intervals by name, as {{x: [-10, 10]}}, not {node.what}")
        report = Report()
        values: dict[str, Any] = {}
        for entry in node:
            with report:
                values[self._name(entry.key, context)] = _ends(entry.value, context)
        report.conclude()
        return values

    def _name(self, node: ScalarNode, context: Context) -> str:
        jet = known_jet(node, context) if self.dynamic else context.jet(node)
        return str(jet_symbol(jet, discrete=context.discrete))


def _ends(node: Node, context: Context) -> tuple[Any, Any]:
    if not isinstance(node, SequenceNode) or len(node.items) != 2:
        raise node.fault("an interval is a list of its two ends, [a, b]")
    low, high = (context.expression(item) for item in node.items)
    for end, item in zip((low, high), node.items, strict=True):
        if not (end.is_number and end.is_real):
            raise item.fault("the end of an interval is a number")
    if not low < high:
        raise node.fault("the first end of an interval is below the second")
    return low, high
