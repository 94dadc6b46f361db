r"""Written formulas cut at their top level into chains: `F = 1,\quad N = G = 2` are two."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.derivation.displayed import FIRST_MARK, Displayed, Written
from solver.displayed.reading import VALUE, read
from solver.displayed.tree import Meaning, Unreadable, key_of
from solver.formula import MathProblem, latex
from solver.formula import read as tree_of
from solver.formula.nodes import Node, Operator, Space, Table, Text
from solver.formula.vocabulary import RELATIONS
from solver.render.symbols import named

_MARK = re.compile(r"[\U000f0000-\U000ffffd]")
_ENDS = frozenset({",", ";", ":", "."})
_ARROWS = frozenset({r"\Rightarrow", r"\Leftrightarrow", r"\implies", r"\iff"})
_ROW = Operator(r"\\")
"""Stands for the end of an aligned row, which the next may go on with: `a &= b \\\\ &= c` is one chain."""


@dataclass(frozen=True, slots=True)
class Side:
    """A written side of a chain: what it means, or why that can't be read; and the values printed in it."""

    meaning: Meaning | None
    refusal: str = ""
    values: tuple[Any, ...] = ()

    @property
    def value(self) -> Any:
        """The printed value that the side consists of; None where it is another formula."""
        whole = self.meaning is not None and self.meaning.kind == "value"
        return self.values[self.meaning.text] if whole and self.meaning is not None else None


EMPTY = Side(None)


@dataclass(frozen=True, slots=True)
class Chain:
    """A chain: each side a value or a `Side`, and the relation after each side but the last."""

    sides: tuple[Any, ...]
    relations: tuple[str, ...]


def chains_of(displayed: Displayed, parameters: Collection[Any] = ()) -> list[Chain]:
    """Return the chains of a display; what no tree can be made of is left out (the wording refuses it).

    Where one of the `parameters` is printed it is a value, whatever else on the page has its name.
    Of `s = a ± b = [x, y]` the sum and the product of both values are stated: they are a pair without an order.
    """
    chains = _chains(displayed, parameters)
    if not any(
        isinstance(side, Written) and (r"\pm" in side.latex or r"\mp" in side.latex) for side in displayed.sides
    ):
        return chains
    return [each for chain in chains for each in (_of_pairs(chain) if _has_pair(chain) else (chain,))]


def _has_pair(chain: Chain) -> bool:
    return any(isinstance(side, Side) and side.meaning is not None and _branches(side.meaning) for side in chain.sides)


def _of_pairs(chain: Chain) -> Iterator[Chain]:
    """Yield the chains of the sums and of the products of both values; a name in front, or its power, is either."""
    first = chain.sides[0]
    named = isinstance(first, Side) and bool(name_in(first.meaning) or name_in(_base(first.meaning)))
    for kind in ("sum", "product"):
        yield Chain(tuple(_both(side, kind) for side in chain.sides[named:]), chain.relations[named:])


def _base(meaning: Meaning | None) -> Meaning | None:
    return meaning.parts[0] if meaning is not None and meaning.kind == "power" else None


def _both(side: Any, kind: str) -> Any:
    """Return the sum or the product of both values of a side."""
    if isinstance(side, Side) and side.value is None:
        pair = side.meaning and (_branches(side.meaning) or (side.meaning, side.meaning))
        return replace(side, meaning=Meaning(kind, pair)) if pair else side
    value = side.value if isinstance(side, Side) else side
    one, other = value if isinstance(value, list | tuple) and len(value) == 2 else (value, value)
    return one + other if kind == "sum" else one * other


def _branches(meaning: Meaning) -> tuple[Meaning, Meaning] | None:
    """Return a formula with the upper signs of ± and ∓ and with the lower ones; None where there are none."""
    if meaning.kind in ("plus_minus", "minus_plus"):
        plus, minus = meaning.parts[0], Meaning("minus", meaning.parts)
        return (plus, minus) if meaning.kind == "plus_minus" else (minus, plus)
    inner = [_branches(part) for part in meaning.parts]
    if not any(inner):
        return None
    pairs = [found or (part, part) for found, part in zip(inner, meaning.parts, strict=True)]
    upper, lower = (tuple(pair[i] for pair in pairs) for i in (0, 1))
    return replace(meaning, parts=upper), replace(meaning, parts=lower)


