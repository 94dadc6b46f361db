"""Questions changed by a mistake, and what was found for them: the same for every student of a class."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache, partial
from typing import Any

from solver.classroom.judging.question import STRANGE
from solver.classroom.mistakes.questions import CHANGED, Change, declared
from solver.classroom.same import Same
from solver.derivation import Answers, Given, PartResult, Slip, Step, Task, Unsolved
from solver.engine import found_by, steps_of
from solver.lazy import exact
from solver.problem.model import Part
from solver.tasks import catalogue

KEPT = 200
"""Derivations that are remembered; a part has about ten."""

Found = tuple[Given[Any, Any], Answers]


def changed_questions(part: Part, earlier: Mapping[str, PartResult]) -> Iterator[tuple[Slip, Found]]:
    """Yield the mistakes that answer another question, the task's own first: what is given there, and the answers."""
    for number, (slip, _) in enumerate(_changes_of(catalogue()[part.task])):
        found = _found(part, number, earlier) if part.sources else _remembered(Same(part), number)
        if found is not None:
            yield slip, found


def steps_taken(part: Part, method: str, earlier: Mapping[str, PartResult]) -> list[Step]:
    """Return the steps of a part by a method."""
    return steps_of(part, method, earlier) if part.sources else _remembered_steps(Same(part), method)


@lru_cache(maxsize=KEPT)
def _remembered(same: Same[Part], number: int) -> Found | None:
    return _found(same.it, number, {})


@lru_cache(maxsize=KEPT)
def _remembered_steps(same: Same[Part], method: str) -> list[Step]:
    return steps_of(same.it, method, {})


def _found(part: Part, number: int, earlier: Mapping[str, PartResult]) -> Found | None:
    try:
        _, change = _changes_of(catalogue()[part.task])[number]
        changed = change(part)
        return None if changed is None else found_by(changed.methods[0], changed, earlier)
    except (*STRANGE, exact.NotExact, Unsolved):  # the changed question has no meaning
        return None


def _changes_of(task: Task[Any, Any]) -> list[tuple[Slip, Change]]:
    own: list[tuple[Slip, Change]] = [
        (mistake.slip, partial(declared, mistake.change, task)) for mistake in task.mistaken_questions
    ]
    return [*own, *CHANGED]
