r"""Written formulas cut at their top level into chains: `F = 1,\quad N = G = 2` are two."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.derivation.displayed import FIRST_MARK, Displayed, Written
from solver.formula import MathProblem, latex
from solver.formula import read as tree_of
from solver.formula.nodes import Node, Operator, Space, Table, Text
from solver.formula.vocabulary import RELATIONS
from solver.render.symbols import named

_MARK = re.compile(r"[\U000f0000-\U000ffffd]")
_ENDS = frozenset({",", ";", ":", "."})
_ARROWS = frozenset({r"\Rightarrow", r"\Leftrightarrow", r"\implies", r"\iff"})
VALUE = "value"
"""Stands for the printed values in what is read: the operator `value3` is the fourth."""


@dataclass(frozen=True, slots=True)
class Statement:
    """A chain as written: the items of each side, and the relation after each side but the last."""

    sides: tuple[tuple[Node, ...], ...]
    relations: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Chain:
    """A chain of a display: each side a value, or the items of a written formula with the values printed in it."""

    sides: tuple[Any, ...]
    relations: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Side:
    """A written side of a chain, and the values that its operators `value0`, `value1`, ... stand for."""

    items: tuple[Node, ...]
    values: tuple[Any, ...]


def chains_of(displayed: Displayed) -> list[Chain]:
    """Return the chains of a display; what no tree can be made of is left out (the wording refuses it)."""
    finished: list[Chain] = []
    sides: list[Any] = []
    relations: list[str] = []
    for i, side in enumerate(displayed.sides):
        if i:
            relations.append(displayed.relation or ",")
        if not isinstance(side, Written):
            sides.append(side)
            continue
        *before, last = statements(legible(side)) or (Statement(((),), ()),)
        for statement in before:
            finished.append(_joined(sides, relations, statement, side.values))
            sides, relations = [], []
        sides += [Side(items, side.values) for items in last.sides]
        relations += last.relations
    return [*finished, Chain(tuple(sides), tuple(relations))]


def _joined(sides: list[Any], relations: list[str], statement: Statement, values: tuple[Any, ...]) -> Chain:
    written = [Side(items, values) for items in statement.sides]
    return Chain((*sides, *written), (*relations, *statement.relations))


def legible(written: Written) -> str:
    """Return a written formula with names in place of its marks: of symbols their own, of other values `value0`..."""

    def name(match: re.Match[str]) -> str:
        number = ord(match[0]) - FIRST_MARK
        value = written.values[number]
        return (
            f"{{{latex(named(value.name))}}}" if isinstance(value, sp.Symbol) else rf"\operatorname{{{VALUE}{number}}}"
        )

    return _MARK.sub(name, written.latex) if written.values else written.latex


@lru_cache(maxsize=4096)
def statements(text: str) -> tuple[Statement, ...]:
    """Return the chains in a formula; words stand in none, and an unreadable formula has none."""
    try:
        return tuple(_cut(_flat(tree_of(text).items))) if text.strip() else ()
    except MathProblem:
        return ()


def _flat(items: tuple[Node, ...]) -> list[Node]:
    """Return the items of a formula, those of aligned rows one after another."""
    found: list[Node] = []
    for item in items:
        if isinstance(item, Table) and item.environment == "aligned":
            for row in item.rows:
                found += [each for cell in row for each in cell.items] + [Operator(";")]
        else:
            found.append(item)
    return found


def _cut(items: list[Node]) -> list[Statement]:
    found: list[Statement] = []
    sides: list[list[Node]] = [[]]
    relations: list[str] = []
    for item in [*items, Operator(";")]:
        sign = item.sign if isinstance(item, Operator) else ""
        wide = isinstance(item, Space) and item.command in (r"\quad", r"\qquad")
        if sign in _ENDS or sign in _ARROWS or wide or (isinstance(item, Text) and item.command == r"\text"):
            if any(sides):
                found.append(Statement(tuple(map(tuple, sides)), tuple(relations)))
            sides, relations = [[]], []
        elif sign in RELATIONS:
            relations.append(sign)
            sides.append([])
        elif not isinstance(item, Space):
            sides[-1].append(item)
    return found
