"""Documents and markings as plain data, which can be written as JSON and read again.

Only classes that these are made of are ever made of data; whatever else stands there is refused. Nothing is
imported or called by a name that data tell.
"""

from __future__ import annotations

from base64 import b64decode, b64encode
from binascii import Error
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

from solver.classroom import verdicts
from solver.derivation import figures, steps
from solver.document import model, work
from solver.document.model import Document
from solver.limits import codec
from solver.limits.results import Sent
from solver.messages import Messages
from solver.papers import difficulty
from solver.papers.exam.question import QuestionMade
from solver.papers.making import Made
from solver.problem.images import Image
from solver.words import Phrase

NOT_KEPT = {Document: ("exact", "retell")}
"""Fields that hold no data; they are as in a document that was sent."""


class NotPlain(Exception):  # noqa: N818 - no error: it is made again
    """An object is not made of texts and numbers, or data are not those of an object."""


def as_plain(value: Any) -> Any:  # noqa: PLR0911 - a line for each kind of value
    """Return an object as lists, texts and numbers; raises NotPlain."""
    kind = type(value)
    if value is None or kind in {bool, int, float, str}:
        return value
    if kind is Phrase:
        return ["phrase", value.pattern, as_plain(dict(value.values))]
    if kind in {list, tuple}:
        return [kind.__name__, *map(as_plain, value)]
    if kind is bytes:
        return ["bytes", b64encode(value).decode()]
    if isinstance(value, Mapping):
        return ["mapping", *([as_plain(key), as_plain(each)] for key, each in value.items())]
    if isinstance(value, Path):
        return ["path", str(value)]
    if kind is Fraction:
        return ["fraction", value.numerator, value.denominator]
    if _known().get(kind.__qualname__) is not kind:
        return ["exact", as_plain(_encoded(value))]
    if isinstance(value, Enum):
        return ["one of", kind.__qualname__, value.name]
    return ["object", kind.__qualname__, {name: as_plain(getattr(value, name)) for name in _fields(kind)}]


def _encoded(value: Any) -> list[codec.Node]:
    """Return an exact value as nodes; raises NotPlain where it is no mathematics."""
    try:
        return codec.encode(value)
    except codec.NotPlain:
        raise NotPlain(type(value).__qualname__) from None


def of_plain(data: Any) -> Any:
    """Return the object that data are made of; raises NotPlain."""
    try:
        return _of(data)
    except (TypeError, ValueError, KeyError, IndexError, AttributeError, Error, RecursionError) as error:
        raise NotPlain(str(error)) from None


def _of(data: Any) -> Any:  # noqa: PLR0911 - a line for each kind of value
    if not isinstance(data, list):
        if data is None or isinstance(data, bool | int | float | str):
            return data
        raise NotPlain("a mapping stands alone")
    word, *rest = data
    match word:
        case "list" | "tuple":
            found = map(_of, rest)
            return list(found) if word == "list" else tuple(found)
        case "mapping":
            return {_of(key): _of(each) for key, each in rest}
        case "phrase":
            pattern, values = rest
            return Phrase(pattern, **_of(values))
        case "bytes":
            return b64decode(rest[0], validate=True)
        case "path":
            return Path(rest[0])
        case "fraction":
            return Fraction(int(rest[0]), int(rest[1]))
        case "exact":
            return codec.decode(_of(rest[0]))
        case "one of":
            return _known()[rest[0]][rest[1]]
        case "object":
            kind, values = _known()[rest[0]], rest[1]
            if set(values) != set(_fields(kind)):
                raise NotPlain(f"{rest[0]} has other fields")
            return kind(**{name: _of(each) for name, each in values.items()})
    raise NotPlain(f"no {word!r} is known")


@cache
def _fields(kind: Any) -> tuple[str, ...]:
    return tuple(each.name for each in fields(kind) if each.init and each.name not in NOT_KEPT.get(kind, ()))


@cache
def _known() -> Mapping[str, Any]:
    """The classes that documents are made of, by their names."""
    found: list[Any] = [Messages, Image, QuestionMade, Made, Sent]
    for module in (figures, steps, model, work, difficulty, verdicts):
        found += [
            each
            for each in vars(module).values()
            if isinstance(each, type)
            and each.__module__ == module.__name__
            and (is_dataclass(each) or issubclass(each, Enum))
        ]
    return {each.__qualname__: each for each in found}
