"""The keys of an answer file as they are meant: `A`, `a)`, `Part a` for a, `Eigenvalues`, `a.K`, `K = …`.

What stands below one key in two places belongs together; of an answer that is given twice neither value counts.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from solver.classroom.reading.quoting import TWICE, UNREADABLE
from solver.classroom.reading.spelling import typed
from solver.problem.nodes import Entry, MappingNode, Node, ScalarNode, SequenceNode

_AROUND = re.compile(
    r"^[\W_]*(?:(?:part|teil|teilaufgabe|aufgabe|question|frage|exercise|task)[\s_.:]+)?|[^\w'′]+$", re.IGNORECASE
)
_OF_PART = re.compile(r"(.*\w)\s*[.):/]+\s*([^\W\d].*)")
_BETWEEN = re.compile(r"[\s_-]+")


def as_meant(node: MappingNode, known: Collection[str]) -> MappingNode:
    """Return a mapping with its keys as they are known, where one is written otherwise that can mean only this one."""
    entries: dict[str, Entry] = {}
    for entry in node:
        meant = _meant(entry.key.text, known)
        key = entry.key.text if meant in node or meant in entries else meant
        entries[key] = entry if key == entry.key.text else Entry(ScalarNode(entry.key.place, key), entry.value)
    return MappingNode(node.place, _together(entries, known))


def _together(entries: Mapping[str, Entry], known: Collection[str]) -> dict[str, Entry]:
    """Entries with what stands below a key that is given once more below the first one."""
    found: dict[str, Entry] = {}
    for key, entry in entries.items():
        name = _meant(key.partition(TWICE)[0], known)
        if name != key and name in found:
            first = found[name]
            found[name] = Entry(first.key, _both(first.value, entry.value))
        else:
            found[key] = entry
    return found


def _both(one: Node, other: Node) -> Node:
    """Two mappings as one; other values that differ as what cannot be read."""
    if isinstance(one, MappingNode) and isinstance(other, MappingNode):
        entries = dict(one.entries)
        for key, entry in other.entries.items():
            value = _both(entries[key].value, entry.value) if key in entries else entry.value
            entries[key] = Entry(entry.key, value)
        return MappingNode(one.place, entries)
    blank, empty = (isinstance(each, ScalarNode) and not each.text.strip() for each in (one, other))
    if blank or empty or typed(one) == typed(other):
        return other if blank else one
    return ScalarNode(one.place, f"{UNREADABLE}given twice: {typed(one)}; {typed(other)}", "quoted")


def with_parts(listed: MappingNode, answers: Mapping[str, Collection[str]]) -> MappingNode:
    """Return a mapping of parts with `a.K: …` and `a) K: …` below their parts; `answers` are the names in each part."""
    found = dict(listed.entries)
    for key, entry in listed.entries.items():
        told = _OF_PART.fullmatch(key) if key not in answers else None
        part = _meant(told[1], answers) if told else ""
        name = _meant(told[2], answers[part]) if told and part in answers else ""
        before = found[part].value if part in found else None
        if part not in answers or name not in answers[part] or not isinstance(before, MappingNode | None):
            continue
        inside = MappingNode(entry.key.place, {name: Entry(ScalarNode(entry.key.place, name), entry.value)})
        found[part] = Entry(ScalarNode(entry.key.place, part), inside if before is None else _both(before, inside))
        del found[key]
    return MappingNode(listed.place, found)


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
