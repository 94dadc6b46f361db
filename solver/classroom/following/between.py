"""Questions about earlier parts, asked with the student's own answers to these in place of ours."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import combinations
from typing import Any

from solver.classroom.following.within import OwnAnswers
from solver.classroom.judging.question import STRANGE, Question
from solver.classroom.submitted import Submitted
from solver.derivation import Answers, PartResult, Status
from solver.engine import Earlier, found_by, given_of
from solver.problem.model import Part, Reference
from solver.systems import EarlierPart
from solver.systems.earlier_part import TRANSFER
from solver.tasks import catalogue
from solver.words import Told

MOST_CHOICES = 8
"""Choices of own values for ours that are tried for one part."""

Source = tuple[str, str]
"""A part and the name of an answer to it."""


@dataclass(frozen=True)
class OwnResult:
    """What a part comes to with the student's own values, and from which of these each answer comes (none: ours)."""

    result: PartResult
    own: Mapping[str, tuple[Source, ...]]


class OwnResults:
    """The parts of a problem with the student's own answers, as far as somebody asks for them; each solved once."""

    def __init__(
        self,
        parts: Iterable[Part],
        ours: Mapping[str, Sequence[PartResult]],
        submitted: Mapping[str, Mapping[str, Submitted]],
    ) -> None:
        self.parts = {part.id: part for part in parts}
        self.ours = ours
        self.submitted = submitted
        self.of = cache(self._of)
        self.asked: dict[tuple[Any, ...], Question | None] = {}

    def earlier(self) -> Earlier:
        """Our results of all parts."""
        return {id_: results[0] for id_, results in self.ours.items()}

    def questions(self, part: Part) -> Iterator[tuple[Question, tuple[Source, ...]]]:
        """Yield the questions that a part asks with own values in place of ours, and which; all own values first."""
        taken = [each for each in taken_by(part, self.earlier()) if self._own(each)]
        choices = (chosen for size in range(len(taken), 0, -1) for chosen in combinations(taken, size))
        for chosen, _ in zip(choices, range(MOST_CHOICES), strict=False):
            if (asked := self._asked(part, chosen)) is not None:
                yield asked, self._sources(chosen)

    def _own(self, group: tuple[Source, ...]) -> tuple[Source, ...]:
        """From which own values some answers come."""
        found = [source for part, name in group for source in self.of(part).own.get(name, ())]
        return tuple(dict.fromkeys(found))

    def _sources(self, chosen: Iterable[tuple[Source, ...]]) -> tuple[Source, ...]:
        return tuple(dict.fromkeys(source for group in chosen for source in self._own(group)))

    def _with(self, chosen: Iterable[tuple[Source, ...]]) -> dict[str, PartResult]:
        """Our results, with the student's values of the answers chosen."""
        earlier = dict(self.earlier())
        for part, name in (source for group in chosen for source in group):
            own = self.of(part).result.answers
            if name in own:
                result = earlier[part]
                earlier[part] = replace(result, answers=Answers(**{**result.answers, name: own[name]}))
        return earlier

    def _asked(self, part: Part, chosen: Sequence[tuple[Source, ...]]) -> Question | None:
        """The question that a part asks with own values; None where it has no answers."""
        earlier = self._with(chosen)
        sources = [source for group in chosen for source in group]
        named = [str(part.options.get(name)) for name in part.conventions]
        key = (part.id, *named, *((id_, name, str(earlier[id_].answers.get(name))) for id_, name in sources))
        if key not in self.asked:
            self.asked[key] = answered(part, earlier)
        return self.asked[key]

    def _of(self, id_: str) -> OwnResult:
        """A part with all own values: solved with those of earlier parts, then with its own answers in their places."""
        part, result = self.parts[id_], self.ours[id_][0]
        taken = [each for each in taken_by(part, self.earlier()) if self._own(each)]
        own: dict[str, tuple[Source, ...]] = {}
        question = self._asked(part, taken) if taken else None
        if question is not None:
            result = replace(result, answers=Answers(**question.ours))
            own = dict.fromkeys(result.answers, self._sources(taken))
        submitted = self.submitted.get(id_, {})
        if result.status is not Status.VERIFIED or not submitted:
            return OwnResult(result, own)
        if question is None:
            given = given_of(part, part.methods[0], self.earlier())
            question = Question(catalogue()[part.task], given, result.answers, part.digits)
        answers = OwnAnswers(question, submitted)
        found = dict(result.answers)
        for name in result.answers:
            first = answers.values(name)[0]
            if name in submitted and (first.own or submitted[name].value == result.answers[name]):
                own[name] = ((id_, name),) if name in own or first.own else ()
            elif first.own:
                own[name] = (*((id_, each) for each in first.own), *own.get(name, ()))
            found[name] = first.what.value
        return OwnResult(replace(result, answers=Answers(**found)), own)


def answered(part: Part, earlier: Earlier) -> Question | None:
    """The question of a part with the answers by all its methods; None where it has none."""
    try:
        found = [found_by(method, part, earlier) for method in part.methods]
    except (*STRANGE, Told):  # no solution, or own values of a form that the task was never meant for
        return None
    ours: dict[str, Any] = {}
    for _, answers in found:
        ours = {**answers, **ours}
    return Question(catalogue()[part.task], found[0][0], ours, part.digits)


def taken_by(part: Part, earlier: Earlier) -> list[tuple[Source, ...]]:
    """What a part takes from earlier ones: each group of answers comes from one solution of one part."""
    values = [*part.options.values(), getattr(part.system, "gain", None)]
    groups: list[tuple[Source, ...]] = [((each.part, each.answer),) for each in values if isinstance(each, Reference)]
    if isinstance(part.system, EarlierPart):
        found = earlier[part.system.part].answers
        names = "ABCD" if "A" in found else [name for name in TRANSFER if name in found][:1]
        groups.append(tuple((part.system.part, name) for name in names))
    return list(dict.fromkeys(groups))


__all__ = ["OwnResult", "OwnResults", "Source", "answered", "taken_by"]
