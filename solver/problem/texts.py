"""The texts of a problem, Markdown with `$math$`: their formulas must be of the dialect that every format can draw."""

from __future__ import annotations

from collections.abc import Iterator

from solver.markup import math_problems
from solver.problem.nodes import MappingNode, Node, ScalarNode
from solver.problem.source import Diagnostic, Fault, Report, Source

ADVICE = "formulas stand between dollar signs; a dollar sign itself is written \\$"


def check_texts(root: MappingNode, source: Source, report: Report) -> None:
    """Report what is wrong with the formulas of the statement and of the parts' prompts."""
    for node in _texts(root):
        for offset, message in math_problems(node.text):
            with report:
                raise _fault(node, offset, message, source)


def _texts(root: MappingNode) -> Iterator[ScalarNode]:
    """The nodes of all texts."""
    find = root.get("find")
    parts = [entry.value for entry in find] if isinstance(find, MappingNode) else []
    holders: list[tuple[Node | None, str]] = [(root, "statement"), *((part, "prompt") for part in parts)]
    for holder, key in holders:
        node = holder.get(key) if isinstance(holder, MappingNode) else None
        if isinstance(node, ScalarNode):
            yield node


def _fault(node: ScalarNode, offset: int, message: str, source: Source) -> Fault:
    """Return the fault at the place of the formula: in a block (statement: |) by the line it stands on."""
    message = f"in a formula: {message}"
    before, _, _ = node.text[:offset].rpartition("\n")
    number = node.text[:offset].count("\n")
    words = node.text.split("\n")[number]
    column = source.line(node.place.line + 1 + number).find(words) if node.style == "block" and words else -1
    if column < 0:
        return node.fault_inside(message, offset, 1, note=ADVICE)
    inside = offset - len(before) - bool(number)
    return Fault(Diagnostic(message, node.place.line + 1 + number, column + inside + 1, 1, note=ADVICE))
