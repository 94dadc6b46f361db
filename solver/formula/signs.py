"""Which signs of a row are written before a term, and which between two."""

from __future__ import annotations

from collections.abc import Sequence

from solver.formula.nodes import Function, Node, Operator, Scripts, Space, Text
from solver.formula.vocabulary import CLOSING

SIGNS = frozenset(("+", "-", r"\pm", r"\mp"))
_ENDS_OPERAND = CLOSING | {"!", "|"}


def is_prefix(items: Sequence[Node], place: int, begun: bool = False) -> bool:
    """Whether an item is a sign before a term: `-1`, `a = -b`.

    After a gap at the beginning of the row it is not, nor where the row has `begun` before its first item.
    """
    item = items[place]
    if type(item) is not Operator or item.sign not in SIGNS:
        return False
    for i in range(place - 1, -1, -1):
        if type(items[i]) is not Space:
            return not _ends_operand(items[i])
    return place == 0 and not begun


def _ends_operand(node: Node) -> bool:
    base = node.base if isinstance(node, Scripts) else node
    if isinstance(base, Operator):
        return base.sign in _ENDS_OPERAND
    if isinstance(base, Text):
        return not base.words.endswith(":")
    return not isinstance(base, Function)
