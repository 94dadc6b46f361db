"""The nodes of a value, however it is nested: its rows, its items, its text; errors at their place."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.classroom.reading.latex import NotReadableError
from solver.classroom.reading.spelling import typed
from solver.classroom.reading.units import ForeignUnitError
from solver.problem.expressions import ExpressionError
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode


def rows_of(node: Node, ours: sp.MatrixBase) -> list[Sequence[Node]]:
    """Return the nodes of a matrix row by row; a flat list is a column where ours is one, else a row."""
    if not isinstance(node, SequenceNode):
        return [[node]]
    if len(node.items) == 1 and _holds_rows(node.items[0]):
        return rows_of(node.items[0], ours)
    if any(isinstance(item, SequenceNode) for item in node.items):
        return [item.items if isinstance(item, SequenceNode) else [item] for item in node.items if _filled(item)]
    column = ours.cols == 1 or (ours.rows != 1 and ours.rows == len(node.items))
    return [[item] for item in node.items] if column else [node.items]


def _holds_rows(node: Node) -> bool:
    return isinstance(node, SequenceNode) and bool(node.items) and all(isinstance(i, SequenceNode) for i in node.items)


def _filled(node: Node) -> bool:
    return not isinstance(node, SequenceNode) or bool(node.items)


def is_trivial(node: Node) -> bool:
    """Whether a matrix without columns is meant, the basis of the trivial space: [], {} or {0}."""
    if isinstance(node, MappingNode):
        return not node.entries
    if not isinstance(node, SequenceNode) or any(map(_filled, node.items)) is False:
        return isinstance(node, SequenceNode)
    return node.braces and [typed(item) for item in node.items] in (["0"], ["[0]"])


def flat(items: Sequence[Node]) -> list[Node]:
    """Return the items of a list whose rows are lists, [-1; -2] or [[-1, -2]]."""
    return [each for item in items for each in (flat(item.items) if isinstance(item, SequenceNode) else [item])]


def labelled(entry: Entry) -> list[Node]:
    """Return the entry {λ_1: -1} of a mapping as an item with its label, {-1: 2} as an item that stands there twice."""
    key, value = entry.key.text.strip(), typed(entry.value).strip()
    if not key[:1].isalpha() or any(sign in key for sign in "+-*/"):
        times = int(value) if value.isdigit() and len(value) < 3 else 0
        return [ScalarNode(entry.key.place, key, "quoted")] * times or [entry.value]
    return [ScalarNode(entry.value.place, f"{key} = {value}", "quoted")]


def lower(node: Node) -> str:
    """Return a text in lower case, "" of anything else."""
    return node.text.strip().lower() if isinstance(node, ScalarNode) else ""


def only(node: Node) -> Node:
    """Return the one value of a list of one value, as of a matrix of one entry."""
    while isinstance(node, SequenceNode) and len(node.items) == 1:
        node = node.items[0]
    return node


def are_single(node: Node) -> bool:
    """Whether a list holds one value in each of its items, [3], [[3]], or is a text."""
    return all(
        isinstance(only(each), ScalarNode) for each in (node.items if isinstance(node, SequenceNode) else [node])
    )


def text_of(node: Node) -> str:
    """Return the text of a node; raises Fault where there is none."""
    if not isinstance(node, ScalarNode) or node.is_null:
        raise node.fault(f"a value is expected here, not {node.what}")
    return node.text


class At:
    """Turns an error in an expression into a fault at its place; `inside` the value where its text is as written."""

    def __init__(self, node: Node, *, inside: bool = True) -> None:
        self.node = node
        self.inside = inside

    def __enter__(self) -> None:
        return None

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if isinstance(error, NotReadableError | ForeignUnitError):
            raise self.node.fault(str(error)) from None
        if isinstance(error, ExpressionError) and isinstance(self.node, ScalarNode):
            note = f"write {error.suggestion}" if error.suggestion else ""
            if not self.inside:
                raise self.node.fault(error.message, note=note) from None
            raise self.node.fault_inside(error.message, error.at, error.length, note=note) from None
