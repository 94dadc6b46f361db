"""How every task grows with the order of the plant: one question by each method, solved and checked, n = 2 … 10.

Targets: two seconds for dense rational plants of order 8 and for companion plants of order 10, and five seconds for
the regulator of a plant of order 4 with random integers.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks.questions import LARGEST, asked, question
from benchmarks.timing import forget
from solver.engine import solve_part
from solver.limits import Exceeded, Limits, call_within
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

ORDERS = (2, 4, 6, 8, 10)
LIMIT = Limits(seconds=40)
TARGETS = {("dense", 8): 2.0, ("companion", 10): 2.0, ("random", 4): 5.0}
"""Seconds of processor time, by kind of plant and order."""


@dataclass(frozen=True)
class Cell:
    """One measurement; `seconds` is None where there is nothing to measure, `remark` what did not go well."""

    kind: str
    n: int
    seconds: float | None
    remark: str = ""

    @property
    def met(self) -> bool:
        """Whether the target is met, if there is one."""
        if self.seconds is None:
            return not self.remark
        return not self.remark and self.seconds <= TARGETS.get((self.kind, self.n), float("inf"))

    def __str__(self) -> str:
        if self.seconds is None:
            return self.remark or "–"
        shown = f"{self.seconds:.2f}" + (f" ({self.remark})" if self.remark else "")
        return shown if self.met else f"**{shown}**"


@dataclass(frozen=True)
class Line:
    """One line of the table."""

    task: str
    method: str
    kind: str
    cells: tuple[Cell, ...]

    @property
    def met(self) -> bool:
        """Whether all targets of the line are met."""
        return all(cell.met for cell in self.cells)

    def __str__(self) -> str:
        return " | ".join(["", self.task, self.method, self.kind, *map(str, self.cells), ""]).strip()


HEADER = "\n".join(
    [
        "| task | method | plant | " + " | ".join(f"n = {n}" for n in ORDERS) + " |",
        "|---|---|---|" + "---|" * len(ORDERS),
    ]
)


def part(task: str, method: str, n: int, kind: str) -> Part:
    """The question of order n as it is read from its text."""
    source = Source("growth.yaml", question(task, method, n, kind))
    return read_problem(source, catalogue()).parts[0]


def seconds(task: str, method: str, n: int, kind: str) -> tuple[float, str]:
    """Processor time of solving and checking, after a small question of the same kind, and what did not go well."""
    solve_part(part(task, method, 2, kind), {})  # imports and one-time tables
    asked_about = part(task, method, n, kind)
    forget()
    start = time.process_time()
    status = str(solve_part(asked_about, {})[0].status)
    taken = time.process_time() - start
    return taken, "" if status == "verified" else status


def lines(chosen: str | None = None) -> Iterator[Line]:
    """A line for each task, method and kind of plant; times in seconds."""
    for task, method, kind in asked():
        if chosen in (None, task):
            yield Line(task, method, kind, tuple(_cell(task, method, kind, n) for n in ORDERS))


def _cell(task: str, method: str, kind: str, n: int) -> Cell:
    if n > LARGEST.get(task, n):
        return Cell(kind, n, None)
    try:
        return Cell(kind, n, *call_within(LIMIT, seconds, task, method, n, kind))
    except Exceeded as limit:
        return Cell(kind, n, None, str(limit))
