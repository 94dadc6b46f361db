"""What went wrong: the usual mistakes are run through the question; said only where one gives the very value.

A mistake is a slip and the values it leads to, what undoes it, or the question it changes (`mistakes.values`, `undone`,
`questions`). One that would change nothing here, such as a transposed symmetric matrix, is none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import sympy as sp
from sympy.logic.boolalg import Boolean

from solver.classroom.judging.entries import is_scalar, same
from solver.classroom.judging.question import STRANGE, Question
from solver.classroom.judging.verdict import judge
from solver.classroom.mistakes.alike import ALIKE
from solver.classroom.mistakes.changed import changed_questions
from solver.classroom.mistakes.undone import undone
from solver.classroom.mistakes.values import TRANSFORMED, Case
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import Verdict
from solver.derivation import Answers, Attempt, Given, PartResult, Slip, Unsolved
from solver.derivation import usual_mistakes as usual
from solver.lazy import exact
from solver.patches import Program
from solver.problem.model import Part


def what_went_wrong(
    part: Part,
    question: Question,
    name: str,
    submitted: Submitted,
    results: Sequence[PartResult],
    earlier: Mapping[str, PartResult],
) -> Slip | None:
    """Return the mistake that leads to a wrong value, None where none of the usual ones does."""
    ours = question.ours.get(name)
    value = submitted.value[0] if getattr(submitted.value, "shape", ()) == (1, 1) else submitted.value
    whole = is_scalar(value) and value.is_Integer and value != 0
    if isinstance(ours, bool | str):
        return None
    case = Case(part, question, name, ours, results, earlier)
    if whole:  # many ways lead to a whole number by chance; those that the task names are few
        return next(_own(case, submitted.with_digits(question.digits)), None)
    if question.task.answers[name].count or not _telling(submitted.value):
        return None
    return next(_found(case, submitted.with_digits(question.digits)), None)


def _found(case: Case, submitted: Submitted) -> Iterator[Slip]:
    """Yield the mistakes that lead to the value: the task's own values, what can be undone, then those of any task."""
    yield from _leading_to(case, submitted, values_of(case))
    if isinstance(submitted.value, Boolean):
        return
    for slip, each in undone(case.question, case.name, submitted):
        if _is_right(case.question, case.name, submitted):
            return  # it is wrong beside the other values only, as the order of vectors is
        if _is_right(case.question, case.name, each):
            yield slip
    for slip in _leading_to(case, submitted, ((slip, partial(values, case)) for slip, values in TRANSFORMED)):
        yield _of_another(case, submitted) or slip if slip is usual.INTERMEDIATE else slip
    yield from (slip for slip, holds in ALIKE if _holds(holds, submitted, case))
    for slip, found in changed_questions(case.part, case.earlier):
        if _answers_changed(case, submitted, *found):
            yield slip


def _own(case: Case, submitted: Submitted) -> Iterator[Slip]:
    """Yield the task's own mistakes that lead to the value, the question that it may be taken for among them."""
    yield from _leading_to(case, submitted, values_of(case))
    own = {mistake.slip for mistake in case.question.task.mistaken_questions}
    for slip, found in changed_questions(case.part, case.earlier):
        if slip in own and _answers_changed(case, submitted, *found):
            yield slip


def values_of(case: Case) -> Iterator[tuple[Slip, Callable[[], Iterable[Any]]]]:
    """Yield the mistakes that the task declares for the answer, with their values."""
    attempt: Attempt[Any, Any] = Attempt(case.question.given, case.name, case.question.ours)
    for mistake in case.question.task.mistakes:
        if case.name in mistake.answers:
            yield mistake.slip, partial(mistake.values, attempt)


def _leading_to(
    case: Case, submitted: Submitted, mistakes: Iterable[tuple[Slip, Callable[[], Iterable[Any]]]]
) -> Iterator[Slip]:
    """Yield the mistakes one of whose values is the one submitted, and wrong."""
    for slip, values in mistakes:
        for value in careful(values):
            if _reproduces(submitted, value) and not _is_right(case.question, case.name, Submitted(value, value)):
                yield slip
                break


def _of_another(case: Case, submitted: Submitted) -> Slip | None:
    """The slip of a value found on the way that is another answer's: it need not have been found before this one."""
    for name, ours in case.question.ours.items():
        if name != case.name and type(ours) is type(case.ours) and _reproduces(submitted, ours):
            return usual.of_another_answer(name)
    return None


def _telling(value: Any) -> bool:
    """Whether a mistake would hardly give the value by chance, as it would yes, no, or a rank."""
    if isinstance(value, list | Mapping | Program):
        return isinstance(value, Program) or bool(value)
    if isinstance(value, Boolean):
        return bool(value.free_symbols)
    return isinstance(value, sp.MatrixBase) or (is_scalar(value) and not value.is_Integer)


def _is_right(question: Question, name: str, each: Submitted) -> bool:
    try:
        return judge(question, {name: each})[name].verdict is Verdict.CORRECT
    except STRANGE:  # the value is of a form that the question was never meant for
        return False


def _reproduces(submitted: Submitted, value: Any) -> bool:
    """Whether the submitted value is this one, entry by entry, to the digits written."""
    if isinstance(value, list) and len(value) != len(submitted.value):
        return False
    if isinstance(value, Boolean):
        return _relations(submitted.value) == _relations(value)
    return same(submitted, value)


def _relations(condition: Any) -> frozenset[Any]:
    """The relations of a conjunction, each written in one way."""
    return frozenset(each.canonical if isinstance(each, sp.Rel) else each for each in sp.And.make_args(condition))


def careful(values: Callable[[], Iterable[Any]]) -> Iterator[Any]:
    """Yield the values of a mistake that can be made here."""
    try:
        yield from values()
    except (*STRANGE, exact.NotExact, Unsolved):  # the mistake has no meaning for this kind of value or of system
        return


def _holds(holds: Callable[[Submitted, Case], bool], submitted: Submitted, case: Case) -> bool:
    try:
        return holds(submitted, case)
    except STRANGE:  # the two can't be compared
        return False


def _answers_changed(case: Case, submitted: Submitted, given: Given[Any, Any], answers: Answers) -> bool:
    """Whether the value is a right answer to the changed question, and ours is none."""
    if case.name not in answers:
        return False
    value, ours = answers[case.name], Submitted(case.ours, case.ours)
    try:
        if _is_determined(case, given) and _comparable(value):
            return _reproduces(submitted, value) and not _reproduces(ours, value)
        changed = Question(case.question.task, given, answers)
        return _is_right(changed, case.name, submitted) and not _is_right(changed, case.name, ours)
    except STRANGE:  # the two can't be compared
        return False


def _is_determined(case: Case, given: Given[Any, Any]) -> bool:
    return not case.question.task.answers[case.name].is_free(given)


def _comparable(value: Any) -> bool:
    """Whether a value is compared more quickly than it is judged by what defines it."""
    return isinstance(value, sp.MatrixBase) or is_scalar(value)
