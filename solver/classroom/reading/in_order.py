"""Values of several variables without their names, in the order of the question: 0.2, 0.1 for x and x'."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from solver.classroom.reading.brackets import split
from solver.classroom.reading.labels import without_labels
from solver.classroom.reading.spelling import typed
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode

ANSWERS = ("scale_factors", "maximum")
"""Answers whose variables stand in the question, one below the other."""
_SCALED = re.compile(r"\s*[^\W\d]\w*\s*=\s*([\d./]*)\s*[*·]?\s*([^\W\d_]\w*'*)\s*(/\s*[\d.]+)?\s*")
_INDEXED = re.compile(r"[^\W\d]+_?\{?\d\}?|[\d./\s]+")
_COMMA = re.compile(r"\s*[,;\n]\s*")


def named(node: Node, ours: Mapping[Any, Any], name: str) -> Node:
    """Return values of an answer with the names of our own, where they are told in their order; others as they are."""
    if name not in ANSWERS:
        return node
    if isinstance(node, MappingNode):
        if not all(_INDEXED.fullmatch(entry.key.text.strip()) for entry in node):
            return node
        told = [f"{entry.key.text} = {typed(entry.value)}" for entry in node]
    else:
        told = list(map(typed, node.items)) if isinstance(node, SequenceNode) else split(typed(node), _COMMA)
    own = {str(each) for each in ours}
    if len(told) != len(ours) or any(each.partition("=")[0].strip() in own for each in told):
        return node
    items = [ScalarNode(node.place, each, "quoted") for each in _bare(told)]
    keys = [ScalarNode(node.place, str(each)) for each in ours]
    return MappingNode(node.place, {key.text: Entry(key, item) for key, item in zip(keys, items, strict=True)})


def by_variables(text: str) -> str:
    """Return x: 1/5, x': 1/10 of the scaled variables X1 = x/5, X2 = x'/10; any other text as it is."""
    found = [_SCALED.fullmatch(each) for each in split(text, _COMMA)]
    if not all(found):
        return text
    return ", ".join(f"{each[2]}: {each[1] or 1}{each[3] or ''}" for each in found if each)


def _bare(told: list[str]) -> list[str]:
    """Values without labels such as α_0, in the order of their indices, and without how they are found."""
    values, _ = without_labels(told)
    return [each.rpartition("=")[2].strip() if re.match(r"[\d./\s]+=", each) else each for each in values]
