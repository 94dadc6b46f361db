"""YAML to a tree with places, from the parser's events; nothing is resolved, so nothing can be constructed.

What problem files don't need is refused with its place: anchors, aliases, tags, merge keys, duplicate keys, further
documents, tabs, invisible characters. Depth and size are bounded while the events come, before anything is built.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

from solver.problem.nodes import Entry, MappingNode, Node, Place, ScalarNode, SequenceNode
from solver.problem.source import Diagnostic, Fault, InputError, Report, Source
from solver.problem.yaml_hints import explain

MAX_BYTES = 256 * 1024
MAX_VALUES = 20_000
MAX_TEXT = 20_000
MAX_DEPTH = 24
MAX_OPEN_BRACKETS = 200  # on the raw text, where brackets inside texts are seen too

Loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

# control characters but line ends, and characters that don't show but change what is seen; U+200C and U+200D are
# needed in the spelling of several languages
FORBIDDEN = re.compile(
    "[\x00-\x09\x0b\x0c\x0e-\x1f\x7f-\x9f\u00ad\u0600-\u0605\u061c\u06dd\u070f\u08e2\u180e\u200b\u200e\u200f"
    "\u2028-\u202e\u2060-\u206f\ud800-\udfff\ufeff\ufff9-\ufffc\ufffe\uffff\U000e0000-\U000e0fff]|\r(?!\n)"
)
BRACKET = re.compile(r"[\[\]{}]")


def parse_yaml(source: Source, *, colonless: bool = False) -> Node:
    """Return the tree of the one document of the source; raises InputError with everything that is wrong with it.

    With `colonless` braces without colons are a set, {-1, -2}, and {x: 1, 2, y: 3} gives x the text "1, 2".
    """
    text = source.text.removeprefix("\ufeff")
    try:
        _guard(text)
        return (_ColonlessComposer(text) if colonless else _Composer(text)).document()
    except Fault as fault:
        raise InputError(source, fault.diagnostics) from None
    except yaml.YAMLError as error:
        raise InputError(source, [explain(error, source)]) from None


def _guard(text: str) -> None:
    """Refuse what must not reach the parser."""
    if len(text.encode("utf-8", "surrogatepass")) > MAX_BYTES:
        raise Fault(Diagnostic(f"the file is larger than {MAX_BYTES // 1024} KB"))
    found = list(FORBIDDEN.finditer(text))
    if found:
        raise Fault(*(_forbidden(text, match.start()) for match in found[:100]))
    depth = 0
    for match in BRACKET.finditer(text):
        depth = depth + 1 if match[0] in "[{" else max(0, depth - 1)
        if depth > MAX_OPEN_BRACKETS:
            raise Fault(Diagnostic("too many brackets are open here", *_position(text, match.start())))


def _forbidden(text: str, at: int) -> Diagnostic:
    code = ord(text[at])
    if code == 9:
        return Diagnostic("a tab; use spaces instead", *_position(text, at))
    return Diagnostic(f"the invisible character U+{code:04X} is not allowed", *_position(text, at))


def _position(text: str, at: int) -> tuple[int, int]:
    """Line and column of an offset."""
    return text.count("\n", 0, at) + 1, at - text.rfind("\n", 0, at)


def _events(text: str) -> Iterator[yaml.Event]:
    events: Iterator[yaml.Event] = yaml.parse(text, Loader=Loader)
    return events


class _Composer:
    """Builds the tree. Recursion is bounded by MAX_DEPTH."""

    def __init__(self, text: str) -> None:
        self.events = _events(text)
        self.report = Report()
        self.values = 0

    def document(self) -> Node:
        """Return the root of the only document."""
        next(self.events)
        if isinstance(next(self.events), yaml.StreamEndEvent):
            raise Fault(Diagnostic("the file is empty"))
        root = self._node(next(self.events), 1)
        next(self.events)
        following = next(self.events)
        if isinstance(following, yaml.DocumentStartEvent):
            message = "a second document starts here; a file holds one problem"
            self._refuse(following, message, length=3)
        self.report.conclude()
        return root

    def _node(self, event: yaml.Event, depth: int) -> Node:
        self.values += 1
        if self.values > MAX_VALUES:
            raise Fault(Diagnostic(f"there are more than {MAX_VALUES} values in the file"))
        if depth > MAX_DEPTH:
            raise Fault(_at(event, f"values are nested more than {MAX_DEPTH} deep", 1))
        self._refuse_properties(event)
        if isinstance(event, yaml.SequenceStartEvent):
            return self._sequence(event, depth)
        if isinstance(event, yaml.MappingStartEvent):
            return self._mapping(event, depth)
        if isinstance(event, yaml.ScalarEvent):
            return self._scalar(event)
        return ScalarNode(_place(event), "")  # an alias, already refused

    def _refuse_properties(self, event: yaml.Event) -> None:
        """Refuse `*alias`, `&anchor` and `!tag`."""
        quote = "put a text that starts with '{}' in quotes"
        if isinstance(event, yaml.AliasEvent):
            self._refuse(event, f"aliases (*{event.anchor}) are not read here", quote.format("*"))
            return
        if not isinstance(event, (yaml.ScalarEvent, yaml.CollectionStartEvent)):
            return
        if event.anchor is not None:
            self._refuse(event, f"anchors (&{event.anchor}) are not read here", quote.format("&"), 1)
        if event.tag is not None:
            tag = event.tag.replace("tag:yaml.org,2002:", "!!")[:40]
            self._refuse(event, f"tags ({tag}) are not read here", quote.format("!"), 1)

    def _refuse(self, event: yaml.Event, message: str, note: str = "", length: int = 0) -> None:
        self.report.diagnostics.append(_at(event, message, length, note))

    def _scalar(self, event: yaml.ScalarEvent) -> ScalarNode:
        style = {None: "plain", "'": "quoted", '"': "quoted", "|": "block", ">": "block"}.get(event.style, "plain")
        if len(event.value) > MAX_TEXT:
            self._refuse(event, f"a text is longer than {MAX_TEXT} characters", length=1)
        if hidden := FORBIDDEN.search(event.value):
            note = "in double quotes a backslash starts an escape: use single quotes, or a block text after '|'"
            self._refuse(event, f"an escape makes the invisible character U+{ord(hidden[0]):04X}", note)
        return ScalarNode(_place(event), event.value, style)

    def _sequence(self, start: yaml.Event, depth: int) -> SequenceNode:
        items = []
        while not isinstance(event := next(self.events), yaml.SequenceEndEvent):
            items.append(self._node(event, depth + 1))
        return SequenceNode(_place(start, event), tuple(items))

    def _mapping(self, start: yaml.Event, depth: int) -> Node:
        entries: dict[str, Entry] = {}
        while not isinstance(event := next(self.events), yaml.MappingEndEvent):
            key = self._node(event, depth + 1)
            value = self._node(next(self.events), depth + 1)
            self._enter(entries, key, value)
        return MappingNode(_place(start, event), entries)

    def _enter(self, entries: dict[str, Entry], key: Node, value: Node) -> None:
        """Add an entry, or say why it can't be one."""
        if not isinstance(key, ScalarNode):
            self.report.diagnostics.append(key.diagnostic(f"a key must be a word, not {key.what}"))
        elif key.text == "<<" and key.style == "plain":
            self.report.diagnostics.append(key.diagnostic("merge keys (<<) are not read here"))
        elif key.text in entries:
            first = entries[key.text].key.place
            note = f"first given at line {first.line}, column {first.column}"
            self.report.diagnostics.append(key.diagnostic(f"key '{key.text}' is given twice", note=note))
        else:
            entries[key.text] = Entry(key, value)


