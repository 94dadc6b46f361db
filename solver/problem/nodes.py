"""The tree of a YAML file with the place of every value. Scalars stay text, so numbers stay exact."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from solver.problem.source import Diagnostic, Fault

TRUE, FALSE = ("true", "True", "TRUE"), ("false", "False", "FALSE")
NULL = ("", "~", "null", "Null", "NULL")


@dataclass(frozen=True, slots=True)
class Place:
    """Where a value starts (line and column from 1) and ends (column after its last character)."""

    line: int = 0
    column: int = 0
    end_line: int = 0
    end_column: int = 0

    @property
    def length(self) -> int:
        """Number of characters to underline: the value if it is on one line, else its first character."""
        return max(1, self.end_column - self.column) if self.line == self.end_line else 1


@dataclass(frozen=True, slots=True)
class Node:
    """A value with its place."""

    place: Place

    def diagnostic(self, message: str, suggestion: str = "", note: str = "") -> Diagnostic:
        """Return an error at this place."""
        place = self.place
        return Diagnostic(message, place.line, place.column, place.length, suggestion, note)

    def fault(self, message: str, *, suggestion: str = "", note: str = "") -> Fault:
        """Return a fault at this place, to be raised."""
        return Fault(self.diagnostic(message, suggestion=suggestion, note=note))

    @property
    def what(self) -> str:
        """What the value is, in words."""
        raise NotImplementedError

    def plain(self) -> Any:
        """Return the value as nested lists and dicts of texts, True, False and None."""
        raise NotImplementedError


@dataclass(frozen=True, slots=True)
class ScalarNode(Node):
    """A text as written; `style` is "plain", "quoted" or "block"."""

    text: str
    style: str = "plain"

    @property
    def what(self) -> str:
        """What the value is, in words."""
        value = self.plain()
        return "nothing" if value is None else value if isinstance(value, str) else "true or false"

    @property
    def is_null(self) -> bool:
        """Whether there is no value: nothing, `~` or `null`."""
        return self.style == "plain" and self.text in NULL

    @property
    def truth(self) -> bool | None:
        """The value of `true` and `false`, None for anything else (`yes` and `no` are texts)."""
        if self.style != "plain" or self.text not in TRUE + FALSE:
            return None
        return self.text in TRUE

    def part(self, at: int, length: int | None = None) -> ScalarNode:
        """Return a part of the text (to its end), at its own place where the text is written as it reads."""
        end = len(self.text) if length is None else at + length
        place, quotes = self.place, 2 if self.style == "quoted" else 0
        if place.line != place.end_line or place.end_column - place.column != len(self.text) + quotes:
            return ScalarNode(place, self.text[at:end])
        first, last = (place.column + quotes // 2 + each for each in (at, end))
        return ScalarNode(Place(place.line, first, place.line, last), self.text[at:end])

    def plain(self) -> str | bool | None:
        """Return the text, or True, False, None for the plain words of YAML 1.2."""
        if self.is_null:
            return None
        return self.text if self.truth is None else self.truth

    def fault_inside(self, message: str, at: int, length: int, *, suggestion: str = "", note: str = "") -> Fault:
        """Return a fault at `length` characters from offset `at` of the text, to be raised.

        Where the text is not written as it reads (several lines, escapes), the whole value is underlined.
        """
        place, quotes = self.place, 2 if self.style == "quoted" else 0
        if place.line != place.end_line or place.end_column - place.column != len(self.text) + quotes:
            return self.fault(message, suggestion=suggestion, note=note)
        column = place.column + quotes // 2 + at
        return Fault(Diagnostic(message, place.line, column, max(1, length), suggestion, note))


@dataclass(frozen=True, slots=True)
class SequenceNode(Node):
    """A list; `braces` tells that it is written as a set, {1, 2}."""

    items: tuple[Node, ...] = ()
    braces: bool = False

    @property
    def what(self) -> str:
        """What the value is, in words."""
        return "a list"

    def plain(self) -> list[Any]:
        """Return the items as plain values."""
        return [item.plain() for item in self.items]


@dataclass(frozen=True, slots=True)
class Entry:
    """A key of a mapping with its value."""

    key: ScalarNode
    value: Node


@dataclass(frozen=True, slots=True)
class MappingNode(Node):
    """Keys with values, in the order of the file."""

    entries: dict[str, Entry]

    @property
    def what(self) -> str:
        """What the value is, in words."""
        return "a mapping"

    def __contains__(self, key: str) -> bool:
        return key in self.entries

    def __iter__(self) -> Iterator[Entry]:
        return iter(self.entries.values())

    def __getitem__(self, key: str) -> Node:
        return self.entries[key].value

    def get(self, key: str) -> Node | None:
        """Return the value of the key, None if it is absent."""
        return self.entries[key].value if key in self.entries else None

    def plain(self) -> dict[str, Any]:
        """Return the entries as plain values."""
        return {name: entry.value.plain() for name, entry in self.entries.items()}


def node_of(value: Any, place: Place) -> Node:
    """Return plain data (texts, numbers, truth values, lists) as a node, as if it stood at that place."""
    if isinstance(value, (list, tuple)):
        return SequenceNode(place, tuple(node_of(item, place) for item in value))
    if isinstance(value, bool):
        return ScalarNode(place, str(value).lower())
    return ScalarNode(place, str(value), "quoted" if isinstance(value, str) else "plain")


def scalar(node: Node) -> ScalarNode:
    """Return the node if it holds a text or number; raises Fault otherwise."""
    if not isinstance(node, ScalarNode) or node.is_null or node.truth is not None:
        raise node.fault(f"a number or an expression is expected here, not {node.what}")
    return node


def shown(node: Node) -> str:
    """Return how a message speaks of a value."""
    return f"'{node.text[:40]}'" if isinstance(node, ScalarNode) and not node.is_null else node.what


def whole_number(node: Node, name: str, minimum: int | None, maximum: int | None) -> int:
    """Return a whole number within bounds (None: none); raises Fault."""
    text = scalar(node).text
    bounds = [
        f"at least {minimum}" if minimum is not None else "",
        f"at most {maximum}" if maximum is not None else "",
    ]
    expected = " and ".join(["a whole number", *filter(None, bounds)]).replace(" and ", " of ", 1)
    if maximum is None and re.fullmatch(r"[+-]?[0-9]{10,}", text):
        raise node.fault(f"{name} has at most 9 digits")
    if not re.fullmatch(r"[+-]?[0-9]{1,9}", text):
        raise node.fault(f"{name} must be {expected}, not {shown(node)}")
    value = int(text)
    if (minimum is not None and value < minimum) or (maximum is not None and value > maximum):
        raise node.fault(f"{name} must be {expected}")
    return value
