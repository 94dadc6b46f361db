"""A problem given as data of Python, a mapping: written as a text that is read as any other, with places in words."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import isfinite
from typing import Any

from solver.problem.nodes import Entry, MappingNode, Node
from solver.problem.source import Diagnostic, InputError, Source
from solver.problem.yaml_tree import parse_yaml

DEEPEST = 40


@dataclass(frozen=True)
class Data(Source):
    """A text that was data: its places are told as in Python, `system.A[0][1]`."""

    @property
    def has_lines(self) -> bool:
        """Whether its lines are shown: nobody has seen them."""
        return False

    @cached_property
    def _root(self) -> Node | None:
        """The tree of the text; None where it is too long or too deep for one."""
        try:
            return parse_yaml(Source(self.name, self.text))
        except InputError:
            return None

    def where(self, line: int, column: int) -> str:
        """Return where a place is."""
        path = _path(self._root, (line, column), "") if self._root is not None else ""
        return f"{self.name}: at {path}" if path else self.name


def _path(node: Node, place: tuple[int, int], path: str) -> str:
    """Return the path of the innermost value that a place is in."""
    inside = list(node) if isinstance(node, MappingNode) else list(enumerate(getattr(node, "items", ())))
    for each in inside:
        if isinstance(each, Entry):
            step = f"{path}.{each.key.text}" if path else each.key.text
            if _holds(each.key, place):
                return step
            value = each.value
        else:
            step, value = f"{path}[{each[0]}]", each[1]
        if _holds(value, place):
            return _path(value, place, step)
    return path


def _holds(node: Node, place: tuple[int, int]) -> bool:
    return (node.place.line, node.place.column) <= place < (node.place.end_line, node.place.end_column)


def source_of_data(given: Mapping[Any, Any], name: str = "<problem>") -> Source:
    """Return a mapping as a text; raises InputError where it is nested too deeply.

    Numbers of Python, numpy and sympy, their matrices, texts, truth values, lists and mappings mean what they are.
    """
    return Data(name, json.dumps(_plain(given, name, 0), ensure_ascii=False))


def _plain(value: Any, name: str, depth: int) -> Any:
    """Return a value as JSON has it."""
    if depth > DEEPEST:
        raise InputError(Source(name, ""), [Diagnostic("it is nested too deeply")])
    if value is None or isinstance(value, str | bool | int) or (isinstance(value, float) and isfinite(value)):
        return value
    if isinstance(value, Mapping):
        return {str(key): _plain(each, name, depth + 1) for key, each in value.items()}
    if isinstance(value, list | tuple | set | frozenset | range):
        return [_plain(each, name, depth + 1) for each in value]
    if hasattr(value, "tolist"):  # of numpy, or a matrix of sympy
        return _plain(value.tolist(), name, depth + 1)
    return _expression(value) if hasattr(value, "xreplace") else str(value)


def _expression(value: Any) -> Any:
    """Return an expression of sympy in the notation of problems."""
    import sympy as sp  # noqa: PLC0415 - who has one has loaded it

    if value in {sp.true, sp.false}:
        return bool(value)
    return str(value.xreplace({sp.I: sp.Symbol("j"), sp.E: sp.Symbol("e"), sp.oo: sp.Symbol("inf")}))
