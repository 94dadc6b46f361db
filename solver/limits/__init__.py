"""Solving within limits of time and memory, in a child process that can be killed.

One child solves the parts of a problem in order, puts them into words, and sends each result through a pipe as soon as
it is found: texts and numbers, which can always be sent. The parent keeps the time of each. A child that is too slow,
too large or dead costs only the part (by one method) it was at: that one becomes `unsolved` with the reason, and a new
child goes on with the rest.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.limits.call import Exceeded, call_within
from solver.limits.child import Child, Limits, Reply, Unit
from solver.limits.supervisor import Notify, Progress, Supervision, Supervisor

if TYPE_CHECKING:
    from solver.derivation import Answers, PartResult
    from solver.document.model import Document, Presentation
    from solver.engine import Runner, Solution
    from solver.problem.model import Problem

__all__ = [
    "Child",
    "Exceeded",
    "Limits",
    "Notify",
    "Progress",
    "Solved",
    "Supervision",
    "call_within",
    "in_child",
    "solve_within",
]


@dataclass(frozen=True, slots=True)
class Solved:
    """What a child, or one after the other, sent of a problem: for each part and method its reply."""

    problem: Problem
    replies: list[tuple[Unit, Reply]]
    presentation: Presentation | None = None

    def solution(self) -> Solution:
        """Return the results with their exact answers, without steps."""
        from solver.engine import Solution  # noqa: PLC0415 - sympy comes with it; the child loads it meanwhile

        return Solution(self.problem, tuple(reply.result(unit) for unit, reply in self.replies))

    def document(self, name: str = "") -> Document:
        """Return the solution in words, as the presentation asked for; `name` is the problem's file."""
        from solver.document.model import Presentation  # noqa: PLC0415 - as above
        from solver.document.works import Writer  # noqa: PLC0415 - as above

        writer = Writer(self.problem, self.presentation or Presentation())
        works = [
            writer.work(reply.result(unit), {}) if reply.sent is None or reply.sent.work is None else reply.sent.work
            for unit, reply in self.replies
        ]
        return writer.document(works, name, self.answers)

    def answers(self) -> dict[str, Answers]:
        """Return the exact answers of each part, by its first method."""
        return {unit.part.id: reply.result(unit).answers for unit, reply in reversed(self.replies)}


def solve_within(
    problem: Problem,
    limits: Limits | None = None,
    presentation: Presentation | None = None,
    supervision: Supervision | None = None,
) -> Solved:
    """Solve a problem in a child that keeps the limits (by default those of `Limits()`), in words if it is told how.

    Raises InputError where a task finds a question wrong as it is asked.
    """
    supervisor = Supervisor(problem, limits or Limits(), presentation, supervision or Supervision())
    return Solved(problem, supervisor.replies(), presentation)


def in_child(limits: Limits | None = None, supervision: Supervision | None = None) -> Runner:
    """Return a runner for `solve_problem` that keeps the limits. Its results have exact answers, but no steps."""

    def run(problem: Problem) -> Iterator[list[PartResult]]:
        solution = solve_within(problem, limits, supervision=supervision).solution()
        for part in problem.parts:
            yield [result for result in solution.parts if result.id == part.id]

    return run
