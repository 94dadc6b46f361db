"""Solving: every part by each of its methods, every displayed equality and every answer checked.

The engine knows no topic and no kind of system. What is given is converted to what a task needs; a method yields steps
and returns answers; the steps' claims go to the oracle, the answers to the task's verification, and the worst of
the checks decides the status.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from time import perf_counter
from types import MappingProxyType
from typing import Any

from solver.decimals import short_again
from solver.derivation import (
    Answers,
    Check,
    CheckStatus,
    Derivation,
    Given,
    PartResult,
    Status,
    Step,
    Task,
    Unsolved,
)
from solver.derivation.conversion import composed, converted, refused
from solver.derivation.levels import carrying_out
from solver.earlier import Earlier, resolved, rests_on_decimals
from solver.known import has_real_entries, signed, wrong_conditions
from solver.lazy import Call, exact, noted_calls, numeric
from solver.messages import Messages
from solver.postconditions import check_calls
from solver.problem.model import Part, Problem, Reference
from solver.problem.refusals import Refusal, refuse
from solver.systems import EarlierPart, System
from solver.tasks import catalogue
from solver.words import Reason

Runner = Callable[[Problem], Iterator[list[PartResult]]]
"""Solves the parts of a problem in order, one list of results (one a method) for each part."""


@dataclass(frozen=True, slots=True)
class Finding:
    """What a method works on and what it finds, unchecked, with its steps and the calls of kernels for them."""

    given: Given[Any, Any]
    answers: Answers
    steps: Sequence[Step]
    calls: Sequence[Call]


Findings = Mapping[tuple[str, str], Finding]
"""What was found before, without arithmetic, by the part's id and the method: it is not derived again."""

NOTHING_FOUND: Findings = MappingProxyType({})


@dataclass(frozen=True)
class Solution:
    """A problem with what became of its parts: one result for each part and method, in the order asked."""

    problem: Problem
    parts: tuple[PartResult, ...]
    arithmetic: bool = True
    """Whether the steps have the substeps of arithmetic that a page at the level `tutor` shows."""

    @property
    def status(self) -> Status:
        """The worst status of the parts."""
        return Status.worst([part.status for part in self.parts])


def solve_problem(
    problem: Problem,
    runner: Runner | None = None,
    messages: Messages | None = None,
    *,
    arithmetic: bool = True,
    found: Findings = NOTHING_FOUND,
) -> Solution:
    """Solve all parts, here or by a runner that keeps limits. An unsolved part says why and stops no other.

    Without `arithmetic` the steps have no substeps for the level `tutor`; then what was `found` before serves.
    Raises InputError, with the places in the file and in the words of `messages` (None: those of the problem's
    language), where a task finds a question wrong as it is asked.
    """
    results = runner(problem) if runner else solve_parts(problem, messages, arithmetic=arithmetic, found=found)
    return Solution(problem, tuple(result for of_part in results for result in of_part), arithmetic)


def solve_parts(
    problem: Problem,
    messages: Messages | None = None,
    *,
    arithmetic: bool = True,
    found: Findings = NOTHING_FOUND,
) -> Iterator[list[PartResult]]:
    """Solve the parts in order; they may use the answers of earlier ones."""
    said = messages or Messages(language=problem.display.language)
    refuse(problem, {part.id: refusals_of(part, said) for part in problem.parts})
    known: dict[str, PartResult] = {}
    for part in problem.parts:
        results = solve_part(part, known, arithmetic=arithmetic, found=found)
        known[part.id] = results[0]
        yield results


def refusals_of(part: Part, messages: Messages) -> list[Refusal]:
    """Return what the task finds wrong with the question, without the options taken from earlier parts, in words."""
    wrong = [(place, messages.say(fault)) for place, fault in wrong_conditions(part.conditions)]
    if wrong or isinstance(part.system, EarlierPart):
        return wrong  # the system is judged when it is known
    known = {name: None if isinstance(value, Reference) else value for name, value in part.options.items()}
    task = catalogue()[part.task]
    of_system = refused(part.system, [need for need in task.needs if need not in known])
    faults = [("", of_system)] if of_system else task.refused(part.system, known)
    return [(option, messages.reason(fault)) for option, fault in faults]


def solve_part(
    part: Part, earlier: Earlier, *, arithmetic: bool = True, found: Findings = NOTHING_FOUND
) -> list[PartResult]:
    """Solve one part by each of its methods."""
    before = {} if arithmetic else found
    with carrying_out(arithmetic):
        return [_solve_by(method, part, earlier, before.get((part.id, method))) for method in part.methods]


def _solve_by(method: str, part: Part, earlier: Earlier, before: Finding | None) -> PartResult:
    """Solve one part by one method, unless that was done before, and check the result."""
    start = perf_counter()
    task = catalogue()[part.task]
    steps: list[Step] = []
    answers = Answers()
    reason: Reason | None = None
    checks: tuple[Check, ...] = ()
    try:
        found = before or _finding(method, part, earlier, steps)
        steps, answers = list(found.steps), found.answers
        checks = (*numeric.check_steps(steps), *check_calls(found.calls, steps), *task.verify(found.given, answers))
        status, reason = verdict(checks, answers)
    except (Unsolved, exact.NotExact) as refusal:
        status, reason = Status.UNSOLVED, refusal.reason
        checks = numeric.check_steps(steps)
        answers = Answers()
    seconds = perf_counter() - start
    return PartResult(part.id, part.task, method, status, answers, checks, tuple(steps), reason, seconds)


