"""A small language for the shape of a file: what may stand where, in words for errors and as JSON Schema for editors.

A shape yields everything that is wrong with a node of the file's tree. What stands in the scalars is read elsewhere.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode
from solver.problem.source import Diagnostic, did_you_mean

Path = tuple[str | int, ...]
Schema = dict[str, Any]
LONGEST = 60  # characters of a value that are repeated in a message


@dataclass(frozen=True)
class Misshapen:
    """Something wrong with the shape: the path of keys to it, and words. A `surplus` key leaves the rest readable."""

    path: Path
    diagnostic: Diagnostic
    surplus: bool = False

    def spoils(self, path: Path) -> bool:
        """Whether what stands at the path can't be read because of it."""
        inside, around = self.path[: len(path)] == path, path[: len(self.path)] == self.path
        return around or (inside and not self.surplus)

    def spoils_part(self, name: str) -> bool:
        """Whether a part can't be read because of it; the part's own system is read apart."""
        return self.spoils(("find", name)) and self.path[:3] != ("find", name, "system")


class Shape:
    """What may stand in a place."""

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield all that is wrong with a node at a path."""
        raise NotImplementedError

    def schema(self) -> Schema:
        """Return the JSON Schema, its keys in alphabetical order; a record is a reference to its definition."""
        raise NotImplementedError

    def inside(self) -> Iterator[Shape]:
        """Yield the shapes this one is made of."""
        yield from ()


class Scalar(Shape):
    """A number or a text; `types` are those of JSON."""

    def __init__(self, *types: str) -> None:
        self.types = types

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield a fault for a list, a mapping, a truth value, and for nothing."""
        if not is_text(node):
            yield _expected("a number or a text", node, path)

    def schema(self) -> Schema:
        """Return the types."""
        return {"type": list(self.types)}


class Word(Shape):
    """One of some words."""

    def __init__(self, *words: str) -> None:
        self.words = words

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield a fault, with the word probably meant, for anything else."""
        if not (isinstance(node, ScalarNode) and node.plain() in self.words):
            got = _got(node)
            message = f"'{got}' is not known here; it is one of {', '.join(self.words)}"
            yield Misshapen(path, node.diagnostic(message, did_you_mean(got, self.words)))

    def schema(self) -> Schema:
        """Return the words."""
        return {"enum": list(self.words), "type": "string"}


class ListOf(Shape):
    """A list, of at least `least` items."""

    def __init__(self, item: Shape, least: int = 0) -> None:
        self.item = item
        self.least = least

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults of the items, or that there are too few."""
        if not isinstance(node, SequenceNode):
            yield _expected("a list", node, path)
        elif len(node.items) < self.least:
            yield Misshapen(path, node.diagnostic("this is empty"))
        else:
            for i, item in enumerate(node.items):
                yield from self.item.faults(item, (*path, i))

    def schema(self) -> Schema:
        """Return the array."""
        least = {"minItems": self.least} if self.least else {}
        return {"items": self.item.schema(), **least, "type": "array"}

    def inside(self) -> Iterator[Shape]:
        """Yield the shape of the items."""
        yield self.item


class MappingOf(Shape):
    """A mapping with any keys."""

    def __init__(self, value: Shape) -> None:
        self.value = value

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults of the values."""
        if not isinstance(node, MappingNode):
            yield _expected("a mapping (key: value)", node, path)
            return
        for entry in node:
            yield from self.value.faults(entry.value, (*path, entry.key.text))

    def schema(self) -> Schema:
        """Return the object."""
        return {"additionalProperties": self.value.schema(), "type": "object"}

    def inside(self) -> Iterator[Shape]:
        """Yield the shape of the values."""
        yield self.value


class Either(Shape):
    """One of several shapes, by the kind of node; `expected` says what stands here where none fits."""

    def __init__(self, expected: str, kind: Callable[[Node], str], **shapes: Shape) -> None:
        self.expected = expected
        self.kind = kind
        self.shapes = shapes

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults of the one that is meant."""
        shape = self.shapes.get(self.kind(node))
        if shape is None:
            yield _expected(self.expected, node, path)
        else:
            yield from shape.faults(node, path)

    def schema(self) -> Schema:
        """Return the alternatives."""
        return {"oneOf": [shape.schema() for shape in self.shapes.values()]}

    def inside(self) -> Iterator[Shape]:
        """Yield the alternatives."""
        yield from self.shapes.values()


