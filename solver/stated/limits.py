"""Limits."""

from __future__ import annotations

from typing import Any, Literal

from solver.formula.pieces import as_factor
from solver.stated.declaration import Binding, Show, Stated, operation

Side = Literal["", "+", "-"]


def limit(function: Any, variable: Any, value: Any, side: Side = "") -> Stated:
    """The limit of f(x) where x goes to `value` (finite, ∞ or −∞), from above ("+"), from below ("-") or both."""
    return Stated("limit", (function, variable, value, side))


@operation(limit, binding=Binding(1))
def _limit(show: Show, function: Any, variable: Any, value: Any, side: Side) -> str:
    goal = show(value) + (f"^{{{side}}}" if side else "")
    return rf"\lim_{{{show(variable)} \to {goal}}}{as_factor(show(function))}"
