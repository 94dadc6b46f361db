"""Intervals of the real axis as students write them: (-oo, -2], [-1, 0]; [[-1, 0]]; s < -2 or -1 < s < 0."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import sympy as sp

from solver.classroom.reading.nodes import text_of
from solver.problem.nodes import Node, ScalarNode, SequenceNode

if TYPE_CHECKING:
    from solver.classroom.reading.texts import TextReader

NAME = "sigma"
ENDS = 2
_BETWEEN = re.compile(r"([\])\[])\s*(?:,|;|\band\b|\bund\b|\bor\b|\boder\b|\bU\b|\+)\s*(?=[\[(\]]|Interval\b)", re.IGNORECASE)


def segments(node: Node, texts: TextReader) -> list[Any]:
    """Return the intervals in a text, or in a list of texts or of pairs of ends; raises Fault."""
    if not isinstance(node, SequenceNode):
        return _in_text(node, text_of(node), texts)
    if len(node.items) == ENDS and not any(isinstance(item, SequenceNode) or _is_interval(item) for item in node.items):
        return [_between(node, texts)]
    return [each for item in node.items for each in _of_item(item, texts)]


def _is_interval(node: Node) -> bool:
    return isinstance(node, ScalarNode) and any(sign in node.text for sign in "[]<>≤≥,;")


def _of_item(item: Node, texts: TextReader) -> list[Any]:
    if isinstance(item, SequenceNode) and len(item.items) == ENDS:
        return [_between(item, texts)]
    return segments(item, texts)


def _between(pair: SequenceNode, texts: TextReader) -> Any:
    """The interval of two ends, which are counted in."""
    return _in_text(pair, f"[{text_of(pair.items[0])}, {text_of(pair.items[1])}]", texts)[0]


def _in_text(node: Node, text: str, texts: TextReader) -> list[Any]:
    text = text.strip()
    if text.startswith("[[") and text.endswith("]]"):
        text = text[1:-1]
    united = _BETWEEN.sub(r"\1 ∪ ", text)
    condition = texts.condition(ScalarNode(node.place, united, "quoted"), NAME)
    symbols = list(condition.free_symbols)
    if len(symbols) != 1:
        raise node.fault("intervals of the real axis are expected here, such as [-2, -1]")
    (x,) = symbols
    real = sp.Symbol("x", real=True)
    found = condition.xreplace({x: real}).as_set()
    parts = found.args if isinstance(found, sp.Union) else (found,)
    if not all(isinstance(part, sp.Interval) for part in parts):
        raise node.fault("intervals of the real axis are expected here, such as [-2, -1]")
    return list(parts)
