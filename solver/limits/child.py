"""The process that solves: killable, limited in memory, and quiet about its end."""

from __future__ import annotations

import gc
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
from pickle import PickleError
from pkgutil import iter_modules
from types import ModuleType
from typing import TYPE_CHECKING

try:
    import resource
except ImportError:  # Windows
    resource = None  # type: ignore[assignment]  # checked before it is used

from solver.derivation import PartResult, Status
from solver.imports import postpone
from solver.lazy import exact, numeric
from solver.numeric import judges
from solver.numeric.evaluation import operations
from solver.words import Reason

if TYPE_CHECKING:
    from multiprocessing.context import ForkContext, SpawnContext

    from solver.engine import Earlier
    from solver.problem.model import Part
    from solver.problem.refusals import Refusal

FORKS = sys.platform.startswith("linux")  # fork is unsafe on macOS and unknown on Windows


@dataclass(frozen=True, slots=True)
class Unit:
    """What is done under one limit: a part solved by one of its methods or, without a method, its question judged."""

    part: Part
    method: str = ""


@dataclass(frozen=True, slots=True)
class Limits:
    """What one part, by one method, may take: seconds of time, megabytes of memory beyond what is loaded already."""

    seconds: float = 60.0
    megabytes: int = 2048


Outcome = PartResult | list["Refusal"]
"""What became of a unit: a result, or what is wrong with the question (a result too, where that took too much)."""


class Child:
    """A process that solves some units in order.

    It may be started before they are known: it loads the algebra in the meantime.
    """

    def __init__(self) -> None:
        context = new_context()
        self.channel, its_end = context.Pipe()
        self.process = context.Process(target=_live, args=(its_end,), daemon=True)
        self.process.start()
        its_end.close()
        self.begun = False
        self.exhausted = False  # whether it can solve no more, because its memory is full

    def __enter__(self) -> Child:
        return self

    def __exit__(self, *_: object) -> None:
        self.kill()

    def send(self, units: list[Unit], known: Earlier, limits: Limits) -> None:
        """Send the units, with the results they may need."""
        with suppress(OSError):  # the child is dead; `receive` will tell
            self.channel.send((units, dict(known), limits))

    def wait_until_it_began(self) -> None:
        """Return when the first unit is being worked on; loading the algebra does not count as its time."""
        if not self.begun:
            with suppress(EOFError, OSError):
                self.begun = self.channel.recv()

    def ready(self, seconds: float) -> bool:
        """Whether there is something to receive, a result or the child's death, within some seconds."""
        return self.channel.poll(seconds)

    def receive(self) -> Outcome | str:
        """Return what became of a unit, or how the child died."""
        try:
            result: Outcome
            result, self.exhausted = self.channel.recv()
        except (EOFError, OSError):
            self.process.join(1.0)
            return cause_of_death(self.process.exitcode)
        return result

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
        return f"its computation was ended by the system (signal {signal.Signals(-code).name})"
    return "its computation ended unexpectedly"


def _live(channel: Connection) -> None:
    """Load the algebra, receive the units, solve them one by one and send the results: the life of the child."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent hears it too, and ends the child
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    load_algebra()
    gc.freeze()  # what is loaded is no garbage; the parent may have put off collecting
    gc.enable()
    try:
        units, known, limits = channel.recv()
    except EOFError:  # the parent is gone
        return
    restrict(limits, len(units))
    channel.send(True)
    for unit in units:
        outcome, exhausted = _guarded(unit, known, limits)
        if isinstance(outcome, PartResult):
            known.setdefault(outcome.id, outcome)
        _send(outcome, exhausted, channel)
        if exhausted:
            return


def load_algebra() -> None:
    """Import what every problem needs, in this process and so in all that it starts from now on."""
    for name in ("testing", "f2py"):  # scipy.linalg takes every module of numpy; these two cost as much as itself
        postpone("numpy", name)
    for name in ("solver.engine", "solver.numeric.evaluation.claims", "scipy.linalg"):
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


def _guarded(unit: Unit, known: Earlier, limits: Limits) -> tuple[Outcome, bool]:
    """Return what became of one unit and whether the memory was exhausted."""
    from solver.engine import refusals_of, solve_part  # noqa: PLC0415 - the parent does not need it

    try:
        if not unit.method:
            return refusals_of(unit.part), False
        return solve_part(replace(unit.part, methods=(unit.method,)), known)[0], False
    except MemoryError:
        reason = f"memory limit of {limits.megabytes} MB"
    except RecursionError:
        return unsolved(unit, "its expressions are nested too deeply"), False
    except Exception as bug:  # noqa: BLE001 - the boundary of a part: a bug in one must not lose the others
        return unsolved(unit, as_bug(bug)), False
    return unsolved(unit, reason), True


def _send(result: Outcome, exhausted: bool, channel: Connection) -> None:
    """Send a result, or say that it can't be sent (too deeply nested, too large, or not picklable)."""
    if not isinstance(result, PartResult):
        channel.send((result, exhausted))
        return
    try:
        channel.send((result, exhausted))
    except (RecursionError, MemoryError):
        channel.send((_without_answers(result, "its result is too large", result.seconds), exhausted))
    except (PickleError, TypeError, AttributeError, ValueError, RuntimeError) as bug:  # sympy raises the last
        channel.send((_without_answers(result, as_bug(bug), result.seconds), exhausted))


def unsolved(unit: Unit, reason: str, seconds: float = 0.0) -> PartResult:
    """Return the result of a unit that was not solved, with the reason."""
    return _without_answers(PartResult(unit.part.id, unit.part.task, unit.method, Status.UNSOLVED), reason, seconds)


def _without_answers(result: PartResult, reason: str, seconds: float) -> PartResult:
    ended = Reason("limits/ended", {"words": reason})
    return PartResult(result.id, result.task, result.method, Status.UNSOLVED, reason=ended, seconds=seconds)


def as_bug(bug: Exception) -> str:
    """Return a bug of the program in words; the traceback goes to standard error if SOLVE_DEBUG is set."""
    if os.environ.get("SOLVE_DEBUG"):
        traceback.print_exception(bug)
    return f"internal error: {type(bug).__name__}: {bug}; please report it"


def restrict(limits: Limits, units: int) -> None:
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
