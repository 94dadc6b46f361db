"""Which signs of a row are written before a term, and which between two."""

from __future__ import annotations

from solver.formula.nodes import Function, Node, Operator, Scripts, Space
from solver.formula.vocabulary import CLOSING

SIGNS = frozenset(("+", "-", r"\pm", r"\mp"))
_ENDS_OPERAND = CLOSING | {"!", "|"}


class Signs:
    """Looks at the items of one row from left to right; one that goes on from before has `begun`."""

    def __init__(self, begun: bool = False) -> None:
        self.begun = begun
        self.last: Node | None = None  # that is no space

    def is_prefix(self, item: Node) -> bool:
        """Whether the next item is a sign before a term: `-1`, `a = -b`; after a gap at the beginning it is not."""
        prefix = isinstance(item, Operator) and item.sign in SIGNS and not self._after_operand()
        self.begun = True
        if not isinstance(item, Space):
            self.last = item
        return prefix

    def _after_operand(self) -> bool:
        last = self.last.base if isinstance(self.last, Scripts) else self.last
        if last is None:
            return self.begun
        if isinstance(last, Operator):
            return last.sign in _ENDS_OPERAND
        return not isinstance(last, Function)