def found_by(
    method: str, part: Part, earlier: Earlier, steps: list[Step] | None = None
) -> tuple[Given[Any, Any], Answers]:
    """Return what a method works on and what it finds, unchecked.

    Its steps are appended to `steps`, without arithmetic. Raises Unsolved, NotExact.
    """
    with carrying_out(False):
        return _found_by(method, part, earlier, [] if steps is None else steps)


def finding(method: str, part: Part, earlier: Earlier) -> Finding:
    """Return what a method finds, unchecked and without arithmetic. Raises Unsolved, NotExact."""
    with carrying_out(False):
        return _finding(method, part, earlier, [])


def _finding(method: str, part: Part, earlier: Earlier, steps: list[Step]) -> Finding:
    with noted_calls(steps) as calls:
        given, answers = _found_by(method, part, earlier, steps)
    return Finding(given, answers, steps, calls)


def _found_by(method: str, part: Part, earlier: Earlier, steps: list[Step]) -> tuple[Given[Any, Any], Answers]:
    given = given_of(part, method, earlier, steps)
    answers = yield_into(steps, catalogue()[part.task].methods[method].derive(given))
    if rests_on_decimals(part, earlier):
        answers = Answers(**{name: short_again(value) for name, value in answers.items()})
    return given, answers


def given_of(part: Part, method: str, earlier: Earlier, steps: list[Step] | None = None) -> Given[Any, Any]:
    """Return what a method works on: options resolved, the system realized and its loop closed where that is asked.

    The steps of that are appended to `steps`. Raises Unsolved, NotExact.
    """
    task = catalogue()[part.task]
    asked = resolved(part, earlier)
    _refuse(task, asked.system, asked.options)
    plant = _plant(task, task.given(signed(asked.system), asked.options, method))
    given: Given[Any, Any] = yield_into([] if steps is None else steps, plant)
    _refuse_any(given.options.misfits(given.system))
    if not task.complex_entries and not has_real_entries(given.system):
        raise Unsolved("linear_algebra/not_real")
    return given


def steps_of(part: Part, method: str, earlier: Earlier) -> list[Step]:
    """Return the steps of a part by a method, those before a refusal where there is one.

    They have no arithmetic, and nothing is checked.
    """
    steps: list[Step] = []
    with carrying_out(False), suppress(Unsolved, exact.NotExact):
        given = given_of(part, method, earlier, steps)
        yield_into(steps, catalogue()[part.task].methods[method].derive(given))
    return steps


def _refuse(task: Task[Any, Any], system: System, options: Mapping[str, Any]) -> None:
    """Refuse what could not be judged before, since it was taken from an earlier part."""
    _refuse_any(task.refused(system, options))


def _refuse_any(faults: Iterable[tuple[str, Reason]]) -> None:
    for _, fault in faults:
        raise Unsolved("engine/refused", fault=fault)


def _plant(task: Task[Any, Any], given: Given[Any, Any]) -> Derivation[Given[Any, Any]]:
    """Bring the system to what the task works on, by conversions; with the loop closed that the options ask for."""
    options = {name: getattr(given.options, name) for name, option in task.options.items() if option.loop}
    has = {name for name in task.options if given.options.has(name)}
    wanted = task.methods[given.method].needs or task.needs
    needs = set(wanted).union(*(task.options[name].needs for name in has)) - has
    system = composed(given.system, options)
    return replace(given, system=(yield from converted(system, needs)))


def yield_into(steps: list[Step], derivation: Derivation[Any]) -> Any:
    """Run a derivation to its end, keeping its steps (also those before a refusal); return its result."""
    while True:
        try:
            steps.append(next(derivation))
        except StopIteration as end:
            return end.value


def verdict(checks: Iterable[Check], answers: Iterable[str]) -> tuple[Status, Reason | None]:
    """Return the status that the checks give to a part with these answers, and the reason if it is not verified.

    A displayed equality may hold where an answer is wrong: every answer needs a check of its own that passed.
    """
    checks = tuple(checks)
    failed = [check for check in checks if check.status is CheckStatus.FAILED]
    if failed:
        return Status.FAILED, Reason("engine/failed_checks", {"failed": len(failed), "checks": len(checks)})
    confirmed = {name for check in checks if check.status is CheckStatus.PASSED for name in check.judges}
    missing = [name for name in answers if name not in confirmed]
    if missing or not confirmed:
        return Status.UNSOLVED, Reason("engine/unchecked", {"answers": missing})
    return Status.VERIFIED, None


__all__ = [
    "Earlier",
    "Finding",
    "Findings",
    "Runner",
    "Solution",
    "Task",
    "finding",
    "given_of",
    "refusals_of",
    "resolved",
    "solve_part",
    "solve_parts",
    "solve_problem",
    "steps_of",
]
