"""What stands in a row decides how its signs, bars and names of functions are set."""

from __future__ import annotations

from collections.abc import Sequence

from solver.formula import vocabulary as v
from solver.formula.nodes import Fenced, Function, Node, Operator, Row, Scripts, Space, Symbol, Table, Text

LIMIT_NAMES = frozenset({"lim", "max", "min", "sup", "inf", "det", "gcd", "Pr"})
"""Functions whose index stands below them in display style."""


def base_of(node: Node) -> Node:
    """Return what scripts stand at, or the node itself."""
    return node.base if type(node) is Scripts else node


def has_function(items: Sequence[Node]) -> bool:
    """Whether the name of a function is among the items, perhaps with scripts."""
    return any(type(base_of(item)) is Function for item in items)


def bars(items: Sequence[Node]) -> dict[int, str]:
    """Return the places of bare bars, if their number is even: they open and close in turn."""
    places = [i for i, item in enumerate(items) if isinstance(bar := base_of(item), Operator) and bar.sign in v.BARS]
    return {} if len(places) % 2 else {place: ("prefix", "postfix")[i % 2] for i, place in enumerate(places)}


def is_relation_between_words(items: Sequence[Node]) -> bool:
    """Whether all is text but one operator (verdict = stable): among mere text its own space would be left out."""
    others = [item for item in items if not isinstance(item, Text | Space)]
    return len(others) == 1 and isinstance(others[0], Operator)


def thin_space_between(left: Node | None, right: Node) -> bool:
    """Whether the name of a function keeps its distance from what stands beside it; from a bracket it does not."""
    if left is None:
        return False
    if isinstance(base_of(left), Function):
        return _takes_space(right)
    return isinstance(base_of(right), Function) and _ends_operand(left)


def _takes_space(node: Node) -> bool:
    node = base_of(node)
    if isinstance(node, Row):
        return not node.items or _takes_space(node.items[0])
    if isinstance(node, Fenced):
        return node.tall and len(node.body.items) == 1 and isinstance(node.body.items[0], Table)
    return not isinstance(node, Operator | Space)


def _ends_operand(node: Node) -> bool:
    if isinstance(node, Operator):
        return node.sign in v.CLOSING | {"!"}
    return not (isinstance(node, Space) or node in DOTS)


DOTS = frozenset(Symbol(name) for name in (r"\ldots", r"\cdots", r"\dots"))
