"""How much of what a part displays is evaluated: a bound by size, the same on every machine."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from solver.matrices import entries
from solver.stated import Stated

MOST_NODES = 50_000
"""Different subexpressions evaluated for the displays of one part; 308 is the most in the course, chapters 3, 4."""


@dataclass
class Budget:
    """Counts the subexpressions of formulas, each once: the evaluation keeps the values of those that it has seen."""

    left: int = MOST_NODES
    seen: set[Any] = field(default_factory=set)

    def allows(self, formulas: Iterable[Any]) -> bool:
        """Whether formulas may still be evaluated; what they need is spent, also where it is too much."""
        todo = list(formulas)
        while todo and self.left > 0:
            node = todo.pop()
            if isinstance(node, sp.Basic):
                if node in self.seen:
                    continue
                self.seen.add(node)
            self.left -= 1
            todo += _parts(node)
        return self.left > 0


def _parts(node: Any) -> Iterable[Any]:
    if isinstance(node, Stated):
        return node.operands
    if isinstance(node, sp.Basic):
        return node.args
    return entries(node) if isinstance(node, sp.MatrixBase) else ()
