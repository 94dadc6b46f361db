"""Solving within limits of time and memory, in a child process that can be killed.

One child solves the parts of a problem in order and sends each result through a pipe as soon as it is found. The
parent keeps the time of each. A child that is too slow, too large or dead costs only the part (by one method) it was
at: that one becomes `unsolved` with the reason, and a new child goes on with the rest.
"""

from __future__ import annotations

import math
import multiprocessing
import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from pathlib import Path
from pickle import PickleError
from time import monotonic

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]  # checked before it is used

from solver.derivation import PartResult, Status
from solver.engine import Earlier, Runner, solve_part
from solver.problem.model import Part, Problem

TICK = 0.1  # seconds between two reports of progress
FORKS = sys.platform.startswith("linux")  # fork is unsafe on macOS and unknown on Windows


@dataclass(frozen=True, slots=True)
class Limits:
    """What one part, by one method, may take: seconds of time, megabytes of memory beyond what is loaded already."""

    seconds: float = 60.0
    megabytes: int = 2048


@dataclass(frozen=True, slots=True)
class Progress:
    """Which part is being solved, by which method, as number `index` (from 0) of `total`."""

    part: str
    method: str
    index: int
    total: int


Unit = tuple[Part, str]
"""What is solved under one limit: a part by one of its methods."""

Notify = Callable[[Progress], None]


def in_child(
    limits: Limits = Limits(), notify: Notify | None = None, meanwhile: Callable[[], None] | None = None
) -> Runner:
    """Return a runner for `solve_problem` that keeps the limits.

    `notify` is called ten times a second while a part is being solved; `meanwhile` once, while the first one is.
    """

    def run(problem: Problem) -> Iterator[list[PartResult]]:
        supervisor = _Supervisor(problem, limits, notify, meanwhile)
        try:
            for part in problem.parts:
                yield [supervisor.next_result() for _ in part.methods]
        finally:
            supervisor.stop()

    return run


class _Supervisor:
    """The parent's side: starts children, keeps the time, and knows what is still to be solved."""

    def __init__(
        self, problem: Problem, limits: Limits, notify: Notify | None, meanwhile: Callable[[], None] | None
    ) -> None:
        self.limits = limits
        self.notify = notify
        self.meanwhile = meanwhile
        self.units: list[Unit] = [(part, method) for part in problem.parts for method in part.methods]
        self.done = 0
        self.known: dict[str, PartResult] = {}
        self.child: _Child | None = None

    def next_result(self) -> PartResult:
        """Return what becomes of the next part and method."""
        part, method = self.units[self.done]
        if self.child is None:
            self.child = _Child(self.units[self.done :], self.known, self.limits)
        start = monotonic()
        result = self._wait(start, self.child)
        if isinstance(result, str):
            self.stop()
            result = _unsolved((part, method), result, monotonic() - start)
        elif self.child.exhausted:
            self.stop()
        self.done += 1
        self.known.setdefault(part.id, result)
        return result

    def _wait(self, start: float, child: _Child) -> PartResult | str:
        """Return the child's next result, or the reason why there is none."""
        if self.meanwhile is not None:
            self.meanwhile()
            self.meanwhile = None
        end = start + self.limits.seconds
        while not child.ready(min(TICK, max(0.0, end - monotonic()))):
            if monotonic() >= end:
                return f"time limit of {self.limits.seconds:g} s"
            if self.notify is not None:
                part, method = self.units[self.done]
                self.notify(Progress(part.id, method, self.done, len(self.units)))
        return child.receive()

    def stop(self) -> None:
        """End the child, if there is one."""
        if self.child is not None:
            self.child.kill()
            self.child = None


