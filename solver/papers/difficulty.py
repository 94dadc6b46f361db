"""How difficult a member is: digits of its answers, steps of its solution, roots within roots."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import astuple, dataclass, fields
from typing import Any

import sympy as sp

from solver.document.model import Document
from solver.document.work import WorkStep
from solver.engine import Solution
from solver.papers.niceness import leaves
from solver.problem.asked import asked_of
from solver.tasks import catalogue


@dataclass(frozen=True, slots=True)
class Difficulty:
    """What makes the answers asked for, and the way to them, laborious.

    `digits` is the length of the longest numerator or denominator, `steps` counts those of a worked solution, `roots`
    tells how deep roots stand in roots (1 is √2), `decimals` how many numbers have no exact form.
    """

    digits: int
    steps: int
    roots: int
    decimals: int


NAMES = {"digits": "digits of a number", "steps": "steps", "roots": "nested roots", "decimals": "decimals"}


@dataclass(frozen=True, slots=True)
class Spread:
    """Of one measure the least, the median and the most, and the numbers of the members with the most of it."""

    name: str
    least: int
    median: int
    most: int
    hardest: tuple[int, ...]


def difficulty_of(solution: Solution, document: Document) -> Difficulty:
    """Return how difficult a solved problem is; the document tells it in full."""
    parts = {part.id: part for part in solution.problem.parts}
    values: list[sp.Expr] = []
    for result in solution.parts:
        asked = asked_of(parts[result.id], catalogue()[result.task])
        found = [each for name in asked if name in result.answers for each in leaves(result.answers[name])]
        values += found or list(leaves(result.answers))  # a verdict rests on the others
    numbers = [number for value in values for number in value.atoms(sp.Rational)]
    return Difficulty(
        digits=max((len(str(abs(part))) for number in numbers for part in (number.p, number.q)), default=0),
        steps=sum(_count(part.steps) for part in document.parts),
        roots=max(map(_depth, values), default=0),
        decimals=sum(len(value.atoms(sp.Float)) for value in values),
    )


def _count(steps: Iterable[WorkStep]) -> int:
    return sum(1 + _count(step.steps) for step in steps)


def _depth(value: Any) -> int:
    """Return how deep roots of numbers stand in roots."""
    inner = max(map(_depth, value.args), default=0)
    is_root = isinstance(value, sp.Pow) and value.exp.is_Rational and not value.exp.is_Integer and value.base.is_number
    return inner + bool(is_root)


def spread_of(found: Sequence[Difficulty]) -> list[Spread]:
    """Return the spread of each measure over some members."""
    spreads: list[Spread] = []
    for index, field in enumerate(fields(Difficulty)):
        values = [astuple(each)[index] for each in found]
        ordered = sorted(values)
        hardest = tuple(number for number, value in enumerate(values, 1) if value == ordered[-1])
        spreads.append(Spread(NAMES[field.name], ordered[0], ordered[len(ordered) // 2], ordered[-1], hardest))
    return spreads
