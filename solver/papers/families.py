"""Members of a family, each solved and verified, and written in the formats asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from pathlib import PurePath
from typing import Any, Protocol

from solver.derivation import Status
from solver.document.formats import FORMATS
from solver.document.model import Presentation
from solver.document.works import document_of, solve_as_told
from solver.executors import Arguments, Executor
from solver.limits import Exceeded, Limits
from solver.papers.difficulty import Difficulty, difficulty_of
from solver.papers.judging import Rejection
from solver.papers.search import TOGETHER, Candidate, Search
from solver.problem.family import Family
from solver.problem.members import member_text
from solver.problem.model import Problem
from solver.problem.source import Diagnostic, InputError, Source

YAML = "yaml"


@dataclass(frozen=True, slots=True)
class Wanted:
    """What is wanted of each member: its formats, how it is told, what it may take, whether its difficulty is told."""

    formats: tuple[str, ...] = ()
    presentation: Presentation = field(default_factory=Presentation)
    limits: Limits = field(default_factory=Limits)
    difficulty: bool = False


@dataclass(frozen=True, slots=True)
class Made:
    """What is made of a candidate: its status, why it is not verified, files by name, and how difficult it is."""

    status: Status
    reason: str
    files: Mapping[str, bytes]
    difficulty: Difficulty | None = None


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


class Memory(Protocol):
    """Knows what was made before of the texts of members."""

    def get(self, text: str) -> Made | None:
        """Return what was made of a text, None where that is not known."""

    def put(self, text: str, made: Made) -> None:
        """Keep what was made."""


def members(
    search: Search,
    count: int,
    wanted: Wanted,
    name: str,
    make: Callable[[str, str, Any], Made] | None = None,
    memory: Memory | None = None,
) -> Iterator[Member]:
    """Yield members until there are as many as wanted, fewer where the search ends before.

    `name` is what their names begin with; `make` is called in place of `made` where something else is made of them.
    """
    candidates, found, width = search.candidates(), 0, max(2, len(str(count)))
    while found < count and (some := list(islice(candidates, min(count - found, TOGETHER)))):
        calls = [(each.text, search.source.name, wanted) for each in some]
        parts = sum(len(part.methods) for part in some[0].problem.parts)
        limits = wanted.limits.times(parts)
        results = dict(enumerate(all_made(search.executor, limits, make or made, calls, memory)))
        for place, candidate in enumerate(some):
            if (why := _wrong(results[place])) is not None:
                search.take_back(why)
                continue
            found += 1
            yield _member(found, f"{name}-{found:0{width}}", candidate, results[place], search)


def all_made(
    executor: Executor, limits: Limits, make: Callable[..., Made], calls: Sequence[Arguments], memory: Memory | None
) -> list[Any]:
    """Return what is made of texts, or Exceeded, in their order; a call begins with the text. What is known is kept."""
    results: list[Any] = [memory.get(call[0]) if memory else None for call in calls]
    left = [place for place, result in enumerate(results) if result is None]
    for number, result in executor.calls(limits, make, [calls[place] for place in left]):
        results[left[number]] = result
        if memory and isinstance(result, Made) and result.status is Status.VERIFIED:
            memory.put(calls[left[number]][0], result)
    return results


def _wrong(result: Made | Exceeded) -> Rejection | None:
    """Return why a candidate is no member, None where it is verified."""
    if isinstance(result, Exceeded):
        return Rejection.by_limits(result.reason)
    if result.status is not Status.VERIFIED:
        return Rejection(f"it is {result.status}: {result.reason}", own=True)
    return None


def _member(number: int, name: str, candidate: Candidate, result: Made, search: Search) -> Member:
    """Return a member with its own file among what was made of it."""
    heading = f"{PurePath(search.source.name).name}, seed {search.seed}, member {number}: {candidate.draw.told}"
    text = member_text(search.source, candidate.draw.texts, heading)
    return Member(number, name, candidate.draw.texts, text, result)


def made(text: str, source: str, wanted: Wanted) -> Made:
    """Solve and verify a member and write it in the formats wanted, in this process.

    The names of files are the endings of its own, or names of what stands beside it.
    """
    from solver.problem.reader import read_problem  # noqa: PLC0415 - sympy comes with it
    from solver.tasks import catalogue  # noqa: PLC0415 - as above

    problem = wanted.presentation.of(read_problem(Source(source, text), catalogue()))
    solution = solve_as_told(problem, wanted.presentation)
    document = document_of(solution, wanted.presentation, PurePath(source).name)
    judged = document if document.presentation.detail in {"full", "tutor"} else document.told(detail="full")
    if judged.status is not Status.VERIFIED:
        reason = next(str(part.reason) for part in judged.parts if part.status is not Status.VERIFIED)
        return Made(judged.status, reason, {})
    files: dict[str, bytes] = {}
    for each in wanted.formats:
        if each != YAML:
            files[FORMATS[each].suffix] = FORMATS[each].write(document)
            files |= FORMATS[each].beside(document)
    return Made(Status.VERIFIED, "", files, difficulty_of(solution, judged) if wanted.difficulty else None)
