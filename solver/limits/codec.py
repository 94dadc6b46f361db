"""Exact values as plain data, to be sent from one process to another, and back.

Objects of sympy refer to much that cannot be sent (functions within functions, caches), and a deep one overflows the
stack of whoever walks it by recursion. A value is therefore written as a list of nodes, each a tuple of texts, numbers
and the places of earlier nodes; equal parts are written once. What comes back is built as it was written.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.operations import AssocOp
from sympy.polys.polyerrors import OptionError

from solver.conditions import Condition, Parameter
from solver.patches import Element, Program

Node = tuple[Any, ...]
"""A word that tells what it is, and what it is made of."""

AS_WRITTEN: Any = {"evaluate": False}

PLAIN = (str, bool, int, float, type(None))


class NotPlain(TypeError):  # noqa: N818 - said of a value, not of the program
    """A value holds something that is not mathematics."""


def encode(value: Any) -> list[Node]:
    """Return a value (expressions, matrices, texts, numbers, lists and mappings of them) as nodes, itself the last.

    Raises NotPlain.
    """
    nodes: list[Node] = []
    places: dict[int, int] = {}
    kept = [value]  # so that no two values have the same identity
    stack: list[tuple[Any, list[Any] | None]] = [(value, None)]
    while stack:
        each, parts = stack.pop()
        if id(each) in places:
            continue
        if parts is None:
            parts = _parts(each)
            kept.extend(parts)
            stack.append((each, parts))
            stack.extend((part, None) for part in parts if id(part) not in places)
        else:
            nodes.append((*_head(each), tuple(places[id(part)] for part in parts)))
            places[id(each)] = len(nodes) - 1
            kept.append(each)
    return nodes


def decode(nodes: Iterable[Node]) -> Any:
    """Return the value of some nodes."""
    values: list[Any] = []
    for word, *data, places in nodes:
        values.append(MAKERS[word](*data, [values[place] for place in places]))
    return values[-1]


def _parts(value: Any) -> list[Any]:
    """Return what a value is made of."""
    if isinstance(value, list | tuple):
        return list(value)
    if isinstance(value, Mapping):
        return [each for entry in value.items() for each in entry]
    if isinstance(value, sp.MatrixBase):
        return list(value.flat())
    if isinstance(value, Program | Element | Parameter):
        return _parts_of_object(value)
    if isinstance(value, sp.Symbol | sp.Number):
        return []
    return list(value.args) if isinstance(value, sp.Basic) else []


def _parts_of_object(value: Program | Element | Parameter) -> list[Any]:
    if isinstance(value, Parameter):
        return [each.difference for each in value.conditions]
    if isinstance(value, Program):
        return [value.reference, *value.elements, dict(value.readout)]
    return [value.id, value.kind, value.inputs, value.value, value.setting, value.initial]


def _head(value: Any) -> Node:
    """Return a node without the places of its parts."""
    if type(value) in PLAIN:
        return ("plain", value)
    if isinstance(value, Mapping):
        return ("mapping",)
    if isinstance(value, list | tuple):
        return ("list" if isinstance(value, list) else "tuple",)
    if isinstance(value, Program | Element):
        return ("program" if isinstance(value, Program) else "element",)
    return ("matrix", value.rows, value.cols) if isinstance(value, sp.MatrixBase) else _head_of_expression(value)


def _head_of_expression(value: Any) -> Node:
    kind = type(value)
    if issubclass(kind, sp.Symbol):
        index = value.dummy_index if issubclass(kind, sp.Dummy) else None
        assumed = tuple(sorted(value._assumptions_orig.items()))
        node: Node = ("symbol", value.name, assumed, index)
        if issubclass(kind, Parameter):
            node = ("parameter", value.name, assumed, tuple(each.relation for each in value.conditions))
    elif isinstance(value, sp.Float):
        sign, mantissa, exponent, bits = value._mpf_
        node = ("decimal", (int(sign), int(mantissa), int(exponent), int(bits)), int(value._prec))
    elif isinstance(value, sp.Rational):
        node = ("fraction", int(value.p), int(value.q))
    elif isinstance(value, AppliedUndef):
        node = ("function", str(value.func.name))
    elif isinstance(value, sp.Basic) and kind.__module__.startswith("sympy."):
        node = ("sympy", kind.__module__, kind.__qualname__)
    else:
        raise NotPlain(f"{kind.__name__} is not mathematics")
    return node


def _symbol(name: str, assumed: Iterable[tuple[str, bool]], index: int | None, _: list[Any]) -> Any:
    if index is None:
        return sp.Symbol(name, **dict(assumed))
    return sp.Dummy(name, dummy_index=index, **dict(assumed))


def _parameter(name: str, assumed: Iterable[tuple[str, bool]], relations: Iterable[str], parts: list[Any]) -> Any:
    return Parameter(name, tuple(map(Condition, _exact(parts), relations)), **dict(assumed))


def _exact(parts: list[Any]) -> list[Any]:
    """Return the parts of an object of sympy, which takes a text for one to be evaluated; raises NotPlain."""
    if not all(isinstance(part, sp.Basic) for part in parts):
        raise NotPlain("a part of an expression is no expression")
    return parts


def _applied(module: str, name: str, parts: list[Any]) -> Any:
    """Return an object of sympy of that class, not evaluated further."""
    kind: Any = getattr(import_module(module), name) if module.startswith("sympy.") else None
    if kind is None or sp.Basic not in kind.__mro__:
        raise NotPlain(f"{name} is not mathematics")
    _exact(parts)
    if AssocOp in kind.__mro__:
        return kind._from_args(parts)
    if not parts:
        return kind()
    try:
        return kind(*parts, **AS_WRITTEN)
    except (TypeError, OptionError):  # it knows no such thing
        return kind(*parts)


MAKERS: Mapping[str, Callable[..., Any]] = {
    "plain": lambda value, _: value,
    "list": list,
    "tuple": tuple,
    "mapping": lambda parts: dict(zip(parts[::2], parts[1::2], strict=True)),
    "matrix": lambda rows, columns, parts: sp.ImmutableMatrix(rows, columns, _exact(parts)),
    "program": lambda parts: Program(parts[0], tuple(parts[1:-1]), parts[-1]),
    "element": lambda parts: Element(*parts),
    "symbol": _symbol,
    "parameter": _parameter,
    "decimal": lambda value, precision, _: sp.Float._new(tuple(map(int, value)), precision, zero=False),
    "fraction": lambda p, q, _: sp.Rational(int(p), int(q)),
    "function": lambda name, parts: sp.Function(name)(*_exact(parts)),
    "sympy": _applied,
}
