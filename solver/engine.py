"""Solving: every part by each of its methods, every displayed equality and every answer checked.

The engine knows no topic and no kind of system. What is given is converted to what a task needs; a method yields steps
and returns answers; the steps' claims go to the oracle, the answers to the task's verification, and the worst of
the checks decides the status.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from time import perf_counter
from typing import Any

from solver.decimals import as_printed, exactly, short_again
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
from solver.known import has_real_entries, named_alike, signed, symbols_of, wrong_conditions
from solver.lazy import exact, noted_calls, numeric
from solver.lazy import sympy as sp
from solver.messages import Messages
from solver.postconditions import check_calls
from solver.problem.model import Part, Problem, Reference
from solver.problem.refusals import Refusal, refuse
from solver.systems import EarlierPart, System
from solver.tasks import catalogue
from solver.words import Reason

Earlier = Mapping[str, PartResult]
"""Results of earlier parts by the part's id, each by the part's first method."""

Runner = Callable[[Problem], Iterator[list[PartResult]]]
"""Solves the parts of a problem in order, one list of results (one a method) for each part."""


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
    problem: Problem, runner: Runner | None = None, messages: Messages | None = None, *, arithmetic: bool = True
) -> Solution:
    """Solve all parts, here or by a runner that keeps limits. An unsolved part says why and stops no other.

    Without `arithmetic` the steps have no substeps for the level `tutor`.
    Raises InputError, with the places in the file and in the words of `messages` (None: those of the problem's
    language), where a task finds a question wrong as it is asked.
    """
    results = runner(problem) if runner else solve_parts(problem, messages, arithmetic=arithmetic)
    return Solution(problem, tuple(result for of_part in results for result in of_part), arithmetic)


def solve_parts(
    problem: Problem, messages: Messages | None = None, *, arithmetic: bool = True
) -> Iterator[list[PartResult]]:
    """Solve the parts in order; they may use the answers of earlier ones."""
    said = messages or Messages(language=problem.display.language)
    refuse(problem, {part.id: refusals_of(part, said) for part in problem.parts})
    known: dict[str, PartResult] = {}
    for part in problem.parts:
        results = solve_part(part, known, arithmetic=arithmetic)
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


def solve_part(part: Part, earlier: Earlier, *, arithmetic: bool = True) -> list[PartResult]:
    """Solve one part by each of its methods."""
    with carrying_out(arithmetic):
        return [_solve_by(method, part, earlier) for method in part.methods]


def _solve_by(method: str, part: Part, earlier: Earlier) -> PartResult:
    """Solve one part by one method and check the result."""
    start = perf_counter()
    task = catalogue()[part.task]
    steps: list[Step] = []
    answers = Answers()
    reason: Reason | None = None
    checks: tuple[Check, ...] = ()
    try:
        with noted_calls(steps) as calls:
            given, answers = _found_by(method, part, earlier, steps)
        checks = (*numeric.check_steps(steps), *check_calls(calls, steps), *task.verify(given, answers))
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


def _found_by(method: str, part: Part, earlier: Earlier, steps: list[Step]) -> tuple[Given[Any, Any], Answers]:
    given = given_of(part, method, earlier, steps)
    answers = yield_into(steps, catalogue()[part.task].methods[method].derive(given))
    if _rests_on_decimals(part, earlier):
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


def resolved(part: Part, earlier: Earlier) -> Part:
    """Return a part with what it takes from earlier ones in place of the references to it. Raises Unsolved."""
    own = symbols_of(part)
    options = {name: named_alike(_resolved(name, value, earlier), own) for name, value in part.options.items()}
    return replace(part, system=_system_of(part, earlier, own), options=options)


def steps_of(part: Part, method: str, earlier: Earlier) -> list[Step]:
    """Return the steps of a part by a method, those before a refusal where there is one.

    They have no arithmetic, and nothing is checked.
    """
    steps: list[Step] = []
    with carrying_out(False), suppress(Unsolved, exact.NotExact):
        given = given_of(part, method, earlier, steps)
        yield_into(steps, catalogue()[part.task].methods[method].derive(given))
    return steps


def _system_of(part: Part, earlier: Earlier, own: Mapping[str, Any]) -> Any:
    """Return the system of a part, taken from the result of an earlier part where it refers to one."""
    system = part.system
    if not isinstance(system, EarlierPart):
        return system
    found = earlier[system.part].answers if system.part in earlier else {}
    answers = {name: named_alike(exactly(value), own) for name, value in found.items()}
    taken = system.taken(answers, named_alike(_resolved("gain", system.gain, earlier), own))
    if taken is None:
        raise Unsolved("conversions/no_earlier_system", part=system.part)
    return taken


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


def _resolved(option: str, value: Any, earlier: Earlier) -> Any:
    """Return the option's value, taken from an earlier part where it refers to one."""
    if not isinstance(value, Reference):
        return value
    source = earlier.get(value.part)
    if source is None or value.answer not in source.answers:
        raise Unsolved("engine/missing_answer", answer=value.answer, part=value.part, option=option)
    found = source.answers[value.answer]
    if value.item:
        if not isinstance(found, list) or value.item > len(found):
            raise Unsolved("engine/missing_item", item=value.item, answer=value.answer, part=value.part)
        point = found[value.item - 1]
        return exactly({**_held(source), **point} if isinstance(point, dict) else point)
    return as_printed(found) if isinstance(found, sp.MatrixBase) else found


def _held(source: PartResult) -> dict[Any, Any]:
    """Return the values of what a part keeps constant, which every point that it finds has beside its own."""
    return {name: value for step in source.steps for name, value in step.values.get("held", ())}


def _rests_on_decimals(part: Part, earlier: Earlier) -> bool:
    """Whether a part takes decimals from an earlier one."""
    references = [*part.options.values(), getattr(part.system, "gain", None)]
    taken = [earlier[each.part].answers.get(each.answer) for each in references if isinstance(each, Reference)]
    if isinstance(part.system, EarlierPart):
        taken += earlier[part.system.part].answers.values()
    return any(hasattr(value, "has") and value.has(sp.Float) for each in taken for value in _listed(each))


def _listed(value: Any) -> list[Any]:
    if isinstance(value, dict):
        return list(value.values())
    return [part for each in value for part in _listed(each)] if isinstance(value, list) else [value]


__all__ = [
    "Earlier",
    "Runner",
    "Solution",
    "Task",
    "given_of",
    "refusals_of",
    "resolved",
    "solve_part",
    "solve_parts",
    "solve_problem",
    "steps_of",
]