class _ColonlessComposer(_Composer):
    """Reads what stands in braces without a colon, where YAML sees a key without a value."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.lines = text.splitlines(keepends=True)

    def _mapping(self, start: yaml.Event, depth: int) -> Node:
        entries: dict[str, Entry] = {}
        items: list[Node] = []
        while not isinstance(event := next(self.events), yaml.MappingEndEvent):
            key = self._node(event, depth + 1)
            value = self._node(next(self.events), depth + 1)
            if not _is_colonless(key, value):
                self._enter(entries, key, value)
            elif not entries:
                items.append(key)
            elif not self._continues(entries, key):
                self._enter(entries, key, value)
        if items and not entries:
            return SequenceNode(_place(start, event), tuple(items), braces=True)
        for item in items:
            self._enter(entries, item, ScalarNode(item.place, ""))
        return MappingNode(_place(start, event), entries)

    def _continues(self, entries: dict[str, Entry], item: Node) -> bool:
        """Join an item to the text before it, as it is written; False where no plain text stands there."""
        name, last = next(reversed(entries.items()))
        value = last.value
        if not isinstance(value, ScalarNode) or value.style != "plain" or not value.text:
            return False
        start, end = value.place, item.place
        place = Place(start.line, start.column, end.end_line, end.end_column)
        text = " ".join(self._written(place).split())
        if len(text) > MAX_TEXT:
            return False
        entries[name] = Entry(last.key, ScalarNode(place, text))
        return True

    def _written(self, place: Place) -> str:
        lines = self.lines[place.line - 1 : place.end_line]
        lines[-1] = lines[-1][: place.end_column - 1]
        lines[0] = lines[0][place.column - 1 :]
        return "".join(lines)


def _is_colonless(key: Node, value: Node) -> bool:
    ends = (key.place.end_line, key.place.end_column)
    nothing = isinstance(value, ScalarNode) and value.is_null and not value.text
    return nothing and ends == (value.place.line, value.place.column)


def _place(start: yaml.Event, end: yaml.Event | None = None) -> Place:
    first, last = start.start_mark, (end or start).end_mark
    if first is None or last is None:
        return Place()
    return Place(first.line + 1, first.column + 1, last.line + 1, last.column + 1)


def _at(event: yaml.Event, message: str, length: int = 0, note: str = "") -> Diagnostic:
    place = _place(event)
    return Diagnostic(message, place.line, place.column, length or place.length, "", note)
