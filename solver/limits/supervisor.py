"""The parent's side: starts children, keeps the time, and knows what is still to be done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import monotonic
from typing import TYPE_CHECKING

from solver.limits.child import Child, Limits, Orders, Reply, Unit
from solver.problem.refusals import refuse

if TYPE_CHECKING:
    from solver.document.model import Presentation
    from solver.limits.results import Sent
    from solver.problem.model import Problem

TICK = 0.1  # seconds between two reports of progress, or two looks at the clock


@dataclass(frozen=True, slots=True)
class Progress:
    """Which part is being solved, by which method, as number `index` (from 0) of `total`."""

    part: str
    method: str
    index: int
    total: int


Notify = Callable[[Progress], None]


@dataclass(frozen=True, slots=True)
class Supervision:
    """What the parent does beside waiting.

    `notify` is called ten times a second while a part is being solved; `meanwhile` once, while the first one is.
    `child` is one that was started already.
    """

    notify: Notify | None = None
    meanwhile: Callable[[], None] | None = None
    child: Child | None = None


class Supervisor:
    """Lets a child do the units of a problem, and a new one go on where it ended."""

    def __init__(
        self, problem: Problem, limits: Limits, presentation: Presentation | None, supervision: Supervision
    ) -> None:
        self.problem = problem
        self.limits = limits
        self.presentation = presentation
        self.notify = supervision.notify
        self.meanwhile = supervision.meanwhile
        self.questions = [Unit(part) for part in problem.parts]
        self.solving = [Unit(part, method) for part in problem.parts for method in part.methods]
        self.left = [*self.questions, *self.solving]
        self.known: dict[str, Sent] = {}
        self.child = supervision.child
        if self.child is not None:
            self.child.send(self._orders())

    def replies(self) -> list[tuple[Unit, Reply]]:
        """Return what became of each part by each method; raises InputError where a question is wrong as asked."""
        try:
            given_up = self._judge()
            return [(unit, given_up.get(unit.part.id) or self._solve(unit)) for unit in self.solving]
        finally:
            self._stop()

    def _judge(self) -> dict[str, Reply]:
        """Refuse what is wrong as it is asked; return the replies of questions that took too much, by the part's id."""
        judged = {unit.part.id: self._next() for unit in self.questions}
        refuse(self.problem, {name: reply.refusals for name, reply in judged.items()})
        return {name: reply for name, reply in judged.items() if reply.failure}

    def _solve(self, unit: Unit) -> Reply:
        reply = self._next()
        if reply.sent is not None:
            self.known.setdefault(unit.part.id, reply.sent)
        return reply

    def _next(self) -> Reply:
        """Return what becomes of the next unit."""
        unit = self.left[0]
        if self.child is None:
            self.child = Child()
            self.child.send(self._orders())
        if self.meanwhile is not None:
            self.meanwhile()
            self.meanwhile = None
        self.child.wait_until_it_began()
        start = monotonic()
        reply = replace(self._wait(start, self.child, unit), seconds=monotonic() - start)
        self.left = self.left[1:]
        if reply.failure and not unit.method:  # it is not tried
            self.left = [each for each in self.left if each.part is not unit.part]
        if reply.exhausted or (reply.failure and not unit.method):
            self._stop()
        return reply

    def _orders(self) -> Orders:
        return Orders(replace(self.problem, images={}), self.left, self.known, self.limits, self.presentation)

    def _wait(self, start: float, child: Child, unit: Unit) -> Reply:
        """Return the child's next reply, or the reason why there is none."""
        end = start + self.limits.seconds
        while not child.ready(TICK):
            if monotonic() >= end:
                return Reply(failure=self.limits.told, exhausted=True)
            if self.notify is not None:
                index = self.solving.index(unit) if unit.method else 0
                self.notify(Progress(unit.part.id, unit.method, index, len(self.solving)))
        return child.receive()

    def _stop(self) -> None:
        """End the child, if there is one."""
        if self.child is not None:
            self.child.kill()
            self.child = None
