"""The solutions of many problems, found by an executor: without steps, as they are marked.

A problem is solved whole in a process that goes on to the next. One that is not done within the limits of a part is
solved again, each part within its own limits, so that only the part that is stuck is lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.document.model import Presentation
from solver.document.works import solve_as_told
from solver.engine import Solution
from solver.executors import Executor
from solver.limits import Exceeded, Limits, Solved, solve_within
from solver.limits.child import Reply, Unit
from solver.limits.results import sent
from solver.papers.kept import NOTHING, Kept
from solver.papers.marked import keep_solved, solved_before
from solver.problem.model import Problem
from solver.problem.source import Diagnostic, InputError, Source


@dataclass(frozen=True, slots=True)
class Refused:
    """What a task finds wrong with a question, as it is sent."""

    source: Source
    diagnostics: tuple[Diagnostic, ...]


Replies = list[tuple[Unit, Reply]]


def solve_each(problems: Sequence[Problem], limits: Limits, executor: Executor, kept: Kept = NOTHING) -> list[Solution]:
    """Return the solutions in the order of the problems; raises InputError where a question is wrong as it is asked.

    What is kept is not solved again.
    """
    solved = [solved_before(kept, each) for each in problems]
    new = [place for place, each in enumerate(solved) if each is None]
    for place, each in zip(new, _solved([problems[place] for place in new], limits, executor), strict=True):
        keep_solved(kept, each)
        solved[place] = each
    return [each.solution() for each in solved if each is not None]


def _solved(problems: Sequence[Problem], limits: Limits, executor: Executor) -> list[Solved]:
    carried = [replace(each, images={}) for each in problems]
    found: list[Replies | Refused | Exceeded] = list(executor.in_order(limits, _whole, ((each,) for each in carried)))
    left = [place for place, result in enumerate(found) if isinstance(result, Exceeded)]
    wide = limits.around(max((len(carried[place].parts) + len(_units(carried[place])) for place in left), default=0))
    for number, result in executor.calls(wide, _by_parts, ((carried[place], limits) for place in left)):
        found[left[number]] = result
    return [_sent(*each) for each in zip(problems, found, strict=True)]


def _sent(problem: Problem, found: Replies | Refused | Exceeded) -> Solved:
    if isinstance(found, Refused):
        raise InputError(found.source, found.diagnostics)
    if isinstance(found, Exceeded):  # who kept the limits of its parts is lost
        found = [(unit, Reply(failure=found.reason)) for unit in _units(problem)]
    return Solved(problem, found)


def _whole(problem: Problem) -> Replies | Refused:
    """Solve a problem in this process. A bug is raised: it is told of the part that has it, by `_by_parts`."""
    try:
        solution = solve_as_told(problem, Presentation())
    except InputError as error:
        return Refused(error.source, tuple(error.diagnostics))
    return [(unit, Reply(sent=sent(part))) for unit, part in zip(_units(problem), solution.parts, strict=True)]


def _by_parts(problem: Problem, limits: Limits) -> Replies | Refused:
    """Solve a problem in a child of this process, each part by each method within the limits."""
    try:
        return solve_within(problem, limits).replies
    except InputError as error:
        return Refused(error.source, tuple(error.diagnostics))


def _units(problem: Problem) -> list[Unit]:
    return [Unit(part, method) for part in problem.parts for method in part.methods]