class _Child:
    """A process that solves some units in order."""

    def __init__(self, units: list[Unit], known: Earlier, limits: Limits) -> None:
        context = multiprocessing.get_context("fork") if FORKS else multiprocessing.get_context("spawn")
        self.channel, its_end = context.Pipe(duplex=False)
        self.process = context.Process(target=_work, args=(units, dict(known), limits, its_end), daemon=True)
        self.process.start()
        its_end.close()
        self.exhausted = False  # whether it can solve no more, because its memory is full

    def ready(self, seconds: float) -> bool:
        """Whether there is something to receive, a result or the child's death, within some seconds."""
        return self.channel.poll(seconds)

    def receive(self) -> PartResult | str:
        """Return a result, or how the child died."""
        try:
            result: PartResult
            result, self.exhausted = self.channel.recv()
        except (EOFError, OSError):
            self.process.join(1.0)
            return _cause_of_death(self.process.exitcode)
        return result

    def kill(self) -> None:
        """End the process at once and free what it holds."""
        self.process.kill()
        self.process.join()
        self.channel.close()


def _cause_of_death(code: int | None) -> str:
    if code is not None and code < 0:
        return f"its computation was ended by the system (signal {signal.Signals(-code).name})"
    return "its computation ended unexpectedly"


def _work(units: list[Unit], known: dict[str, PartResult], limits: Limits, channel: Connection) -> None:
    """Solve the units one by one and send the results: the life of the child."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent hears it too, and ends the child
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    _restrict(limits, len(units))
    for unit in units:
        result, exhausted = _solve_guarded(unit, known, limits)
        known.setdefault(result.id, result)
        _send(result, exhausted, channel)
        if exhausted:
            return


def _solve_guarded(unit: Unit, known: Earlier, limits: Limits) -> tuple[PartResult, bool]:
    """Return the result of one unit and whether the memory was exhausted."""
    part, method = unit
    try:
        return solve_part(replace(part, methods=(method,)), known)[0], False
    except MemoryError:
        reason = f"memory limit of {limits.megabytes} MB"
    except RecursionError:
        return _unsolved(unit, "its expressions are nested too deeply"), False
    except Exception as bug:  # noqa: BLE001 - the boundary of a part: a bug in one must not lose the others
        return _unsolved(unit, _as_bug(bug)), False
    return _unsolved(unit, reason), True


def _send(result: PartResult, exhausted: bool, channel: Connection) -> None:
    """Send a result, or say that it can't be sent (too deeply nested, too large, or not picklable)."""
    try:
        channel.send((result, exhausted))
    except (RecursionError, MemoryError):
        channel.send((_without_answers(result, "its result is too large"), exhausted))
    except (PickleError, TypeError, AttributeError, ValueError) as bug:
        channel.send((_without_answers(result, _as_bug(bug)), exhausted))


def _unsolved(unit: Unit, reason: str, seconds: float = 0.0) -> PartResult:
    part, method = unit
    return PartResult(part.id, part.task, method, Status.UNSOLVED, reason=reason, seconds=seconds)


def _without_answers(result: PartResult, reason: str) -> PartResult:
    return PartResult(result.id, result.task, result.method, Status.UNSOLVED, reason=reason, seconds=result.seconds)


def _as_bug(bug: Exception) -> str:
    """Return a bug of the program in words; the traceback goes to standard error if SOLVE_DEBUG is set."""
    if os.environ.get("SOLVE_DEBUG"):
        traceback.print_exception(bug)
    return f"internal error: {type(bug).__name__}: {bug}; please report it"


def _restrict(limits: Limits, units: int) -> None:
    """Limit this process's memory, and its time in case the parent is gone and can't end it."""
    if resource is None:
        return
    with suppress(OSError, ValueError):  # where a system has no such limits, time still ends the child
        seconds = 10 + math.ceil(2 * limits.seconds * units)
        _lower(resource.RLIMIT_CPU, seconds)
        _lower(resource.RLIMIT_AS, _address_space() + limits.megabytes * 2**20)


def _lower(limit: int, value: int) -> None:
    """Lower a limit of this process to a value."""
    _, hard = resource.getrlimit(limit)
    resource.setrlimit(limit, (value if hard == resource.RLIM_INFINITY else min(value, hard), hard))


def _address_space() -> int:
    """Return the bytes of address space this process has now (Linux; elsewhere OSError is raised)."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
    return pages * os.sysconf("SC_PAGE_SIZE")
