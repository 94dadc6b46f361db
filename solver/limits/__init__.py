"""Solving within limits of time and memory, in a child process that can be killed.

One child solves the parts of a problem in order and sends each result through a pipe as soon as it is found. The
parent keeps the time of each. A child that is too slow, too large or dead costs only the part (by one method) it was
at: that one becomes `unsolved` with the reason, and a new child goes on with the rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from time import monotonic
from typing import TYPE_CHECKING

from solver.derivation import PartResult
from solver.limits.call import Exceeded, call_within
from solver.limits.child import Child, Limits, Outcome, Unit, unsolved
from solver.problem.refusals import Refusal, refuse

if TYPE_CHECKING:
    from solver.engine import Runner
    from solver.problem.model import Part, Problem

__all__ = ["Child", "Exceeded", "Limits", "Progress", "call_within", "in_child"]

TICK = 0.1  # seconds between two reports of progress


@dataclass(frozen=True, slots=True)
class Progress:
    """Which part is being solved, by which method, as number `index` (from 0) of `total`."""

    part: str
    method: str
    index: int
    total: int


Notify = Callable[[Progress], None]


def in_child(
    limits: Limits | None = None,
    notify: Notify | None = None,
    meanwhile: Callable[[], None] | None = None,
    child: Child | None = None,
) -> Runner:
    """Return a runner for `solve_problem` that keeps the limits (by default those of `Limits()`).

    `notify` is called ten times a second while a part is being solved; `meanwhile` once, while the first one is.
    `child` is one that was started already.
    """

    def run(problem: Problem) -> Iterator[list[PartResult]]:
        supervisor = _Supervisor(problem, limits or Limits(), notify, meanwhile, child)
        try:
            refuse(problem, supervisor.refusals())
            for part in problem.parts:
                yield [supervisor.result(part, method) for method in part.methods]
        finally:
            supervisor.stop()

    return run


class _Supervisor:
    """The parent's side: starts children, keeps the time, and knows what is still to be solved."""

    def __init__(
        self,
        problem: Problem,
        limits: Limits,
        notify: Notify | None,
        meanwhile: Callable[[], None] | None,
        child: Child | None,
    ) -> None:
        self.limits = limits
        self.notify = notify
        self.meanwhile = meanwhile
        self.parts = problem.parts
        self.units = [Unit(part) for part in self.parts]
        self.units += [Unit(part, method) for part in self.parts for method in part.methods]
        self.done = 0
        self.given_up: dict[str, PartResult] = {}
        self.known: dict[str, PartResult] = {}
        self.child = child
        if child is not None:
            child.send(self.units, self.known, limits)

    def refusals(self) -> dict[str, list[Refusal]]:
        """Return what is wrong with the questions, by the part's id. One that takes too long to judge is given up."""
        found: dict[str, list[Refusal]] = {}
        for part in self.parts:
            outcome = self._next()
            if isinstance(outcome, PartResult):
                self.stop()  # the next one has not to solve it
                self.given_up[part.id] = outcome
                self.units = [unit for unit in self.units if unit.part is not part or not unit.method]
            else:
                found[part.id] = outcome
        return found

    def result(self, part: Part, method: str) -> PartResult:
        """Return what becomes of a part by a method, the next one to be solved."""
        given_up = self.given_up.get(part.id)
        result = self._next() if given_up is None else replace(given_up, method=method)
        assert isinstance(result, PartResult)  # noqa: S101 - the unit has a method
        self.known.setdefault(part.id, result)
        return result

    def _next(self) -> Outcome:
        """Return what becomes of the next unit."""
        unit = self.units[self.done]
        if self.child is None:
            self.child = Child()
            self.child.send(self.units[self.done :], self.known, self.limits)
        if self.meanwhile is not None:
            self.meanwhile()
            self.meanwhile = None
        self.child.wait_until_it_began()
        start = monotonic()
        result = self._wait(start, self.child)
        if isinstance(result, str):
            self.stop()
            result = unsolved(unit, result, monotonic() - start)
        elif self.child.exhausted:
            self.stop()
        self.done += 1
        return result

    def _wait(self, start: float, child: Child) -> Outcome | str:
        """Return the child's next result, or the reason why there is none."""
        end = start + self.limits.seconds
        while not child.ready(min(TICK, max(0.0, end - monotonic()))):
            if monotonic() >= end:
                return f"time limit of {self.limits.seconds:g} s"
            if self.notify is not None:
                unit = self.units[self.done]
                done, total = self.done - len(self.parts), len(self.units) - len(self.parts)
                self.notify(Progress(unit.part.id, unit.method, max(0, done), total))
        return child.receive()

    def stop(self) -> None:
        """End the child, if there is one."""
        if self.child is not None:
            self.child.kill()
            self.child = None
