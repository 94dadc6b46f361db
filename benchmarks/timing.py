"""Timing with fresh caches, and the rows of the table.

A repetition starts with every cache empty (sympy's, and ours), so it costs what the first such problem costs in a
process that has the libraries loaded. Times are the least processor times, as `timeit` advises: what a repetition takes
longer comes from other processes on the machine. Ours and the peer's are measured in turns in the same run.
"""

from __future__ import annotations

import atexit
import gc
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from itertools import count
from statistics import median
from time import perf_counter, process_time
from typing import Any

from sympy.core.cache import clear_cache


@dataclass(frozen=True)
class Row:
    """One line of the table; times in milliseconds. A target bounds our time, the ratio peer/ours, or both."""

    name: str
    ours: float
    peer_name: str = ""
    peer: float | None = None
    at_least: float | None = None
    at_most: float | None = None

    @property
    def ratio(self) -> float | None:
        """How many times faster than the peer we are."""
        return None if self.peer is None else self.peer / self.ours

    @property
    def target(self) -> str:
        """The target in words."""
        bounds = [f"≥ {self.at_least:g}×"] if self.at_least is not None else []
        bounds += [f"≤ {self.at_most:.4g} ms"] if self.at_most is not None else []
        return ", ".join(bounds)

    @property
    def met(self) -> bool:
        """Whether every bound holds."""
        fast = self.at_most is None or self.ours <= self.at_most
        return fast and (self.at_least is None or (self.ratio or 0.0) >= self.at_least)


@dataclass(frozen=True)
class Failure:
    """A row that could not be measured, with the reason; it counts as not met."""

    name: str
    reason: str
    met: bool = False


def forget() -> None:
    """Empty sympy's caches and those of every function of the package."""
    clear_cache()
    for name, module in list(sys.modules.items()):
        if name.split(".")[0] == "solver":
            for value in list(vars(module).values()):
                if callable(getattr(value, "cache_clear", None)):
                    value.cache_clear()


LEAST_TURNS, LEAST_SECONDS = 5, 5.0
"""How often, and how long, a time is measured anew: a machine shared with others is slow for seconds on end."""


def _turns() -> Iterator[int]:
    start = perf_counter()
    for turn in count():
        if turn >= LEAST_TURNS and perf_counter() - start > LEAST_SECONDS:
            return
        yield turn


def milliseconds(work: Callable[[], Any]) -> float:
    """The least time of the work with caches emptied before each repetition."""
    work()  # imports and one-time tables
    with without_collection():
        return 1000 * min(_timed(work) for _ in _turns())


@contextmanager
def without_collection() -> Iterator[None]:
    """Collect no garbage, like `timeit`: a collection goes through all that is loaded, whoever set it off."""
    gc.collect()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()


def _timed(work: Callable[[], Any]) -> float:
    """The seconds of one run that begins with empty caches."""
    forget()
    start = process_time()
    work()
    return process_time() - start


def milliseconds_of_each(works: Sequence[Callable[[], Any]], warming: int) -> float:
    """The median time of different pieces of work in a warm process; the first ones only warm it."""
    for work in works[:warming]:
        work()
    times = []
    with without_collection():
        for work in works[warming:]:
            start = process_time()
            work()
            times.append(process_time() - start)
    return 1000 * median(times)


def once(work: Callable[[], Any]) -> float:
    """The time of one run with caches empty: for peers that take seconds."""
    return 1000 * _timed(work)


def side_by_side(ours: Callable[[], Any], peer: Callable[[], Any]) -> tuple[float, float]:
    """The least times of ours and of a peer, measured in turns so that both see the same load."""
    times: tuple[list[float], list[float]] = ([], [])
    for work in (ours, peer):
        work()
    with without_collection():
        for _ in _turns():
            for work, kept in zip((ours, peer), times, strict=True):
                kept.append(_timed(work))
    return 1000 * min(times[0]), 1000 * min(times[1])


def processes(*works: Sequence[str], repetitions: int = 9) -> list[tuple[float, float]]:
    """The least wall and CPU time (ms) of Python processes run in turns, without a first run of each, which compiles.

    Raises RuntimeError if one fails.
    """
    times = [[_of_process(arguments) for arguments in works] for _ in range(repetitions + 1)]
    return [(min(wall for wall, _ in each), min(cpu for _, cpu in each)) for each in zip(*times[1:], strict=True)]


def _of_process(arguments: Sequence[str]) -> tuple[float, float]:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = perf_counter()
    output(arguments)
    wall = perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1000 * wall, 1000 * (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def output(arguments: Sequence[str]) -> str:
    """What a Python process prints; raises RuntimeError if it fails."""
    finished = subprocess.run(
        [sys.executable, *arguments], capture_output=True, text=True, check=False, env=_with_bytecode()
    )
    if finished.returncode != 0:
        lines = finished.stderr.strip().splitlines()
        raise RuntimeError(lines[-1] if lines else f"exit code {finished.returncode}")
    return finished.stdout


@cache
def _with_bytecode() -> dict[str, str]:
    """Return the environment of processes that keep compiled modules, as an installation does, in a folder of ours."""
    folder = tempfile.mkdtemp(prefix="bytecode")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    return kept | {"PYTHONPYCACHEPREFIX": folder}
