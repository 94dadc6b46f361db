"""The keys of an answer file as they are meant: `A`, `a)`, `Part a` for a, `Eigenvalues`, `closed-loop A`, `K = …`."""

from __future__ import annotations

import re
from collections.abc import Collection

from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode

_AROUND = re.compile(
    r"^[\W_]*(?:(?:part|teil|teilaufgabe|aufgabe|question|frage|exercise|task)[\s_.:]+)?|[^\w'′]+$", re.IGNORECASE
)
_BETWEEN = re.compile(r"[\s_-]+")


def as_meant(node: MappingNode, known: Collection[str]) -> MappingNode:
    """Return a mapping with its keys as they are known, where one is written otherwise that can mean only this one."""
    entries: dict[str, Entry] = {}
    for entry in node:
        meant = _meant(entry.key.text, known)
        key = entry.key.text if meant in node or meant in entries else meant
        entries[key] = entry if key == entry.key.text else Entry(ScalarNode(entry.key.place, key), entry.value)
    return MappingNode(node.place, entries)


def _meant(text: str, known: Collection[str]) -> str:
    """The one known name that a text is but for its case, its spaces and what stands around it; else the text."""
    found = [each for each in known if _bare(each) == _bare(text)]
    return found[0] if text not in known and len(found) == 1 else text


def _bare(name: str) -> str:
    return _BETWEEN.sub("_", _AROUND.sub("", name)).lower()


def joined(node: Node | None) -> Node | None:
    """Return a list of mappings, - a: {…}, - b: {…}, as one mapping; anything else, or one named twice, as it is."""
    listed = node.items if isinstance(node, SequenceNode) else ()
    items = [each for each in listed if isinstance(each, MappingNode)]
    if node is None or not items or len(items) < len(listed):
        return node
    entries = {entry.key.text: entry for item in items for entry in item}
    return MappingNode(node.place, entries) if len(entries) == sum(len(each.entries) for each in items) else node


def told_by_name(node: Node, known: Collection[str]) -> Node:
    """Return the mapping of K = [10 4] polynomial = s^2 + 7s + 12, or K:[10 4]; anything else as it is."""
    names = "|".join(sorted(map(re.escape, known), key=len, reverse=True))
    text = node.text if isinstance(node, ScalarNode) else ""
    found = list(re.finditer(rf"(?:^|(?<=\s))({names})\s*[:=]\s*(?=\S)", text))
    if not found or found[0].start() or len({each[1] for each in found}) < len(found):
        return node
    ends = [*(each.start() for each in found[1:]), len(text)]
    pairs = [(each[1], text[each.end() : end].strip()) for each, end in zip(found, ends, strict=True)]
    entries = {name: Entry(ScalarNode(node.place, name), ScalarNode(node.place, value)) for name, value in pairs}
    return MappingNode(node.place, entries)
