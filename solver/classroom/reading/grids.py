"""Matrices as nodes: what is done to them in the text of an answer, and those that programs have a name for."""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import matching
from solver.problem.nodes import Node, ScalarNode, SequenceNode

SPECIAL = re.compile(r"(?:[A-Za-z_]\w*\.)?(diag|eye|zeros|ones|identity)\s*\((.*)\)", re.DOTALL)
"""diag(1, 2), eye(2), zeros(1, 2), ones(2)."""
NEAR = 40
"""Characters before a sign that are looked at."""
SIZES = tuple(map(str, range(1, 13)))


def scaled(text: str) -> tuple[str, str, str] | None:
    """Return the factors before and after the one matrix of a text, 1/2 [1 2] or [1 2]/2; None where there are none."""
    start = next((at for at in _outside(text) if text[at] == "["), -1)
    if start < 0:
        return None
    end = matching(text, start)
    before, after = text[:start].strip().rstrip("*·×").strip(), text[end + 1 :].strip()
    bare = not any(sign in before + after for sign in "[]{},;=")
    called = text[:start][-1:].isalpha()  # Sin[t] of Mathematica
    if not bare or called or not (before or after) or end == len(text) or before[-1:] in ("/", "^"):
        return None
    if (after and after[0] not in "*/") or _is_sum(before) or _is_sum(after):
        return None  # of 2 + 4 [3 1] only 4 is a factor
    return before, text[start : end + 1], after


def _is_sum(text: str) -> bool:
    """Whether a text has a sign between two terms: 2 + 4, but not -4, e^-t, 2*-3, 1e-3."""
    return any(text[at] in "+-−±" and _joins_terms(text, at) for at in _outside(text))


def _joins_terms(text: str, at: int) -> bool:
    """Whether a sign stands between two terms; not at the beginning, after an operator, or in 1e-3."""
    before = text[max(0, at - NEAR) : at].rstrip()
    exponent = before[-1:] in ("e", "E") and before[-2:-1].isdigit()
    return bool(before) and before[-1] not in "*/^·×(,=" and not exponent


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


def terms_of(text: str) -> tuple[list[str], list[str]]:
    """Return the terms of a sum in each of which a matrix stands, and their signs; nothing of anything else."""
    terms, signs, start = [], [], 0
    depth = 0
    for at, sign in enumerate(text):
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0 and sign in "+-−" and _joins_terms(text, at):
            terms.append(text[start:at])
            start = at
    terms = [term.strip() for term in [*terms, text[start:]]]
    signs = ["-" if term[:1] in "-−" else "" for term in terms]
    bare = [term.lstrip("+-−").strip() for term in terms]
    matrices = all(term.endswith("]") or "[" in term for term in bare)
    return (bare, signs) if len(bare) > 1 and matrices else ([], [])


def _outside(text: str) -> list[int]:
    """The places of a text that stand in no round bracket."""
    places, at = [], 0
    while at < len(text):
        if text[at] == "(":
            at = matching(text, at)
        else:
            places.append(at)
        at += 1
    return places


def times(node: Node, before: str, after: str) -> Node:
    """Return the matrix with a factor before and after every entry."""
    if isinstance(node, SequenceNode):
        return SequenceNode(node.place, tuple(times(item, before, after) for item in node.items))
    if not isinstance(node, ScalarNode):
        return node
    factor = before if before in ("", "+", "-", "−") else f"({before})*"
    return ScalarNode(node.place, f"{factor}({node.text}){after}")


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
        lines = [[item if i == j else zero for j in range(len(items))] for i, item in enumerate(items)]
    else:
        sizes = [int(item.text) for item in items if isinstance(item, ScalarNode) and item.text in SIZES]
        if len(sizes) != len(items) or len(sizes) not in (1, 2):
            return None
        lines = [[ScalarNode(place, _entry(name, i, j)) for j in range(sizes[-1])] for i in range(sizes[0])]
    return SequenceNode(place, tuple(SequenceNode(place, tuple(line)) for line in lines))


def _entry(name: str, i: int, j: int) -> str:
    return "1" if name == "ones" or (name != "zeros" and i == j) else "0"
