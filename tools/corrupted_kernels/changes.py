"""Small changes of a value that make it wrong: a number, a sign, two entries exchanged, one of a list left out."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.stated import Stated

SMALL = sp.Rational(1, 1000)


@dataclass(frozen=True)
class Change:
    """A change: where in the value and what, and the function that makes the changed value."""

    what: str
    made: Callable[[], Any]


def changes(value: Any, *, derived: bool = True) -> Iterator[Change]:
    """All small changes of a value; none of texts and None. `derived`: of properties of objects too."""
    if isinstance(value, bool | sp.logic.boolalg.BooleanAtom):
        yield Change("truth turned", lambda: not value)
    elif isinstance(value, int):
        yield Change("+ 1", lambda: value + 1)
        yield Change("- 1", lambda: value - 1)
    elif isinstance(value, Stated):
        yield from _within(value.operands, lambda operands: Stated(value.operation, tuple(operands)))
    elif isinstance(value, sp.MatrixBase):
        yield from _of_matrix(value)
    elif isinstance(value, sp.core.relational.Relational | sp.logic.boolalg.BooleanFunction):
        yield from _within(value.args, lambda sides: value.func(*sides))
    elif isinstance(value, sp.Poly):
        yield from _within(value.all_coeffs(), lambda found: sp.Poly(found, value.gen, domain=value.domain))
    elif isinstance(value, sp.Expr):
        yield from _of_expression(value)
    elif isinstance(value, DomainMatrix):
        yield from _of_domain_matrix(value)
    elif isinstance(value, Mapping):
        yield from _of_mapping(value)
    elif isinstance(value, list | tuple):
        yield from _of_sequence(value, type(value), derived=derived)
    elif is_dataclass(value) and not isinstance(value, type):
        yield from _of_object(value, derived=derived)


def _of_expression(value: sp.Expr) -> Iterator[Change]:
    if value.free_symbols:
        yield Change("× 1001/1000", lambda: value * (1 + SMALL))
    else:
        yield Change("+ 1/1000", lambda: value + SMALL)
    if value != 0:
        yield Change("sign turned", lambda: -value)
    number = next((each for each in sp.preorder_traversal(value) if each.is_Number and each not in (-1, value)), None)
    if number is not None:
        yield Change(f"{number} in it + 1/1000", lambda: value.xreplace({number: number + SMALL}))


def _of_matrix(value: sp.MatrixBase) -> Iterator[Change]:
    def build(entries: list[Any]) -> Any:
        return type(value)(*value.shape, entries)

    items = list(value)
    yield from _within(items, build)
    for i, (first, second) in enumerate(pairwise(items)):
        if first != second:
            exchanged = [*items[:i], second, first, *items[i + 2 :]]
            yield Change(f"[{i}], [{i + 1}] exchanged", lambda exchanged=exchanged: build(exchanged))


def _of_sequence(items: Any, build: Callable[[Any], Any], *, derived: bool) -> Iterator[Change]:
    """An item changed or left out; their order is often free."""
    yield from _within(items, build, derived=derived)
    for i in range(len(items)):
        yield Change(f"[{i}] left out", lambda i=i: build([*items[:i], *items[i + 1 :]]))


def _within(items: Any, build: Callable[[Any], Any], *, derived: bool = False) -> Iterator[Change]:
    for i, item in enumerate(items):
        for change in changes(item, derived=derived):
            yield Change(
                f"[{i}] {change.what}", lambda i=i, change=change: build([*items[:i], change.made(), *items[i + 1 :]])
            )


def _of_mapping(value: Mapping[Any, Any]) -> Iterator[Change]:
    for key, item in value.items():
        for change in changes(item):
            yield Change(f"[{key}] {change.what}", lambda key=key, change=change: {**value, key: change.made()})


def _of_domain_matrix(value: DomainMatrix) -> Iterator[Change]:
    K = value.domain
    for i in range(value.shape[0]):
        for j in range(value.shape[1]):

            def made(i: int = i, j: int = j) -> DomainMatrix:
                rows = value.to_dense().to_list()
                rows[i][j] = rows[i][j] + K.one / K(1000) if K.is_Field else rows[i][j] + K.one
                return DomainMatrix(rows, value.shape, K)

            yield Change(f"[{i}, {j}] changed", made)


def _of_object(value: Any, *, derived: bool) -> Iterator[Change]:
    """A field changed, or a property that is found from the fields."""
    for field in fields(value):
        for change in changes(getattr(value, field.name), derived=False):
            yield Change(
                f".{field.name}{_joined(change.what)}",
                lambda name=field.name, change=change: _with_field(value, name, change.made()),
            )
    for name in _properties(type(value)) if derived and hasattr(value, "__dict__") else ():
        for change in changes(getattr(value, name), derived=False):
            yield Change(
                f".{name}{_joined(change.what)}",
                lambda name=name, change=change: _with_property(value, name, change.made()),
            )


def _joined(what: str) -> str:
    return what if what.startswith((".", "[")) else f" {what}"


def _properties(kind: type) -> list[str]:
    return sorted(name for name, each in vars(kind).items() if isinstance(each, property | cached_property))


def _with_field(value: Any, name: str, changed: Any) -> Any:
    """The object with another value of a field; what was found from the old one is forgotten."""
    made = object.__new__(type(value))
    for field in fields(value):
        object.__setattr__(made, field.name, changed if field.name == name else getattr(value, field.name))
    return made


def _with_property(value: Any, name: str, changed: Any) -> Any:
    """The object with another value of a property."""
    made = copy.copy(value)
    kind = type(value)
    object.__setattr__(made, "__class__", type(kind.__name__, (kind,), {name: property(lambda _: changed)}))
    return made
