"""Members of a family, each solved and verified, and written in the formats asked for."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import PurePath

from solver.papers.making import Made, Making
from solver.papers.search import Search
from solver.problem.family import Family
from solver.problem.members import headed
from solver.problem.model import Problem
from solver.problem.source import Diagnostic, InputError, Source


@dataclass(frozen=True, slots=True)
class Member:
    """A verified member: its number from 1, its values as they are written, its text, and what was made of it."""

    number: int
    name: str
    values: Mapping[str, str]
    text: str
    made: Made


def family_of(problem: Problem) -> Family:
    """Return the family that a problem tells; raises InputError where it tells none."""
    if problem.family is None:
        note = "a family has vary: {a: {from: 1, to: 9}}, with the default of a under 'parameters'"
        message = "this problem is no family: it has no key 'vary'"
        raise InputError(problem.file or Source(problem.name, ""), [Diagnostic(message, note=note)])
    return problem.family


def members(search: Search, count: int, making: Making, name: str) -> Iterator[Member]:
    """Yield members until there are as many as wanted, fewer where the search ends before.

    `name` is what their names begin with.
    """
    width, file = max(2, len(str(count))), PurePath(search.source.name).name
    for number, found in enumerate(search.candidates(count, making), 1):
        heading = f"{file}, seed {search.seed}, member {number}: {found.draw.told}"
        text = headed(found.text, heading)
        yield Member(number, f"{name}-{number:0{width}}", found.draw.texts, text, found.made)