def _chains(displayed: Displayed, parameters: Collection[Any]) -> list[Chain]:
    finished: list[Chain] = []
    sides: list[Any] = []
    relations: list[str] = []
    for i, side in enumerate(displayed.sides):
        if i:
            relations.append(displayed.relation or ",")
        if not isinstance(side, Written):
            sides.append(side)
            continue
        *before, last = chains_in(legible(side, parameters)) or (Chain((EMPTY,), ()),)
        for chain in before:
            finished.append(Chain((*sides, *_with(side.values, chain.sides)), (*relations, *chain.relations)))
            sides, relations = [], []
        sides += _with(side.values, last.sides)
        relations += last.relations
    return [*finished, Chain(tuple(sides), tuple(relations))]


def _with(values: tuple[Any, ...], sides: Iterable[Side]) -> list[Side]:
    return [replace(side, values=values) for side in sides] if values else list(sides)


def legible(written: Written, parameters: Collection[Any] = ()) -> str:
    """Return a written formula with names in place of its marks: of variables their own, of values `value0`..."""

    def name(match: re.Match[str]) -> str:
        number = ord(match[0]) - FIRST_MARK
        value = written.values[number]
        is_variable = isinstance(value, sp.Symbol) and value not in parameters
        return f"{{{latex(named(value.name))}}}" if is_variable else rf"\operatorname{{{VALUE}{number}}}"

    return _MARK.sub(name, written.latex) if written.values else written.latex


@lru_cache(maxsize=4096)
def chains_in(text: str) -> tuple[Chain, ...]:
    """Return the chains in a formula; words stand in none, and an unreadable formula has none."""
    try:
        return tuple(_cut(_flat(tree_of(text).items))) if text.strip() else ()
    except MathProblem:
        return ()


def spelled(text: str) -> str:
    """Return a name in the spelling of those that are read."""
    meaning = meaning_in(text)
    return name_in(meaning) if meaning is not None else text


def meaning_in(text: str) -> Meaning | None:
    """Return what a formula of one side means; None where it cannot be read."""
    found = chains_in(text)
    return found[0].sides[0].meaning if found else None


def name_in(meaning: Meaning | None) -> str:
    r"""Return the name that a side consists of: `K_{f}`, `\Phi(t)`; else nothing."""
    if meaning is None:
        return ""
    return str(meaning.text) if meaning.kind == "name" else key_of(meaning) if meaning.kind == "apply" else ""


def names_in(meaning: Meaning | None) -> frozenset[str]:
    """Return all names in a formula."""
    if meaning is None:
        return frozenset()
    own = {str(meaning.text)} if meaning.kind in ("name", "apply") else ()
    return frozenset(own).union(*map(names_in, meaning.parts))


def _flat(items: tuple[Node, ...]) -> list[Node]:
    """Return the items of a formula, those of aligned rows one after another."""
    found: list[Node] = []
    for item in items:
        if isinstance(item, Table) and item.environment == "aligned":
            for row in item.rows:
                found += [each for cell in row for each in cell.items] + [_ROW]
        else:
            found.append(item)
    return found


def _cut(items: list[Node]) -> list[Chain]:
    found: list[Chain] = []
    sides: list[list[Node]] = [[]]
    relations: list[str] = []
    ended_by: Node = _ROW
    for item in [*items, Operator(";")]:
        sign = item.sign if isinstance(item, Operator) else ""
        wide = isinstance(item, Space) and item.command in (r"\quad", r"\qquad")
        if item == _ROW or sign in _ENDS or sign in _ARROWS or wide or _is_text(item):
            if any(sides):
                chain = Chain(tuple(map(_side, sides)), tuple(relations))
                goes_on = found and ended_by == _ROW and not sides[0]
                found[-1 if goes_on else len(found) :] = [_continued(found[-1], chain) if goes_on else chain]
                ended_by = item
            sides, relations = [[]], []
        elif sign in RELATIONS:
            relations.append(sign)
            sides.append([])
        elif not isinstance(item, Space):
            sides[-1].append(item)
    return found


def _is_text(item: Node) -> bool:
    return isinstance(item, Text) and item.command == r"\text"


def _continued(chain: Chain, row: Chain) -> Chain:
    return Chain((*chain.sides, *row.sides[1:]), (*chain.relations, *row.relations))


def _side(items: list[Node]) -> Side:
    if not items:
        return EMPTY
    try:
        return Side(read(tuple(items)))
    except Unreadable as refusal:
        return Side(None, refusal.reason)
