"""Inputs as functions of time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import MappingNode, Node
from solver.problem.source import Report, did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class InputFunctions(OptionKind[Mapping[str, Any]]):
    """Functions of time by the names of inputs; a single expression is that of the only input."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "functions of t (in discrete time: of k) by the names of the inputs"

    @property
    def schema(self) -> Schema:
        """A mapping of values, or one value."""
        return {"anyOf": [VALUE, {"type": "object", "additionalProperties": VALUE}]}

    @property
    def example(self) -> str:
        """An input that dies out."""
        return '{u: "exp(-t)"}'

    def read(self, node: Node, name: str, context: Context) -> Mapping[str, Any]:
        """Return the functions by name; names that are no inputs are refused where these are known."""
        known = context.names("input")
        if not isinstance(node, MappingNode):
            if len(known) != 1:
                raise node.fault(f"'{name}' has functions of time by name, as {{u: exp(-t)}}, not {node.what}")
            return {known[0]: context.expression(node, ("t", "k"))}
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
                values[own] = context.expression(entry.value, ("t", "k"))
        report.conclude()
        return values
