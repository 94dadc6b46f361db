"""Why a value is wrong, in the student's terms: the mistake that leads to it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from solver.classroom.judging.question import Question
from solver.classroom.mistakes.naming import what_went_wrong
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict
from solver.derivation import PartResult
from solver.problem.model import Part


@dataclass(frozen=True)
class Wrong:
    """Where a value is wrong: the part, its question, all its values, our results of it and of earlier parts."""

    part: Part
    question: Question
    values: Mapping[str, Submitted]
    results: Sequence[PartResult]
    earlier: Mapping[str, PartResult]


def explained(verdict: AnswerVerdict, wrong: Wrong) -> AnswerVerdict:
    """Return the verdict of a wrong value with the mistake that leads to it, where it is a usual one."""
    submitted = wrong.values[verdict.name]
    slip = what_went_wrong(wrong.part, wrong.question, verdict.name, submitted, wrong.results, wrong.earlier)
    return verdict if slip is None else replace(verdict, reason=slip.words, mistake=slip.name)
