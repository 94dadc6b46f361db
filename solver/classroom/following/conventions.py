"""The conventions that a student follows, where the problem names none: each one for all values of a part."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace
from functools import lru_cache

from solver.classroom.following.between import OwnResults, answered
from solver.classroom.following.chain import Verdicts, followed
from solver.classroom.judging.question import Question
from solver.classroom.judging.verdict import judge
from solver.classroom.same import Same
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.engine import Earlier
from solver.problem.model import Part
from solver.words import Reason

KEPT = 200
"""Parts by another convention that are remembered, the same for every student of a class."""


@dataclass(frozen=True)
class Judged:
    """A part, its question by one convention, and the verdicts to it."""

    part: Part
    question: Question
    verdicts: Verdicts

    @property
    def right(self) -> int:
        """How many values are right."""
        return sum(verdict.verdict is Verdict.CORRECT for verdict in self.verdicts.values())


def by_convention(judged: Judged, values: Mapping[str, Submitted], own: OwnResults) -> Judged:
    """Return the part by the convention that makes the most values right; where it is not ours, those it needs say so.

    Of equal numbers ours stays. A part that names its conventions has no other ones. Options are independent: with the
    band of 5 % the overshoot may be in per cent too.
    """
    options, taken = {name for name, _ in other_conventions(judged.part)}, ""
    while options:
        judged, taken = _by_one_more(judged, values, own, options)
        if not taken:
            break
        options.remove(taken)
    return judged


def _by_one_more(
    judged: Judged, values: Mapping[str, Submitted], own: OwnResults, options: AbstractSet[str]
) -> tuple[Judged, str]:
    """Return the part by the best convention of one of some options, and this option; "" where none is better."""
    best, taken = judged, ""
    for name, typed in other_conventions(judged.part):
        if best.right == len(values):
            break
        if name not in options:
            continue
        part, question = asked_by(judged.part, name, typed, own.earlier())
        if question is None:
            continue
        verdicts = followed(part, question, values, judge(question, values), own)
        found = Judged(part, question, verdicts)
        if found.right > best.right:
            noted = _noted(judged.verdicts, verdicts, {"option": name, "value": typed})
            best, taken = replace(found, verdicts=noted), name
    return best, taken


def other_conventions(part: Part) -> Iterator[tuple[str, str]]:
    """Yield each option that is a convention and not given, with each other usual value as it is typed."""
    for name, values in part.conventions.items():
        yield from ((name, typed) for typed in values)


def asked_by(part: Part, name: str, typed: str, earlier: Earlier) -> tuple[Part, Question | None]:
    """The part by another convention, and its question; None where it has no meaning there."""
    return _found(part, name, typed, earlier) if part.sources else _remembered(Same(part), name, typed)


@lru_cache(maxsize=KEPT)
def _remembered(same: Same[Part], name: str, typed: str) -> tuple[Part, Question | None]:
    return _found(same.it, name, typed, {})


def _found(part: Part, name: str, typed: str, earlier: Earlier) -> tuple[Part, Question | None]:
    other = replace(part, options={**part.options, name: part.conventions[name][typed]})
    return other, answered(other, earlier)


def _noted(ours: Verdicts, theirs: Verdicts, convention: Mapping[str, str]) -> Verdicts:
    """The verdicts by another convention; a value that is right by this one only says so, one right before stays."""

    def noted(name: str, verdict: AnswerVerdict) -> AnswerVerdict:
        if verdict.verdict is not Verdict.CORRECT:
            return verdict
        if ours[name].verdict is Verdict.CORRECT:
            return ours[name]
        return replace(verdict, note=Reason("marking/follows_convention", {**convention, "besides": verdict.note}))

    return {name: noted(name, verdict) for name, verdict in theirs.items()}
