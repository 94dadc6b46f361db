"""Intervals of the real axis as students write them: (-oo, -2], [-1, 0]; [[-1, 0]]; s < -2 or -1 < s < 0."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import sympy as sp

from solver.classroom.reading.spelling import typed
from solver.problem.nodes import Node, ScalarNode

if TYPE_CHECKING:
    from solver.classroom.reading.texts import TextReader

NAME = "sigma"
_BETWEEN = re.compile(
    r"([\])\[])\s*(?:,|;|\band\b|\bund\b|\bor\b|\boder\b|\bU\b|\+)\s*(?=[\[(\]]|Interval\b)", re.IGNORECASE
)


def are_intervals(ours: Any) -> bool:
    """Whether our own answer is a list of intervals."""
    return isinstance(ours, list | tuple) and bool(ours) and all(isinstance(each, sp.Interval) for each in ours)


def segments(node: Node, texts: TextReader) -> list[Any]:
    """Return the intervals in a text, or in a list of texts or of pairs of ends; raises Fault."""
    text = _without_quotes(typed(node)).strip()
    if _is_list(text):
        text = text[1:-1].strip()
    return _in_text(node, text, texts)


def _without_quotes(text: str) -> str:
    return text.replace('"', "").replace("'", "")


def _is_list(text: str) -> bool:
    """Whether the outermost brackets are those of a list of intervals."""
    inside = text[1:-1].strip()
    return text[:1] == "[" and text[-1:] == "]" and ((inside[:1] in ("[", "]", "(") and inside[-1:] in ("]", "[", ")"))
                                                     or inside.startswith("Interval"))  # fmt: skip


def _in_text(node: Node, text: str, texts: TextReader) -> list[Any]:
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
