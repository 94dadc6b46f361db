"""The process that solves: killable, limited in memory, and quiet about its end. What it sends is plain data."""

from __future__ import annotations

import math
import multiprocessing
import os
import signal
import sys
import traceback
from contextlib import suppress
from dataclasses import dataclass, replace
from importlib import import_module
from multiprocessing.connection import Connection
from pathlib import Path
from pkgutil import iter_modules
from time import process_time
from types import ModuleType
from typing import TYPE_CHECKING

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]  # checked before it is used

from solver.derivation import PartResult, Status
from solver.lazy import exact, numeric
from solver.numeric import judges
from solver.numeric.evaluation import operations
from solver.startup import end_loading, postpone
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from multiprocessing.context import ForkContext, SpawnContext

    from solver.document.model import Presentation
    from solver.document.works import Writer
    from solver.limits.results import Sent
    from solver.problem.model import Part, Problem
    from solver.problem.refusals import Refusal

FORKS = sys.platform.startswith("linux")  # fork is unsafe on macOS and unknown on Windows


SLACK = 60.0
"""So many seconds more than all its children may take, a process that starts them may take itself."""

UNLIMITED = 2**20
"""So many megabytes are more than there are."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What one part, by one method, may take: seconds of time, megabytes of memory beyond what is loaded already.

    Where so many `units` are done in one call, the seconds are those of all.
    """

    seconds: float = 60.0
    megabytes: int = 2048
    units: int = 1

    @property
    def told(self) -> Phrase:
        """Say that the time was not enough: that of one unit, which is what was asked for."""
        return Phrase("time limit of {seconds} s", seconds=f"{self.seconds / self.units:g}")

    def times(self, units: int) -> Limits:
        """Return what so many units may take in one call."""
        return replace(self, seconds=self.seconds * units, units=self.units * units)

    def around(self, units: int) -> Limits:
        """Return what a process may take that has so many units done one by one by children, which keep these."""
        return Limits(self.seconds * units + SLACK, UNLIMITED)


@dataclass(frozen=True, slots=True)
class Unit:
    """What is done under one limit: a part solved by one of its methods or, without a method, its question judged."""

    part: Part
    method: str = ""


@dataclass(frozen=True, slots=True)
class Orders:
    """What a child is to do: units of a problem in order, going on from the first results of earlier parts.

    Each result is put into words where a presentation says how.
    """

    problem: Problem
    units: list[Unit]
    known: dict[str, Sent]
    limits: Limits
    presentation: Presentation | None = None


@dataclass(frozen=True, slots=True)
class Reply:
    """What became of a unit: what is wrong with its question, its result, or why there is none.

    The child can do no more where it is dead or its memory `exhausted`. The parent adds the `seconds` that it waited.
    """

    refusals: tuple[Refusal, ...] = ()
    sent: Sent | None = None
    failure: str = ""
    exhausted: bool = False
    seconds: float = 0.0

    def result(self, unit: Unit) -> PartResult:
        """Return the result of the unit with its exact answers, without steps."""
        if self.sent is not None:
            return self.sent.result()
        part, status = unit.part, Status.UNSOLVED
        ended = Reason("limits/ended", {"words": self.failure})
        return PartResult(part.id, part.task, unit.method, status, reason=ended, seconds=self.seconds)


class Child:
    """A process that does some units in order.

    It may be started before they are known: it loads the algebra in the meantime.
    """

    def __init__(self) -> None:
        context = new_context()
        self.channel, its_end = context.Pipe()
        self.process = context.Process(target=_live, args=(its_end,), daemon=True)
        self.process.start()
        its_end.close()
        self.begun = False

    def __enter__(self) -> Child:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()

    def send(self, orders: Orders) -> None:
        """Send what is to be done."""
        with suppress(OSError):  # the child is dead; `receive` will tell
            self.channel.send(orders)

    def wait_until_it_began(self) -> None:
        """Return when the first unit is being worked on; loading the algebra does not count as its time."""
        if not self.begun:
            with suppress(EOFError, OSError):
                self.begun = self.channel.recv()

    def ready(self, seconds: float) -> bool:
        """Whether there is something to receive, a reply or the child's death, within some seconds."""
        return self.channel.poll(seconds)

    def receive(self) -> Reply:
        """Return what became of a unit, or how the child died."""
        try:
            reply: Reply = self.channel.recv()
        except (EOFError, OSError):
            self.process.join(1.0)
            return Reply(failure=cause_of_death(self.process.exitcode), exhausted=True)
        return reply

    def kill(self) -> None:
        """End the process at once and free what it holds."""
        if self.channel.closed:
            return
        self.process.kill()
        self.process.join()
        self.channel.close()


