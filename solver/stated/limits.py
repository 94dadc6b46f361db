"""Limits."""

from __future__ import annotations

from typing import Any, Literal

from solver.formula.building import as_factor, row
from solver.formula.nodes import Function, Row, Scripts
from solver.stated.declaration import Binding, Show, Stated, operation

Side = Literal["", "+", "-"]


def limit(function: Any, variable: Any, value: Any, side: Side = "") -> Stated:
    """The limit of f(x) where x goes to `value` (finite, ∞ or −∞), from above ("+"), from below ("-") or both."""
    return Stated("limit", (function, variable, value, side))


@operation(limit, binding=Binding(1))
def _limit(show: Show, function: Any, variable: Any, value: Any, side: Side) -> Row:
    *before, goal = show(value).items
    reached = Scripts(goal, None, row(side)) if side else goal
    return row(Scripts(Function("lim"), row(show(variable), r"\to", *before, reached)), as_factor(show(function)))
