"""Poles of several channels: a list for each, or one flat list that is taken channel by channel."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from solver.derivation.options import VALUES, OptionKind, Schema
from solver.problem.nodes import Node, SequenceNode
from solver.problem.source import Report

if TYPE_CHECKING:
    from sympy import Expr

    from solver.problem.context import Context

ChannelList = tuple[Any, ...]
"""Poles, or for each channel a tuple of them."""


@dataclass(frozen=True, slots=True)
class ChannelPoles(OptionKind[ChannelList]):
    """Poles closed under conjugation, in a list for each output of the system or in a flat one."""

    referable: ClassVar[bool] = True

    @property
    def words(self) -> str:
        """What is written, in words."""
        return 'a list of poles for each channel, or a flat list, "-3 ± 2j" for a pair'

    @property
    def schema(self) -> Schema:
        """A value or a list of values, or lists of values in a list."""
        lists = {"type": "array", "items": {"type": "array", "items": VALUES}}
        return {"anyOf": [VALUES, lists]}

    @property
    def example(self) -> str:
        """Those of a chain of order two."""
        return "[[-1, -2]]"

    def read(self, node: Node, name: str, context: Context) -> ChannelList:
        """Return the poles in their order: one tuple, or a tuple for each channel."""
        items = node.items if isinstance(node, SequenceNode) else ()
        lists = [item for item in items if isinstance(item, SequenceNode)]
        if not lists:
            return context.conjugate_list(node)
        single = next((item for item in items if not isinstance(item, SequenceNode)), None)
        if single is not None:
            note = "write [[-1], [-2, -3]], or one flat list"
            raise single.fault(f"'{name}' has a list for each channel here, but this is {single.what}", note=note)
        channels = context.size("p")
        if channels is not None and len(lists) != channels:
            raise node.fault(f"'{name}' has {len(lists)} lists, but the system has {_outputs(channels)}")
        report = Report()
        found: list[tuple[Expr, ...]] = []
        for item in lists:
            with report:
                found.append(context.conjugate_list(item))
        report.conclude()
        return tuple(found)


def _outputs(number: int) -> str:
    return f"{number} output{'s' if number > 1 else ''}"
