"""Solving a part with the result of one call of a kernel changed."""

from __future__ import annotations

import inspect
import os
import pickle
import signal
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from hashlib import sha256
from pathlib import Path
from time import process_time
from typing import Any

from solver import exact
from solver.derivation import PartResult, Status
from solver.document.model import Presentation, Work
from solver.document.works import Writer
from solver.engine import Earlier, solve_part
from solver.problem.files import load
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.tasks import catalogue
from tools.corrupted_kernels.changes import Change, changes

LONGER, LEAST = 5, 2
"""A solution counts as ended after so many times the CPU time of the right one, and these seconds: a changed value can
send an algorithm astray."""
CAUGHT = ("failed", "unsolved", "crashed", "ended")
SURVIVED, SAME = "survived", "no effect"
KERNELS = sorted(name for name in exact.__all__ if inspect.isfunction(getattr(exact, name)))


@dataclass(frozen=True)
class Outcome:
    """What became of a part whose kernel was corrupted; `shown` says how the page differs, where it survived."""

    problem: str
    part: str
    task: str
    method: str
    kernel: str
    call: int
    change: str
    became: str
    shown: str = ""

    @property
    def key(self) -> str:
        """The case in one line."""
        return f"{self.problem} {self.part} {self.method}: {self.kernel}#{self.call} {self.change}"


@dataclass(frozen=True)
class Right:
    """The part as it is, and the CPU time that a solution may take."""

    work: Work
    seconds: float


class Ended(BaseException):
    """The time of a solution is over."""


@dataclass
class Calls:
    """The calls of kernels by the tasks: their results, and which one is to be changed.

    What a kernel found is `known` for its arguments from one solution to the next.
    """

    known: dict[Any, Any]
    results: dict[str, list[Any]] = field(default_factory=lambda: defaultdict(list))
    target: tuple[str, int] | None = None
    change: Change | None = None

    def wrapped(self, name: str, kernel: Callable[..., Any]) -> Callable[..., Any]:
        """The kernel, with its results noted or changed."""

        def called(*arguments: Any, **named: Any) -> Any:
            result = self._found(name, kernel, arguments, named)
            number = len(self.results[name])
            self.results[name].append(result)
            return self.change.made() if self.change and self.target == (name, number) else result

        return called

    def _found(self, name: str, kernel: Callable[..., Any], arguments: Any, named: dict[str, Any]) -> Any:
        key = name, arguments, *sorted(named.items())
        try:
            hash(key)
        except TypeError:  # arguments that are lists
            return kernel(*arguments, **named)
        if key not in self.known:
            self.known[key] = kernel(*arguments, **named)
        return self.known[key]


@contextmanager
def watched(calls: Calls) -> Iterator[None]:
    """Within it the tasks see kernels whose calls are noted."""
    kernels = {name: getattr(exact, name) for name in KERNELS}
    for name, kernel in kernels.items():
        setattr(exact, name, calls.wrapped(name, kernel))
    try:
        yield
    finally:
        for name, kernel in kernels.items():
            setattr(exact, name, kernel)


@dataclass(frozen=True)
class Extent:
    """How much is tried for a part: `changes` of the result of a call, `calls` of a kernel (None: all of them)."""

    changes: int = 3
    calls: int | None = None


def outcomes(path: Path, extent: Extent, presentation: Presentation) -> list[Outcome]:
    """What becomes of a problem's parts where kernels are corrupted; made in a process of its own."""
    read_end, write_end = os.pipe()
    child = os.fork()
    if not child:
        os.close(read_end)
        with os.fdopen(write_end, "wb") as pipe:
            pickle.dump(list(_outcomes(path, extent, presentation)), pipe)
        os._exit(0)
    os.close(write_end)
    with os.fdopen(read_end, "rb") as pipe:
        found: list[Outcome] = pickle.load(pipe)  # noqa: S301 - our own child
    os.waitpid(child, 0)
    return found


def _outcomes(path: Path, extent: Extent, presentation: Presentation) -> Iterator[Outcome]:
    problem = read_problem(load(path), catalogue())
    writer = Writer(problem, presentation)
    known: dict[str, PartResult] = {}
    for part in problem.parts:
        for method in part.methods:
            by_method = replace(part, methods=(method,))
            calls, start = Calls({}), process_time()
            with watched(calls):
                result, work = _solved(by_method, known, writer)
            seconds = LEAST + LONGER * (process_time() - start)
            known.setdefault(part.id, result)
            if work.status is not Status.VERIFIED:
                continue
            for name, number, change in _cases(f"{path.stem} {part.id} {method}", calls, extent):
                changed = Calls(calls.known, target=(name, number), change=change)
                became, shown = _corrupted(by_method, known, writer, changed, Right(work, seconds))
                yield Outcome(path.stem, part.id, part.task, method, name, number, change.what, became, shown)


def _cases(seed: str, calls: Calls, extent: Extent) -> Iterator[tuple[str, int, Change]]:
    """Some changes of some calls, always the same ones."""

    def order(place: str) -> bytes:
        return sha256(f"{seed} {place}".encode()).digest()

    for name, results in calls.results.items():
        numbers = sorted(range(len(results)), key=lambda number, name=name: order(f"{name} {number}"))
        for number in numbers[: extent.calls]:
            found = {f"{name} {number} {change.what}": change for change in changes(results[number])}
            for place in sorted(found, key=order)[: extent.changes]:
                yield name, number, found[place]


def _solved(part: Part, known: Earlier, writer: Writer) -> tuple[PartResult, Work]:
    result = solve_part(part, known)[0]
    return result, writer.work(result, known)


def _corrupted(part: Part, known: Earlier, writer: Writer, calls: Calls, right: Right) -> tuple[str, str]:
    """What becomes of the part, and how its page differs; a page is written only of what the engine verified."""
    try:
        with limited(right.seconds), watched(calls):
            result = solve_part(part, known)[0]
            work = writer.work(result, known) if result.status is Status.VERIFIED else result
    except Ended:
        return "ended", ""
    except Exception:  # noqa: BLE001 - the part is lost, as it is in the child process of the program
        return "crashed", ""
    if work.status is Status.FAILED:
        return "failed", ""
    if not isinstance(work, Work) or work.status is not Status.VERIFIED:
        return "unsolved", ""
    differing = difference(right.work, work)
    return (SURVIVED, differing) if differing else (SAME, "")


@contextmanager
def limited(seconds: float) -> Iterator[None]:
    """Within it, what takes too long is ended."""

    def end(*_: object) -> None:
        raise Ended

    signal.signal(signal.SIGVTALRM, end)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)


def difference(right: Work, other: Work) -> str:
    """The first lines in which two pages differ; nothing where they show the same."""
    for before, after in zip(_lines(right), _lines(other), strict=False):
        if before != after:
            return f"{before!r} -> {after!r}"
    return "" if len(_lines(right)) == len(_lines(other)) else "more or fewer lines"


def _lines(work: Work) -> list[str]:
    """What a page shows of a part, line by line: its steps with their figures, its answers."""
    steps = [each for step in work.steps for each in step.walk()]
    texts = [line for step in steps for line in (step.title, *step.markdown.splitlines(), *map(repr, step.figures))]
    return [*texts, *(f"{answer.symbol} = {answer.tex}" for answer in work.answers), work.reason]
