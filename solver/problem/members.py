"""The members of a family as files of their own, and the family with letters for what is drawn."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import lru_cache

from solver.problem.family import KEYS, canonical
from solver.problem.nodes import Entry, MappingNode, Node, Place, ScalarNode
from solver.problem.source import InputError, Source
from solver.problem.yaml_tree import parse_yaml

SAFE = re.compile(r"-?[\w(][\w.+*/^()-]*")
"""What means the same to YAML with quotes and without them, in a block and in brackets."""


@lru_cache(maxsize=8)  # a family is looked at for each of its members
def root_of(source: Source) -> MappingNode:
    """Return the tree of a problem file; raises InputError, also where it is no mapping."""
    root = parse_yaml(source)
    if not isinstance(root, MappingNode):
        raise InputError(source, [root.diagnostic("a problem is a mapping")])
    return root


def member_text(source: Source, drawn: Mapping[str, str]) -> str:
    """Return the text of a member: that of the family with other values under `parameters`, and no word of the others.

    Comments and the form of all else stay.
    """
    root = root_of(source)
    text = source.text.removeprefix("\ufeff")
    if text[_offset(text, root.place.line, root.place.column) :].startswith("{"):
        text = written(_member(root, drawn)) + "\n"
    else:
        text = _edited(text, root, drawn)
    return text


def headed(text: str, heading: str) -> str:
    """Return the text of a member with a comment on top."""
    return f"# {heading}\n{text}"


def _edited(text: str, root: MappingNode, drawn: Mapping[str, str]) -> str:
    """Return a text in block style with the values put in, without the lines of the keys of a family."""
    parameters, edits = root["parameters"], list[tuple[int, int, str]]()
    for entry in parameters if isinstance(parameters, MappingNode) else ():
        if (name := canonical(entry.key)) in drawn:
            edits.append((*_span(text, entry.value), _plain(drawn[name])))
    for entry in root:
        if entry.key.text in KEYS:
            start = _offset(text, entry.key.place.line, 1)
            end = text.find("\n", _span(text, _last(text, entry.value))[1])
            edits.append((start, len(text) if end < 0 else end + 1, ""))
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def _last(text: str, node: Node) -> Node:
    """Return what ends where a value ends: a block ends with its last value, brackets with themselves."""
    inside = node.entries.values() if isinstance(node, MappingNode) else getattr(node, "items", ())
    parts = [each.value if isinstance(each, Entry) else each for each in inside]
    in_brackets = text[_offset(text, node.place.line, node.place.column)] in "[{"
    return node if in_brackets or not parts else _last(text, parts[-1])


def _span(text: str, node: Node) -> tuple[int, int]:
    place = node.place
    return _offset(text, place.line, place.column), _offset(text, place.end_line, place.end_column)


def _offset(text: str, line: int, column: int) -> int:
    """Return where a line and a column, both from 1, lie in a text."""
    start = 0
    for _ in range(line - 1):
        start = text.index("\n", start) + 1
    return min(start + column - 1, len(text))


def _member(root: MappingNode, drawn: Mapping[str, str]) -> MappingNode:
    """Return the tree of a member."""
    kept = {key: entry for key, entry in root.entries.items() if key not in KEYS}
    parameters = root["parameters"]
    if isinstance(parameters, MappingNode):
        entries = {
            key: replace(entry, value=ScalarNode(entry.value.place, drawn.get(canonical(entry.key), "")))
            if canonical(entry.key) in drawn
            else entry
            for key, entry in parameters.entries.items()
        }
        kept["parameters"] = replace(kept["parameters"], value=MappingNode(parameters.place, entries))
    return MappingNode(root.place, kept)


def with_letters(root: MappingNode, names: Collection[str], assumed: Mapping[str, str]) -> MappingNode:
    """Return the tree of the family where some names have no values, and what is assumed of them instead."""
    place = Place()
    kept = {key: entry for key, entry in root.entries.items() if key not in KEYS}
    for key, changed in (("parameters", dict[str, str]()), ("assume", dict(assumed))):
        old = root.get(key)
        entries = dict(old.entries) if isinstance(old, MappingNode) else {}
        if key == "parameters":
            entries = {name: entry for name, entry in entries.items() if canonical(entry.key) not in names}
        known = {canonical(entry.key) for entry in entries.values()}
        for name, word in changed.items():
            if name not in known:
                entries[name] = Entry(ScalarNode(place, name), ScalarNode(place, word))
        kept.pop(key, None)
        if entries:
            kept[key] = Entry(ScalarNode(place, key), MappingNode(place, entries))
    return MappingNode(root.place, kept)


def written(node: Node) -> str:
    """Return a value in YAML on one line, as it is read back."""
    if isinstance(node, MappingNode):
        return "{" + ", ".join(f"{_word(entry.key)}: {written(entry.value)}" for entry in node) + "}"
    if isinstance(node, ScalarNode):
        return _word(node)
    return "[" + ", ".join(written(each) for each in getattr(node, "items", ())) + "]"


def _word(node: ScalarNode) -> str:
    return node.text if node.is_null or node.truth is not None else _plain(node.text, quoted=node.style != "plain")


def _plain(text: str, *, quoted: bool = False) -> str:
    """Return a text as YAML reads it back: in quotes where it may mean something else."""
    return text if not quoted and SAFE.fullmatch(text) else json.dumps(text, ensure_ascii=False)
