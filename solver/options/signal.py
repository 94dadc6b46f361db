"""Signals that act on a loop: a usual one by its name, or a function of time."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation.options import VALUE, OptionKind, Schema
from solver.lazy import sympy as sp
from solver.problem.nodes import Node, ScalarNode
from solver.problem.source import did_you_mean

if TYPE_CHECKING:
    from solver.problem.context import Context

POWERS = {"step": 0, "ramp": 1, "parabola": 2}
"""The usual ones by name, n of tⁿ/n!."""


TIME = re.compile(r"(?<![A-Za-z_])t(?![A-Za-z_0-9])")
"""The letter t by itself: 4t is 4·t."""


@dataclass(frozen=True, slots=True)
class Signal(OptionKind[Any]):
    """The unit step, the unit ramp t, the unit parabola t²/2, or an expression in t; the value is the expression.

    In discrete time the ramp is kT, the parabola (kT)²/2, with `period()` for T, and expressions are in k; a function
    of t is allowed there where a signal may be `sampled`.
    """

    sampled: bool = False

    @property
    def words(self) -> str:
        """What is written, in words."""
        return f"{', '.join(POWERS)}, or an expression in t (discrete: k)"

    @property
    def schema(self) -> Schema:
        """A number or a text."""
        return VALUE

    @property
    def example(self) -> str:
        """A ramp."""
        return "ramp"

    def read(self, node: Node, name: str, context: Context) -> Any:
        """Return the function of time; a word that is nearly one of the names is no parameter."""
        word = node.text if isinstance(node, ScalarNode) else ""
        if word in POWERS:
            n = POWERS[word]
            time = sp.Symbol("k") * period() if context.discrete else sp.Symbol("t")
            return time**n / sp.factorial(n)
        if word.isalpha() and (meant := did_you_mean(word.lower(), POWERS)):
            raise node.fault(f"{name} must be {self.words}, not '{word}'", suggestion=meant)
        if self.sampled and context.discrete and TIME.search(word):
            return context.expression(node, ("t",))
        return context.expression(node, ("t", "k"))


def period() -> Any:
    """Return what stands for the sampling period in the usual signals: it is written T, and no parameter is."""
    return sp.Dummy("T", dummy_index=1)
