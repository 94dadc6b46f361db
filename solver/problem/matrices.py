"""Matrices from lists of rows, and what is wrong with their shape in words."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import sympy as sp

from solver.problem.lexicon import BARRED, Lexicon
from solver.problem.nodes import Node, ScalarNode, SequenceNode
from solver.problem.source import Report

MAX_SIZE = 12


def read_matrix(
    node: Node, name: str, lexicon: Lexicon, flat: str = "", barred: Mapping[str, str] = BARRED
) -> sp.ImmutableMatrix:
    """Return a matrix: [[1, 2], [3, 4]], a single number for 1×1, or a flat list as a "row" or a "column" (`flat`).

    Raises Fault for entries that can't be read, rows of different length, and more than 12 rows or columns.
    """
    return read_entries(node, name, lambda item: lexicon.expression(item, barred=barred), flat)


def read_entries(node: Node, name: str, read: Callable[[Node], sp.Expr], flat: str = "") -> sp.ImmutableMatrix:
    """Return the matrix whose entries are read so; raises Fault as `read_matrix` does."""
    rows = _rows(node, name, flat)
    _check_rows(rows, node, name)
    report = Report()
    entries: list[sp.Expr] = []
    for row in rows:
        for item in row:
            with report:
                entries.append(read(item))
    report.conclude()
    return sp.ImmutableMatrix(len(rows), len(rows[0]), entries)


def _rows(node: Node, name: str, flat: str) -> list[Sequence[Node]]:
    """Return the nodes of the entries, row by row."""
    if not isinstance(node, SequenceNode):
        return [[node]]
    items = node.items
    if any(isinstance(item, SequenceNode) for item in items):
        rows: list[Sequence[Node]] = []
        for number, item in enumerate(items, 1):
            if not isinstance(item, SequenceNode):
                raise item.fault(f"row {number} of {name} must be a list like the other rows")
            rows.append(item.items)
        return rows
    if flat == "column":
        return [[item] for item in items]
    if flat == "row" or len(items) == 1:
        return [items]
    raise node.fault(f"{name} must be a list of rows, such as [[1, 2], [3, 4]]")


def _check_rows(rows: Sequence[Sequence[Node]], node: Node, name: str) -> None:
    """Refuse what is empty, too large, or has rows of different length."""
    if not rows or not rows[0]:
        raise node.fault(f"{name} is empty")
    if len(rows) > MAX_SIZE or len(rows[0]) > MAX_SIZE:
        raise node.fault(f"{name} is {len(rows)}×{len(rows[0])}; at most {MAX_SIZE} rows and columns can be read")
    lengths = [len(row) for row in rows]
    usual = len(rows) if len(rows) in lengths else lengths[0]
    for number, row in enumerate(rows, 1):
        if len(row) != usual and isinstance(node, SequenceNode):
            what = f"{name} has {len(rows)} rows" if usual == len(rows) else f"row 1 of {name} has {usual} entries"
            raise node.items[number - 1].fault(f"{what}, row {number} has {counted(len(row), 'entry', 'entries')}")


def counted(number: int, one: str, many: str) -> str:
    """Return a count with its noun: "1 row", "2 rows"."""
    return f"{number} {one if number == 1 else many}"


def expect_shape(M: sp.ImmutableMatrix, shape: tuple[int | None, int | None], node: Node, name: str, like: str) -> None:
    """Raise Fault unless M has the rows and columns asked for (None: any number); `like` says whose they are."""
    rows, columns = shape
    if rows is not None and M.rows != rows:
        raise node.fault(f"{name} must have {counted(rows, 'row', 'rows')}{like}, it has {M.rows}")
    if columns is not None and M.cols != columns:
        raise node.fault(f"{name} must have {counted(columns, 'column', 'columns')}{like}, it has {M.cols}")


def is_flat(node: Node) -> bool:
    """Whether the node is a flat list or a single value."""
    return isinstance(node, ScalarNode) or (
        isinstance(node, SequenceNode) and not any(isinstance(item, SequenceNode) for item in node.items)
    )
