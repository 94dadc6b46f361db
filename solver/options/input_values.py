"""Constant values of inputs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.named_functions import check_assumed
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Report, did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class InputValues(OptionKind[Mapping[str, Any]]):
    """Values of inputs by their names; an input that is not named keeps its symbol."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "values of inputs by name"

    @property
    def schema(self) -> Schema:
        """A mapping of values."""
        return {"type": "object", "additionalProperties": VALUE}

    @property
    def example(self) -> str:
        """An input that is zero."""
        return "{u: 0}"

    def read(self, node: Node, name: str, context: Context) -> Mapping[str, Any]:
        """Return the values by name; names that are no inputs are refused where these are known."""
        if not isinstance(node, MappingNode):
            raise node.fault(f"'{name}' has values by name, as {{u: 0}}, not {node.what}")
        known = context.names("input")
        report = Report()
        values: dict[str, Any] = {}
        for entry in node:
            with report:
                own = entry.key.text
                if own not in known and (known or context.has_no_inputs):
                    message = f"'{own[:40]}' is no input of the system"
                    note = (
                        f"its inputs are: {', '.join(known)}"
                        if known
                        else f"name it beside the equations: inputs: [{own[:40]}]"
                    )
                    raise entry.key.fault(message, suggestion=did_you_mean(own, known), note=note)
                values[own] = context.expression(entry.value)
                if own in context.lexicon.symbols:
                    check_assumed(context.lexicon.symbols[own], values[own], entry.value)
        report.conclude()
        return values