class Field:
    """What stands under a key of a record, what it means, and what its absence means where that is a value."""

    def __init__(self, shape: Shape, doc: str, *, required: bool = False, default: str = "") -> None:
        self.shape = shape
        self.doc = doc
        self.required = required
        self.default = default

    def schema(self) -> Schema:
        """Return the schema of the shape with the meaning."""
        default = {"default": self.default} if self.default else {}
        return in_order({**default, "description": self.doc, **self.shape.schema()})


class Record(Shape):
    """A mapping with known keys; other keys are allowed where it is `open`. `name` is that of its definition."""

    def __init__(self, name: str, doc: str, fields: Mapping[str, Field], *, is_open: bool = False) -> None:
        self.name = name
        self.doc = doc
        self.fields = dict(fields)
        self.is_open = is_open

    def faults(self, node: Node, path: Path) -> Iterator[Misshapen]:
        """Yield the faults of the values, what is missing, and then the unknown keys."""
        if not isinstance(node, MappingNode):
            yield _expected("a mapping (key: value)", node, path)
            return
        for key, field in self.fields.items():
            if key in node:
                yield from field.shape.faults(node[key], (*path, key))
            elif field.required:
                yield Misshapen((*path, key), self.missing(node, path, key))
        for entry in () if self.is_open else node:
            if entry.key.text not in self.fields:
                fault = entry.key.diagnostic(*self.unknown(entry.key.text, node))
                yield Misshapen((*path, entry.key.text), fault, surplus=True)

    def missing(self, node: Node, path: Path, key: str) -> Diagnostic:
        """Return what is said of a key that is missing; of the file as a whole, with no place."""
        if path:
            return node.diagnostic(f"'{key}' is missing here")
        return Diagnostic(f"'{key}' is missing", note=f"a problem needs the key '{key}:'")

    def unknown(self, key: str, node: MappingNode) -> tuple[str, str]:
        """Return what is said of a key that is not known here, and the key probably meant."""
        return f"unknown key '{key[:LONGEST]}'", did_you_mean(key, (name for name in self.fields if name not in node))

    def schema(self) -> Schema:
        """Return the reference."""
        return {"$ref": f"#/$defs/{self.name}"}

    def definition(self) -> Schema:
        """Return what the reference stands for."""
        required = [key for key, field in self.fields.items() if field.required]
        return {
            "additionalProperties": self.is_open,
            "description": self.doc,
            "properties": {key: field.schema() for key, field in self.fields.items()},
            **({"required": required} if required else {}),
            "type": "object",
        }

    def inside(self) -> Iterator[Shape]:
        """Yield the shapes of the fields."""
        for field in self.fields.values():
            yield field.shape


def definitions(shape: Shape) -> dict[str, Schema]:
    """Return the definitions of all records inside a shape, by name in alphabetical order."""
    found: dict[str, Schema] = {}
    for each in shape.inside():
        if not (isinstance(each, Record) and each.name in found):
            found |= {each.name: each.definition()} if isinstance(each, Record) else {}
            found |= definitions(each)
    return in_order(found)


def in_order(schema: Schema) -> Schema:
    """Return a schema with its keys in alphabetical order."""
    return dict(sorted(schema.items()))


def is_text(node: Node) -> bool:
    """Whether a node is a number or a text: no truth value, and not nothing."""
    return isinstance(node, ScalarNode) and isinstance(node.plain(), str)


def kind_of_value(node: Node) -> str:
    """Return "value", "list" or "mapping"; "" for a truth value and for nothing."""
    if isinstance(node, SequenceNode):
        return "list"
    return "mapping" if isinstance(node, MappingNode) else "value" if is_text(node) else ""


def _expected(what: str, node: Node, path: Path) -> Misshapen:
    return Misshapen(path, node.diagnostic(f"{what} is expected here, not {_got(node)}"))


def _got(node: Node) -> str:
    """Return what stands there, in words."""
    return node.what if len(node.what) < LONGEST else "a text"
