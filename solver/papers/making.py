"""What is made of a member: solved and verified, and written in the formats asked for, in one call of a process.

A draw is judged in the same call: what was found to judge it is not derived again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import PurePath
from typing import Any, Protocol

from solver.derivation import Status
from solver.document.formats import FORMATS
from solver.document.model import Presentation
from solver.document.works import document_of, solve_as_told
from solver.engine import refusals_of
from solver.executors import Executor
from solver.limits import Limits
from solver.papers.difficulty import Difficulty, difficulty_of
from solver.papers.judging import Judged, Rejection, judged
from solver.problem.family import Nice, Required
from solver.problem.reader import read_problem
from solver.problem.refusals import Refusal
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

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
class WronglyAsked:
    """What tasks find wrong with the questions of a problem, by the part's id."""

    refusals: Mapping[str, tuple[Refusal, ...]]


Make = Callable[[Judged, str, Any], Made]
"""Makes of a problem, by the name of its file, what is wanted; a function of a module, called in a process."""


class Memory(Protocol):
    """Knows what was made before of the texts of members."""

    def get(self, text: str) -> Made | None:
        """Return what was made of a text, None where that is not known."""

    def put(self, text: str, made: Made) -> None:
        """Keep what was made."""


@dataclass(frozen=True, slots=True)
class Making:
    """What is made of each member: by a function, what is wanted, within the limits of a call; some is known."""

    make: Make
    wanted: Any
    limits: Limits
    memory: Memory | None = None

    def known(self, text: str) -> Made | None:
        """Return what was made of a text before, None where that is not known."""
        return self.memory.get(text) if self.memory else None

    def keep(self, text: str, made: Made) -> None:
        """Keep what was made of a text, if it is verified."""
        if self.memory and made.status is Status.VERIFIED:
            self.memory.put(text, made)


@dataclass(frozen=True, slots=True)
class Tried:
    """A draw that seems to be a member: what tells whether two ask the same, and what was made of it."""

    asked: str
    made: Made | None = None


def tried(
    text: str, source: str, required: Iterable[Required], nice: Iterable[Nice], make: Make | None, wanted: Any
) -> Rejection | Tried:
    """Return why a draw is no member, or what was made of it; nothing is made without `make`."""
    draw = judged(text, source, required, nice)
    if isinstance(draw, Rejection):
        return draw
    return Tried(draw.asked, make(draw, source, wanted) if make is not None else None)


def made_of(text: str, source: str, make: Make, wanted: Any) -> Made | WronglyAsked:
    """Return what is made of the text of a problem."""
    problem = read_problem(Source(source, text), catalogue())
    try:
        return make(Judged(problem), source, wanted)
    except InputError:
        told = wanted.presentation
        messages = told.messages(told.of(problem).display)
        refusals = {part.id: tuple(refusals_of(part, messages)) for part in problem.parts}
        if not any(refusals.values()):
            raise
        return WronglyAsked(refusals)


def all_made(executor: Executor, source: str, making: Making, texts: Sequence[str]) -> list[Any]:
    """Return what is made of texts, or Exceeded, in their order. What is known is kept."""
    results: list[Any] = [making.known(text) for text in texts]
    left = [place for place, result in enumerate(results) if result is None]
    calls = [(texts[place], source, making.make, making.wanted) for place in left]
    for number, result in executor.calls(making.limits, made_of, calls):
        results[left[number]] = result
        if isinstance(result, Made):
            making.keep(calls[number][0], result)
    return results


def made(draw: Judged, source: str, wanted: Wanted) -> Made:
    """Solve and verify a member and write it in the formats wanted, in this process.

    The names of files are the endings of its own, or names of what stands beside it.
    """
    solution = solve_as_told(wanted.presentation.of(draw.problem), wanted.presentation, draw.found)
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
