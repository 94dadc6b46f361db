"""What equations are solved for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node, ScalarNode, SequenceNode, scalar
from solver.problem.source import Report, did_you_mean
from solver.systems import Equations
from solver.systems.equations import jet_symbol

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
                symbol = _jet(scalar(item), context) if self.dynamic else context.symbol(scalar(item))
                if symbol in found:
                    raise item.fault(f"'{scalar(item).text[:40]}' is given twice")
                found.append(symbol)
        report.conclude()
        return tuple(found)


def _jet(node: ScalarNode, context: Context) -> Any:
    """A state or an input; what is neither is refused where the system is known."""
    system = context.system
    function, order = context.jet(node)
    plain = function
    for ending in ("_dot", "_ddot", "_dddot"):
        plain = plain.removesuffix(ending)
    if isinstance(system, Equations):
        known = (*system.unknowns, *system.inputs)
        if function not in known and plain not in known:
            message = f"'{function[:40]}' is neither a state nor an input"
            raise node.fault(message, suggestion=did_you_mean(function, known))
    return jet_symbol((function, order), discrete=context.discrete)
