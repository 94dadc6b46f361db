"""The work of `solve a.yaml b.yaml …`: many files, solved by an executor, written and told as by one process.

A file is solved whole in a process that goes on to the next. One that is not done within the limits of a part is solved
again, each part within its own limits, so that only the part that is stuck is lost.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from solver.cli.outcome import INPUT_AT_FAULT, Asked, Outcome, Screen, guarded, outcome_of
from solver.cli.progress import bar
from solver.executors import Executor
from solver.limits import Exceeded, Limits, solve_within
from solver.problem.model import Problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

if TYPE_CHECKING:
    from solver.cli.keeping import Solved
    from solver.cli.solving import Request
    from solver.problem.images import Image


@dataclass(frozen=True, slots=True)
class File:
    """A file that could be read, with what is asked of it; as a problem where its images are not in its text."""

    place: int
    content: Source | Problem
    asked: Asked

    @property
    def problem(self) -> Problem:
        """The problem; raises InputError."""
        return self.content if isinstance(self.content, Problem) else read_problem(self.content, catalogue())

    @property
    def read(self) -> tuple[Source, Mapping[str, Image]]:
        """The text, and the images in it."""
        if isinstance(self.content, Source):
            return self.content, {}
        return self.content.file or Source(self.content.name, ""), self.content.images


def solve_many(request: Request, kept: Solved) -> int:
    """Solve the files; write each as soon as it is made, tell of them in their order; return the worst exit code.

    What is `kept` of a file that did not change is told again.
    """
    limits = Limits(request.time_limit, request.memory_limit)
    told, screen = _InOrder(), Screen.here()
    with kept, bar("solving", len(request.files)) as advance:
        files = list[File]()
        for place, file in enumerate(request.files):
            if isinstance(found := kept.told.get(file) or _read(request, place, file, screen), File):
                files.append(found)
            else:
                told.add(place, found)
                advance()
        with request.workers.executor() as executor:
            for done, outcome, lasts in _outcomes(executor, files, limits):
                delivered = outcome.deliver(done.asked.file)[0]
                if lasts:
                    kept.put(done.asked.file, *done.read, outcome, delivered)
                told.add(done.place, delivered)
                advance()
    return told.code


def made_of(request: Request, file: str, executor: Executor) -> Outcome:
    """Return what becomes of one file."""
    found = _read(request, 0, file, Screen.here())
    if isinstance(found, Outcome):
        return found
    limits = Limits(request.time_limit, request.memory_limit)
    return next(outcome for _, outcome, _ in _outcomes(executor, [found], limits))


def _read(request: Request, place: int, file: str, screen: Screen) -> File | Outcome:
    """Read a file; return what is wrong with it where it cannot be read."""
    from solver.cli.solving import asked_of, source_of

    asked = asked_of(request, file, screen)
    try:
        source = source_of(file)
        content = read_problem(source, catalogue()) if "![" in source.text else source
    except InputError as error:
        return Outcome(INPUT_AT_FAULT, err=error.render() + "\n")
    return File(place, content, asked)


def _outcomes(executor: Executor, files: Sequence[File], limits: Limits) -> Iterator[tuple[File, Outcome, bool]]:
    """Yield the files and what became of them, as they are found, and whether it lasts: no limit had a part in it."""
    stopped, left, most = list[File](), list[File](), 0
    for place, outcome in executor.calls(limits, solve_whole, [(file,) for file in files]):
        if isinstance(outcome, Exceeded):
            stopped.append(files[place])
        else:
            yield files[place], outcome, True
    for file in stopped:  # before they could be read, perhaps
        if isinstance(units := guarded(file.asked.file, partial(_units_of, file)), Outcome):
            yield file, units, False
        else:
            left.append(file)
            most = max(most, units)
    for place, outcome in executor.calls(limits.around(most), solve_by_parts, [(file, limits) for file in left]):
        file = left[place]
        if isinstance(outcome, Exceeded):
            yield file, Outcome(1, err=f"{file.asked.file}: error: {outcome.reason}\n"), False
        else:
            yield file, outcome, outcome.code == 0


def _units_of(file: File) -> int:
    """Return how many times a file that is solved part by part may take the limits; raises InputError."""
    return sum(1 + len(part.methods) for part in file.problem.parts)


def solve_whole(file: File) -> Outcome:
    """Solve a file in this process. A bug is raised: it is told of the part that has it, by `solve_by_parts`."""
    from solver.document.works import document_of, solve_as_told

    def make() -> Outcome:
        problem, asked = file.problem, file.asked
        solution = solve_as_told(problem, asked.presentation)
        return outcome_of(document_of(solution, asked.presentation, asked.name), asked)

    return guarded(file.asked.file, make, bugs=False)


def solve_by_parts(file: File, limits: Limits) -> Outcome:
    """Solve a file in a child of this process, each part by each method within the limits."""

    def make() -> Outcome:
        solved = solve_within(file.problem, limits, file.asked.presentation)
        return outcome_of(solved.document(file.asked.name), file.asked)

    return guarded(file.asked.file, make)


class _InOrder:
    """Tells of outcomes in the order of their places, of each as soon as those before it are told; keeps the code."""

    def __init__(self) -> None:
        self.code = 0
        self.waiting: dict[int, Outcome] = {}
        self.following = 0

    def add(self, place: int, outcome: Outcome) -> None:
        self.waiting[place] = outcome
        while self.following in self.waiting:
            self.code = max(self.code, self.waiting.pop(self.following).tell())
            self.following += 1
