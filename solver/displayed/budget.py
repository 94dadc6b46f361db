"""How much of what a part displays is evaluated: a bound by size, the same on every machine."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from solver.matrices import entries
from solver.stated import Stated

MOST_NODES = 5_000
"""Different subexpressions evaluated for the displays of one part; 270 is the most in the problems of the project."""


COSTS = {
    **dict.fromkeys(("integral", "convolution", "laplace", "inverse_laplace", "inverse_z", "z_transform", "limit"), 50),
    **dict.fromkeys(("exponential", "convolution_sum", "summation", "sum_over_roots", "derivative"), 10),
}
"""Operations that evaluate their operands at many points, as so many subexpressions."""


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
                met = len(self.seen)
                self.seen.add(node)
                if len(self.seen) == met:  # it was there: expressions are hashed only once so
                    continue
                self.left -= 1
                todo += node.args
            elif isinstance(node, Stated):
                self.left -= COSTS.get(node.operation, 1)
                todo += node.operands
            else:
                self.left -= 1
                todo += entries(node) if isinstance(node, sp.MatrixBase) else ()
        return self.left > 0
