"""Many parts at a time: how many a second by 1 and 2 processes and by a cluster, and what memory they take.

The machine may have other work, so that the wall time of a run says little. What counts is the processor time of a part
in a warm worker, with what it does between two parts and with the garbage of all, and what the parent needs beside it;
`import sympy` tells how quick the machine was. The scaling is what two processes do in the time of one, as measured. On
quiet cores a part is taken to be as many times quicker as `import sympy` is.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise
from pathlib import Path
from statistics import mean
from time import perf_counter, process_time, thread_time

from benchmarks.command_line import IMPORT, text_of
from benchmarks.timing import output
from solver.cli.batch import File, solve_whole
from solver.cli.outcome import Asked, Screen
from solver.document.model import Presentation
from solver.executors import Executor, Processes
from solver.executors.cluster import Cluster
from solver.limits import Limits
from solver.problem.source import Source

WARMING = 8
QUIET = 215.0
"""Milliseconds of `import sympy` where the targets were set."""

PAPERS, QUESTIONS = 100_000, 5
BUSY = 1000
"""So many parts are solved; memory is looked at after a fifth of them and at the end."""


@dataclass(frozen=True)
class Run:
    """Seconds of a run, and of a part in a worker and in the parent; megabytes of a worker early on and at the end."""

    name: str
    parts: int
    jobs: int
    wall: float
    worker: float
    parent: float
    early: float
    late: float
    sympy: float

    @property
    def possible(self) -> float:
        """Parts a second on as many quiet cores as there are jobs; the parent works on them, too."""
        return self.jobs / ((self.worker + self.parent) * QUIET / self.sympy)

    def __str__(self) -> str:
        hours = PAPERS * QUESTIONS / self.possible / 3600
        cells = [self.name, f"{self.parts}", f"{self.parts / self.wall:.0f}", f"{1000 * self.worker:.1f}",
                 f"{1000 * self.parent:.1f}", f"{self.possible:.0f}", f"{self.early:.0f} → {self.late:.0f}",
                 f"{hours:.1f}"]  # fmt: skip
        return "| " + " | ".join(cells) + " |"


HEADER = (
    "| engine | parts | a second, measured | CPU of a part, worker (ms) | parent (ms) | a second on quiet cores "
    "| MB of a worker | hours for 100,000 papers of 5 |\n|---|---|---|---|---|---|---|---|"
)


Stamp = tuple[int, float, float]
"""A process, the processor time that it has taken so far, and the megabytes it holds."""


def stamped(file: File) -> Stamp:
    """Solve, check and write a problem.

    The time is that of the thread: Linux tells that of a process that has a limit of it at its ticks only, some
    milliseconds late.
    """
    outcome = solve_whole(file)
    if outcome.code:
        raise AssertionError(outcome.err or outcome.out)
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return os.getpid(), thread_time(), pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def files(count: int) -> Iterator[tuple[File]]:
    """Problems of order three that differ in their eigenvalues, whole numbers from −1 to −20 as in a course.

    After 1140 they begin again, which no cache remembers.
    """
    eigenvalues = list(combinations(range(1, 21), 3))
    for place in range(count):
        asked = Asked(f"{place}.yaml", ("html",), {"html": Path(f"{place}.html")}, Presentation(), Screen(100))
        yield (File(place, Source(f"{place}.yaml", text_of(eigenvalues[7 * place % len(eigenvalues)])), asked),)


def measured(name: str, executor: Executor, count: int) -> Run:
    """Let an executor do so many parts, after some that warm it."""
    with executor:
        before = [result for _, result in executor.calls(Limits(), stamped, files(WARMING * executor.jobs))]
        start, own = perf_counter(), process_time()
        found = [result for _, result in executor.calls(Limits(), stamped, files(count))]
        wall, parent = perf_counter() - start, process_time() - own
    last = {stamp[0]: stamp for stamp in before}.values()
    worker = mean(seconds_of_each([*last, *found]))
    early, late = max(mb for *_, mb in found[: count // 5]), max(mb for *_, mb in found[-count // 5 :])
    return Run(name, count, executor.jobs, wall, worker, parent / count, early, late, quickness())


def seconds_of_each(stamps: Iterable[Stamp]) -> Iterator[float]:
    """Yield the processor time from each part to the next one of the same process."""
    by_process: dict[int, list[float]] = {}
    for process, seconds, _ in stamps:
        by_process.setdefault(process, []).append(seconds)
    for times in by_process.values():
        yield from (after - before for before, after in pairwise(sorted(times)))


def quickness() -> float:
    """How long `import sympy` takes now, in milliseconds."""
    return min(float(output(["-c", IMPORT])) for _ in range(3))


def main(count: int = BUSY) -> int:
    """Measure and print; return the exit code."""
    engines: dict[str, Callable[[], Executor]] = {
        "1 process": lambda: Processes(1),
        "2 processes": lambda: Processes(2),
        "Dask, 2 workers here": lambda: Cluster(None, 2),
    }
    print(f"import sympy: {quickness():.0f} ms; load of the machine: {os.getloadavg()[0]:.1f}\n")
    print(HEADER)
    runs = []
    for name, start in engines.items():
        runs.append(measured(name, start(), count if "Dask" not in name else count // 4))
        print(runs[-1], flush=True)
    one, two, _ = runs
    print(f"\nscaling, measured: {two.parts / two.wall / (one.parts / one.wall):.2f}; "
          f"possible: {two.possible / one.possible:.2f}")  # fmt: skip
    return 0 if two.possible >= 120 and two.late < 1.3 * two.early else 1
