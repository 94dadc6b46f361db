"""The constructions of a family: what can be chosen first in it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from functools import reduce
from itertools import pairwise
from operator import add

from solver.conditions import symbols_of
from solver.derivation import PartResult, Unsolved
from solver.engine import given_of
from solver.lazy import exact
from solver.limits import Exceeded, call_within
from solver.papers.constructions import Construction
from solver.papers.constructions.answers import ANSWERS, Asked
from solver.papers.constructions.eigenvalues import FromEigenvalues, Pattern
from solver.papers.constructions.relations import Relations, linear
from solver.papers.constructions.solved import Solved
from solver.papers.formulas import LETTERS, lettered
from solver.papers.judging import answers_of
from solver.problem.family import Family
from solver.problem.model import Problem
from solver.problem.source import Source

LARGE = 4
"""Of a matrix with so many rows hardly any has rational eigenvalues."""

FEW = 10_000
"""So many choices are all looked through in a few seconds."""


def constructions_of(source: Source, family: Family, seed: int, pattern: Pattern) -> list[Construction]:
    """Return the ways to construct draws of a family; `pattern` is the matrix whose eigenvalues must be nice."""
    found: list[Construction] = []
    if family.size <= FEW:
        return found
    if len(pattern) >= LARGE:
        found.append(FromEigenvalues(family, pattern, seed))
    relations = [*_required(family), *_of_answers(source, family)]
    if relations and (equations := linear(both := reduce(add, relations))) is not None:
        found.append(Solved(family, both, equations, seed))
    return found


def _required(family: Family) -> Iterator[Relations]:
    """Yield the equations that are required of what is drawn."""
    for each in family.required:
        if each.chain is not None and "=" in each.chain.signs:
            for left, right in pairwise(each.chain.sides):
                inside = {x.name for x in symbols_of(left, right)}
                letters = tuple(name for name in _letters(family) if name in inside)
                yield Relations((left - right,), letters=((letters, 1),))


def _letters(family: Family) -> list[str]:
    """Return the names that are drawn, those with most values first."""
    return [each.name for each in sorted(family.varied, key=lambda each: -len(each.values))]


def _of_answers(source: Source, family: Family) -> list[Relations]:
    """Return the relations of the answers that must be nice, found within limits."""
    if not any(each.kind != "exact" for each in family.nice):
        return []
    with suppress(Exceeded):
        found: list[Relations] = call_within(LETTERS, relations_of, source, family)
        return found
    return []


def relations_of(source: Source, family: Family) -> list[Relations]:
    """Return the relations of the answers that must be nice, of those parts that have some."""
    problem = lettered(source, family)
    known: dict[str, PartResult] = {}
    parts = dict.fromkeys(each.part for each in family.nice if each.kind != "exact") if problem is not None else ()
    found = [_of_part(name, problem, family, known) for name in parts if problem is not None]
    return [each for each in found if each is not None]


def _of_part(name: str, problem: Problem, family: Family, known: dict[str, PartResult]) -> Relations | None:
    part = next(part for part in problem.parts if part.id == name)
    if part.task not in ANSWERS:
        return None
    kinds = {each.answer: each.kind for each in family.nice if each.part == name and each.kind != "exact"}
    with suppress(Unsolved, exact.NotExact):
        for source in part.sources:
            answers_of(source, problem, known)
        given = given_of(part, part.methods[0], known)
        return ANSWERS[part.task](Asked(name, part.task, given, kinds, _letters(family)))
    return None
