"""What went wrong, in words: the usual mistakes are run through the question; said only where one gives the very value.

A mistake is words and the values it leads to, or the question it changes (`mistaken_values`, `mistaken_questions`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import sympy as sp

from solver.classroom.judging.entries import entrywise, is_scalar
from solver.classroom.judging.question import STRANGE, Question
from solver.classroom.judging.verdict import judge
from solver.classroom.mistakes.questions import CHANGED, Change, declared
from solver.classroom.mistakes.values import TRANSFORMED, Case
from solver.classroom.submitted import Decimal, Submitted
from solver.classroom.verdicts import Verdict
from solver.derivation import Attempt, PartResult, Task, Unsolved
from solver.engine import given_of, solve_part
from solver.lazy import exact
from solver.problem.model import Part


def what_went_wrong(
    part: Part,
    question: Question,
    name: str,
    submitted: Submitted,
    results: Sequence[PartResult],
    earlier: Mapping[str, PartResult],
) -> str:
    """Return the mistake that leads to the value, in words (Markdown); "" where none of the usual ones does."""
    if question.task.answers[name].count or isinstance(question.ours.get(name), bool | str):
        return ""
    case = Case(part, question, name, question.ours.get(name), results, earlier)
    if not _telling(submitted.value):
        return ""
    for words, values in _values_of(case):
        if any(_reproduces(submitted, value) for value in _careful(values)):
            return words
    for words, holds in ALIKE:
        if _holds(holds, submitted, case.ours):
            return words
    for words, change in _changes_of(question.task):
        if _answers_changed(case, submitted, change):
            return words
    return ""


def _values_of(case: Case) -> Iterator[tuple[str, Callable[[], Iterable[Any]]]]:
    """Yield the mistakes in values: those that the task declares for the answer, then those of any task."""
    attempt: Attempt[Any, Any] = Attempt(case.question.given, case.name, case.question.ours)
    for mistake in case.question.task.mistakes:
        if case.name in mistake.answers:
            yield mistake.words, partial(mistake.values, attempt)
    for words, values in TRANSFORMED:
        yield words, partial(values, case)


def _changes_of(task: Task[Any, Any]) -> Iterator[tuple[str, Change]]:
    """Yield the mistakes that answer another question: those that the task declares, then those of any task."""
    for mistake in task.mistaken_questions:
        yield mistake.words, partial(declared, mistake.change, task)
    yield from CHANGED


def _telling(value: Any) -> bool:
    """Whether a mistake would hardly give the value by chance, as it would yes, no, or a rank."""
    if isinstance(value, list):
        return bool(value)
    return isinstance(value, sp.MatrixBase) or (is_scalar(value) and not value.is_Integer)


def _reproduces(submitted: Submitted, value: Any) -> bool:
    """Whether the submitted value is this one, entry by entry, to the digits written."""
    if isinstance(value, list) and len(value) != len(submitted.value):
        return False
    return _right(entrywise(submitted, value))


def _right(entries: Any) -> bool:
    if isinstance(entries, list):
        return bool(entries) and all(map(_right, entries))
    return bool(entries == Verdict.CORRECT)


def _careful(values: Callable[[], Iterable[Any]]) -> Iterator[Any]:
    """Yield the values of a mistake that can be made here."""
    try:
        yield from values()
    except (*STRANGE, exact.NotExact):  # the mistake has no meaning for this kind of value
        return


def _signs(submitted: Submitted, ours: Any) -> int:
    """In how many entries a matrix has the wrong sign; 0 if anything else is wrong."""
    right = entrywise(submitted, ours)
    if not isinstance(ours, sp.MatrixBase) or right is None:
        return 0
    minus = entrywise(submitted, sp.ImmutableMatrix(-ours))
    pairs = [pair for rows in zip(right, minus, strict=True) for pair in zip(*rows, strict=True)]
    return sum(pair[0] != Verdict.CORRECT for pair in pairs) if all(Verdict.CORRECT in pair for pair in pairs) else 0


def _one_sign(submitted: Submitted, ours: Any) -> bool:
    return _signs(submitted, ours) == 1


def _some_signs(submitted: Submitted, ours: Any) -> bool:
    return _signs(submitted, ours) > 1


def _cut_off(submitted: Submitted, ours: Any) -> bool:
    """Whether decimals stand for numbers whose further digits are cut off, not rounded: up to a unit farther from 0."""
    beyond = {symbol: _beyond(each) for symbol, each in submitted.decimals.items()}
    return bool(beyond) and _right(entrywise(replace(submitted, decimals=beyond), ours))


def _beyond(decimal: Decimal) -> Decimal:
    return decimal._replace(number=decimal.number + decimal.half_unit * (1 if decimal.number >= 0 else -1))


ALIKE: tuple[tuple[str, Callable[[Submitted, Any], bool]], ...] = (
    ("the sign of an entry is reversed", _one_sign),
    ("the signs of some entries are reversed", _some_signs),
    ("the last digit is cut off, not rounded", _cut_off),
)


def _holds(holds: Callable[[Submitted, Any], bool], submitted: Submitted, ours: Any) -> bool:
    try:
        return holds(submitted, ours)
    except STRANGE:  # the two can't be compared
        return False


def _answers_changed(case: Case, submitted: Submitted, change: Change) -> bool:
    """Whether the value is a right answer to the changed question."""
    part = change(case.part)
    if part is None:
        return False
    try:
        result = solve_part(replace(part, methods=part.methods[:1]), case.earlier)[0]
        if case.name not in result.answers:
            return False
        given = given_of(part, part.methods[0], case.earlier)
        changed = Question(case.question.task, given, result.answers)
        return judge(changed, {case.name: submitted})[case.name].verdict is Verdict.CORRECT
    except (*STRANGE, exact.NotExact, Unsolved):  # the changed question has no meaning
        return False
