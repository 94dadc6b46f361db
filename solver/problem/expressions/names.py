"""What names mean in an expression."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

from solver.problem.expressions.notation import CONSTANTS
from solver.problem.expressions.syntax import Name, Node

if TYPE_CHECKING:
    import sympy as sp


MATRIX = "A"
"""The variable that stands for a matrix, where one is declared."""


@dataclass(frozen=True)
class Names:
    """What names mean; keys are in plain spelling (`lamda`, `omega_n`; see `canonical_name`).

    A name is looked up in this order:
    `variables`: names to which the task gives a meaning (`s`, `z`, `t`, `k`, `A`);
    `functions`: functions of time, e.g. `x` is `Function("x")(t)`; only they take primes and arguments, x'' or x(k+2);
    `values`: what to put in place of a name;
    `symbols`: declared symbols with their assumptions;
    then the constants. Any other name is a real symbol if `open`, and an error otherwise.
    `impulses`: whether an impulse takes primes too, δ'(t).
    """

    symbols: Mapping[str, sp.Symbol] = field(default_factory=dict)
    variables: Mapping[str, Any] = field(default_factory=dict)
    values: Mapping[str, Any] = field(default_factory=dict)
    functions: Mapping[str, Any] = field(default_factory=dict)
    open: bool = True
    impulses: bool = False

    def declares(self, name: str) -> bool:
        """Whether the problem or the task gives the name a meaning."""
        return any(name in table for table in (self.variables, self.functions, self.values, self.symbols))

    def is_matrix(self, node: Node) -> bool:
        """Whether a part of an expression is the matrix A of which a function is asked, by itself."""
        return isinstance(node, Name) and node.name == MATRIX and MATRIX in self.variables

    def is_constant(self, name: str) -> bool:
        """Whether the name is a constant of the notation: pi, e, j, inf, unless the problem declares it."""
        return name in CONSTANTS and not self.declares(name)

    def known(self) -> list[str]:
        """Return all names with a meaning, constants included, sorted."""
        return sorted({*self.variables, *self.functions, *self.values, *self.symbols, *CONSTANTS})

    def like(self, name: str) -> str:
        """Return the known name most like this one, or an empty text."""
        return next(iter(get_close_matches(name, self.known(), 1)), "")