def new_context() -> ForkContext | SpawnContext:
    """Return how processes are started: by fork, where that is safe."""
    return multiprocessing.get_context("fork") if FORKS else multiprocessing.get_context("spawn")


def cause_of_death(code: int | None) -> str:
    """Return how a process ended that gave no result, in words."""
    if code is not None and code < 0:
        name = signal.Signals(-code).name
        return Phrase("its computation was ended by the system (signal {signal})", signal=name)
    return "its computation ended unexpectedly"


def _live(channel: Connection) -> None:
    """Load the algebra, receive the orders, do the units one by one and send the replies: the life of the child."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent hears it too, and ends the child
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    load_algebra()
    end_loading()  # the parent may have put off collecting garbage
    try:
        orders: Orders = channel.recv()
    except EOFError:  # the parent is gone
        return
    worker = _Worker(orders)
    restrict(orders.limits, len(orders.units))
    channel.send(True)
    for unit in orders.units:
        reply = worker.reply(unit)
        try:
            channel.send(reply)
        except MemoryError:
            reply = Reply(failure=worker.out_of_memory, exhausted=True)
            channel.send(reply)
        if reply.exhausted:
            return


def load_algebra() -> None:
    """Import what every problem needs, in this process and so in all that it starts from now on."""
    for name in ("testing", "f2py"):  # scipy.linalg takes every module of numpy; these two cost as much as itself
        postpone("numpy", name)
    for name in ("solver.limits.results", "solver.document.works", "solver.numeric.evaluation.claims", "scipy.linalg"):
        import_module(name)


def load_all_algebra() -> None:
    """Import what any problem may need, once for several problems."""
    load_algebra()
    topics, _ = _modules_of(judges), _modules_of(operations)
    for package in (exact, numeric, *topics):
        for name in package.__all__:
            getattr(package, name)


def _modules_of(package: ModuleType) -> list[ModuleType]:
    """Import all modules of a package."""
    return [import_module(f"{package.__name__}.{each.name}") for each in iter_modules(package.__path__)]


class _Worker:
    """Does units in the child; `known` has the first result of each part so far."""

    def __init__(self, orders: Orders) -> None:
        from solver.document.model import Presentation  # noqa: PLC0415 - the parent does not need it
        from solver.document.works import Writer  # noqa: PLC0415 - as above

        self.known = {name: sent.result() for name, sent in orders.known.items()}
        self.writer: Writer | None = None
        if orders.presentation is not None:
            self.writer = Writer(orders.problem, orders.presentation)
        self.messages = (orders.presentation or Presentation()).messages(orders.problem.display)
        self.out_of_memory = Phrase("memory limit of {megabytes} MB", megabytes=orders.limits.megabytes)

    def reply(self, unit: Unit) -> Reply:
        """Return what becomes of a unit."""
        from solver.engine import refusals_of  # noqa: PLC0415 - the parent does not need it

        try:
            if not unit.method:
                return Reply(refusals=tuple(refusals_of(unit.part, self.messages)))
            return Reply(sent=self._solved(unit))
        except MemoryError:
            return Reply(failure=self.out_of_memory, exhausted=True)
        except RecursionError:
            return Reply(failure="its expressions are nested too deeply")
        except Exception as bug:  # noqa: BLE001 - the boundary of a part: a bug in one must not lose the others
            return Reply(failure=as_bug(bug))

    def _solved(self, unit: Unit) -> Sent:
        from solver.engine import solve_part  # noqa: PLC0415 - as above
        from solver.limits.results import sent  # noqa: PLC0415 - as above

        writer, asked = self.writer, replace(unit.part, methods=(unit.method,))
        result = solve_part(asked, self.known, arithmetic=writer is not None and writer.presentation.arithmetic)[0]
        self.known.setdefault(result.id, result)
        return sent(result, writer.work(result, self.known) if writer is not None else None)


def as_bug(bug: Exception) -> str:
    """Return a bug of the program in words; the traceback goes to standard error if SOLVE_DEBUG is set."""
    if os.environ.get("SOLVE_DEBUG"):
        traceback.print_exception(bug)
    return Phrase("internal error: {bug}; please report it", bug=f"{type(bug).__name__}: {bug}")


def restrict(limits: Limits, units: int) -> None:
    """Limit this process's memory, and its time from now in case the parent is gone and can't end it."""
    if resource is None:
        return
    with suppress(OSError, ValueError):  # where a system has no such limits, time still ends the child
        seconds = 10 + math.ceil(process_time() + 2 * limits.seconds * units)
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
