"""Why a value is wrong, in the student's terms: the mistake that leads to it, and what the value would mean."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from solver.classroom.judging.question import STRANGE, Question, checks_of
from solver.classroom.mistakes.equalities import broken
from solver.classroom.mistakes.naming import what_went_wrong
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict
from solver.derivation import Attempt, CheckStatus, PartResult, Unsolved
from solver.problem.model import Part
from solver.words import Reason


@dataclass(frozen=True)
class Wrong:
    """Where a value is wrong: the part, its question, all its values, our results of it and of earlier parts."""

    part: Part
    question: Question
    values: Mapping[str, Submitted]
    results: Sequence[PartResult]
    earlier: Mapping[str, PartResult]


def explained(verdict: AnswerVerdict, wrong: Wrong) -> AnswerVerdict:
    """Return the verdict of a wrong value with the mistake that leads to it and with what it would mean.

    What it means takes the place of the checks that fail; beside a mistake it is a note.
    """
    name = verdict.name
    slip = what_went_wrong(wrong.part, wrong.question, name, wrong.values[name], wrong.results, wrong.earlier)
    meant = _meaning(name, wrong) if _tells_checks_only(verdict) else None
    if slip is None:
        return replace(verdict, reason=meant or verdict.reason)
    return replace(verdict, reason=slip.words, mistake=slip.name, note=verdict.note or meant or "")


def _tells_checks_only(verdict: AnswerVerdict) -> bool:
    """Whether nothing is said of it but the checks that fail, such as that its shape is wrong."""
    reason = verdict.reason
    return not reason or (isinstance(reason, Reason) and reason.kind == "marking/failed_checks")


def _meaning(name: str, wrong: Wrong) -> Reason | None:
    """Return what a value would mean as its task tells it, else an equality that it breaks."""
    task, own = wrong.question.task, {each: submitted.value for each, submitted in wrong.values.items()}
    attempt = Attempt(wrong.question.given, name, wrong.question.ours, own)
    for meaning in task.meanings:
        if name in meaning.answers and (reason := _careful(meaning.of, attempt)) is not None:
            return replace(reason, values={**reason.values, "symbol": task.answers[name].symbol or name})
    alone = checks_of(wrong.question, {name: wrong.values[name]}) or []
    return broken((check for check in alone if name in check.judges and check.status is CheckStatus.FAILED), own[name])


def _careful(tell: Callable[[Attempt[Any, Any]], Reason | None], attempt: Attempt[Any, Any]) -> Reason | None:
    try:
        return tell(attempt)
    except (*STRANGE, Unsolved):  # the value is of a form, or the system of a kind, of which nothing can be told
        return None
