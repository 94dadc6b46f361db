"""Matrices as nodes: what is done to them in the text of an answer, and those that programs have a name for."""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.problem.nodes import Node, ScalarNode, SequenceNode

SPECIAL = re.compile(r"(?:[A-Za-z_]\w*\.)?(diag|eye|zeros|ones|identity)\s*\((.*)\)", re.DOTALL)
"""diag(1, 2), eye(2), zeros(1, 2), ones(2)."""
MOST_PRODUCTS = 200
SIZES = tuple(map(str, range(1, 13)))


def summed(nodes: Sequence[Node], signs: Sequence[str]) -> Node | None:
    """Return the sum of matrices of one size, with their signs; None where they are none."""
    first = nodes[0]
    if isinstance(first, ScalarNode):
        if not all(isinstance(node, ScalarNode) for node in nodes):
            return None
        terms = zip(signs, (node.text for node in nodes if isinstance(node, ScalarNode)), strict=True)
        return ScalarNode(first.place, " + ".join(f"{sign}({text})" for sign, text in terms))
    rows = [node.items for node in nodes if isinstance(node, SequenceNode)]
    if len(rows) != len(nodes) or len({len(row) for row in rows}) != 1:
        return None
    items = [summed(each, signs) for each in zip(*rows, strict=True)]
    return None if None in items else SequenceNode(first.place, tuple(item for item in items if item is not None))


def times(node: Node, before: str, after: str) -> Node:
    """Return the matrix with a factor before and after every entry."""
    if isinstance(node, SequenceNode):
        return SequenceNode(node.place, tuple(times(item, before, after) for item in node.items))
    if not isinstance(node, ScalarNode):
        return node
    factor = before if before in ("", "+", "-", "−") else f"({before})*"
    return ScalarNode(node.place, f"{factor}({node.text}){after}")


def each_called(name: str, node: Node) -> Node:
    """Return the matrix with a function of every entry."""
    if isinstance(node, SequenceNode):
        return SequenceNode(node.place, tuple(each_called(name, item) for item in node.items))
    return ScalarNode(node.place, f"{name}({node.text})") if isinstance(node, ScalarNode) else node


def transposed(node: SequenceNode) -> SequenceNode:
    """Return the columns as rows; a flat list becomes a column."""
    lines = [item.items if isinstance(item, SequenceNode) else None for item in node.items]
    if any(line is None for line in lines):
        return SequenceNode(node.place, tuple(SequenceNode(node.place, (item,)) for item in node.items))
    if len({len(line) for line in lines if line is not None}) > 1:
        return node  # no matrix, as the reader will say
    columns = zip(*(line for line in lines if line is not None), strict=True)
    return SequenceNode(node.place, tuple(SequenceNode(node.place, tuple(column)) for column in columns))


def side_by_side(node: SequenceNode) -> SequenceNode:
    """Return the matrix of columns that stand in a row, [[1; 2], [3; 4]]; any other list as it is."""
    columns = [item.items if isinstance(item, SequenceNode) else () for item in node.items]
    singles = all(isinstance(each, SequenceNode) and len(each.items) == 1 for column in columns for each in column)
    heights = {len(column) for column in columns}
    if len(columns) < 2 or not singles or len(heights) != 1 or min(heights) < 2:
        return node
    return transposed(SequenceNode(node.place, tuple(SequenceNode(node.place, _flat(column)) for column in columns)))


def _flat(column: tuple[Node, ...]) -> tuple[Node, ...]:
    return tuple(each.items[0] for each in column if isinstance(each, SequenceNode))


def special_matrix(name: str, arguments: SequenceNode) -> Node | None:
    """Return the matrix of a name, with its diagonal or its size as arguments; None where they are no size."""
    inner = arguments
    while len(inner.items) == 1 and isinstance(only := inner.items[0], SequenceNode):
        inner = only
    place, items = inner.place, inner.items
    if name == "diag":
        zero = ScalarNode(place, "0")
        blocks: list[list[tuple[Node, ...]]] = [[*_rows(item)] or [(item,)] for item in items]
        width, before = sum(len(block[0]) for block in blocks), 0
        lines = []
        for block in blocks:
            after = width - before - len(block[0])
            lines += [[*[zero] * before, *line, *[zero] * after] for line in block]
            before += len(block[0])
    else:
        sizes = [int(item.text) for item in items if isinstance(item, ScalarNode) and item.text in SIZES]
        if len(sizes) != len(items) or len(sizes) not in (1, 2):
            return None
        lines = [[ScalarNode(place, _entry(name, i, j)) for j in range(sizes[-1])] for i in range(sizes[0])]
    return SequenceNode(place, tuple(SequenceNode(place, tuple(line)) for line in lines))


def diagonal_of(node: SequenceNode) -> tuple[Node, ...]:
    """Return what stands on the diagonal of a diagonal matrix of at least two rows; nothing of anything else."""
    lines = [item.items if isinstance(item, SequenceNode) else () for item in node.items]
    if len(lines) < 2 or any(len(line) != len(lines) for line in lines):
        return ()
    beside = [entry for i, line in enumerate(lines) for j, entry in enumerate(line) if i != j]
    zeros = all(isinstance(entry, ScalarNode) and entry.text.strip() == "0" for entry in beside)
    return tuple(line[i] for i, line in enumerate(lines)) if zeros else ()


def multiplied(first: Node, second: Node) -> Node | None:
    """Return the product of two matrices, None where they have none."""
    left, right = _rows(first), _rows(second)
    if not left or not right or len(left[0]) != len(right) or len(left) * len(right) * len(right[0]) > MOST_PRODUCTS:
        return None
    columns = list(zip(*right, strict=True))
    lines = [[_dot(first, row, column) for column in columns] for row in left]
    return SequenceNode(first.place, tuple(SequenceNode(first.place, tuple(line)) for line in lines))


def entrywise(first: Node, second: Node) -> Node | None:
    """Return the product entry by entry of two matrices of one size; None of others."""
    left, right = _rows(first), _rows(second)
    if not left or [len(row) for row in left] != [len(row) for row in right]:
        return None
    lines = [[_dot(first, (a,), (b,)) for a, b in zip(*pair, strict=True)] for pair in zip(left, right, strict=True)]
    return SequenceNode(first.place, tuple(SequenceNode(first.place, tuple(line)) for line in lines))


def _rows(node: Node) -> list[tuple[ScalarNode, ...]]:
    """The rows of a matrix of texts, a flat list as one row; nothing of anything else."""
    items = node.items if isinstance(node, SequenceNode) else ()
    lines = [item.items if isinstance(item, SequenceNode) else () for item in items]
    if items and not any(lines):
        lines = [items]
    found = [tuple(entry for entry in line if isinstance(entry, ScalarNode)) for line in lines]
    whole = all(len(texts) == len(line) == len(lines[0]) for texts, line in zip(found, lines, strict=True))
    return found if found and whole and found[0] else []


def _dot(node: Node, row: tuple[ScalarNode, ...], column: tuple[ScalarNode, ...]) -> ScalarNode:
    terms = (f"({one.text})*({other.text})" for one, other in zip(row, column, strict=True))
    return ScalarNode(node.place, " + ".join(terms))


def _entry(name: str, i: int, j: int) -> str:
    return "1" if name == "ones" or (name != "zeros" and i == j) else "0"
