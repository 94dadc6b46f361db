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
    r"([\])\[])\s*(?:,\s*(?:and|und)?|;|\band\b|\bund\b|\bor\b|\boder\b|\bU\b|\+|&)\s*(?=[\[(\]]|Interval\b)",
    re.IGNORECASE,
)

_AND = re.compile(r"\s*(?:\band\b|\bund\b|&&?|∧|,|;)\s*", re.IGNORECASE)
_END = r"([-+−]?\s*(?:\d+(?:\.\d+)?(?:/[1-9]\d*)?|∞|inf|oo))"
_RANGE = re.compile(rf"\b(?:between|from|zwischen|von)\s+{_END}\s+(?:and|to|und|bis)\s+{_END}", re.IGNORECASE)
_LEFT = re.compile(rf"\b(?:to the )?(?:left of|links von)\s+{_END}", re.IGNORECASE)
_RIGHT = re.compile(rf"\b(?:to the )?(?:right of|rechts von)\s+{_END}", re.IGNORECASE)
_REAL_PART = re.compile(r"\\?\bRe\s*[({]?\s*s\s*[)}]?")
_SPACED = re.compile(r"(?<=[\[(])\s*([-+−]?(?:\d[\d.]*|inf|∞|oo))\s+([-+−]?(?:\d[\d.]*|inf|∞|oo))\s*(?=[\])])")
"""[-2 0] of MATLAB."""
_TURNED = re.compile(rf"([\[(\]])\s*{_END}\s*[,;]\s*{_END}\s*([\])\[])")
_MIRRORED = {"[": "]", "]": "[", "(": ")", ")": "("}
_PART = re.compile(r"^\s*(?:the )?(?:real )?(?:axis|part|segments?)\s+(?=[\[(])", re.IGNORECASE)


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


def _set_of(node: Node, text: str, texts: TextReader) -> sp.Set:
    condition = texts.condition(ScalarNode(node.place, text, "quoted"), NAME)
    symbols = list(condition.free_symbols)
    if condition is sp.false:
        return sp.S.EmptySet
    if len(symbols) != 1:
        raise node.fault("intervals of the real axis are expected here, such as [-2, -1]")
    return condition.xreplace({symbols[0]: sp.Symbol("x", real=True)}).as_set()


def _in_words(text: str) -> str:
    """Intervals for "between 0 and -1, left of -2"."""

    def between(found: re.Match[str]) -> str:
        ends = sorted(found.groups(), key=_size)
        return f"[{ends[0]}, {ends[1]}]"

    def rising(found: re.Match[str]) -> str:
        left, one, other, right = found.groups()
        if _size(one) <= _size(other):
            return found[0]
        return f"{_MIRRORED[right]}{other}, {one}{_MIRRORED[left]}"

    text = _TURNED.sub(rising, _SPACED.sub(r"\1, \2", _REAL_PART.sub("s", text)))
    text = _PART.sub("", _RANGE.sub(between, text))
    return _RIGHT.sub(r"[\1, ∞)", _LEFT.sub(r"(-∞, \1]", text))


def _size(number: str) -> float:
    bare = number.replace("−", "-").replace("∞", "inf").replace("oo", "inf").replace(" ", "")
    above, _, below = bare.partition("/")
    return float(above) / float(below or 1)


def _in_text(node: Node, text: str, texts: TextReader) -> list[Any]:
    united = _BETWEEN.sub(r"\1 ∪ ", _in_words(text))
    found = _set_of(node, united, texts)
    if found is sp.S.EmptySet:  # -1 <= s <= 0 and s <= -2: both parts are meant
        found = _set_of(node, _AND.sub(" or ", united), texts)
    parts = found.args if isinstance(found, sp.Union) else (found,)
    if not all(isinstance(part, sp.Interval) for part in parts):
        raise node.fault("intervals of the real axis are expected here, such as [-2, -1]")
    return list(parts)
