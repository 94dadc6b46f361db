"""The name of one parameter, of the system or of a gain that is put before it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.problem.nodes import Node, scalar
from solver.problem.source import did_you_mean
from solver.symbols import MEANINGS

if TYPE_CHECKING:
    from solver.problem.context import Context


@dataclass(frozen=True, slots=True)
class ParameterName(OptionKind[str]):
    """A name; one that the system does not have is allowed only where it has none at all."""

    @property
    def words(self) -> str:
        """What is written, in words."""
        return "a name"

    @property
    def schema(self) -> Schema:
        """A name."""
        return VALUE

    @property
    def example(self) -> str:
        """A gain."""
        return "K"

    def read(self, node: Node, name: str, context: Context) -> str:  # noqa: ARG002 - the place says it
        """Return the name; raises Fault where it is none, where it has a value, or where the system has others."""
        symbol = context.symbol(scalar(node))
        if symbol.name in MEANINGS:
            raise node.fault(f"'{symbol.name}' cannot be a parameter: {MEANINGS[symbol.name]}")
        known = None if context.system is None or context.around is None else context.names_in_the_system()[0]
        found = {each.name for each in getattr(context.system, "parameters", ())} | set(context.around or ())
        if known is not None and found and symbol.name not in found:
            listed = sorted(found)
            message = f"'{symbol.name[:40]}' is no parameter of the system"
            raise node.fault(message, suggestion=did_you_mean(symbol.name, listed), note=f"it has: {', '.join(listed)}")
        return str(symbol.name)
