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
from solver.engine import Earlier, given_of, solve_part
from solver.problem.model import Part, Reference
from solver.systems import EarlierPart
from solver.systems.earlier_part import TRANSFER
from solver.tasks import catalogue

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
        self.solved: dict[tuple[Any, ...], list[PartResult] | None] = {}

    def earlier(self) -> Earlier:
        """Our results of all parts."""
        return {id_: results[0] for id_, results in self.ours.items()}

    def questions(self, part: Part) -> Iterator[tuple[Question, tuple[Source, ...]]]:
        """Yield the questions that a part asks with own values in place of ours, and which; all own values first."""
        taken = [each for each in taken_by(part, self.earlier()) if self._own(each)]
        choices = (chosen for size in range(len(taken), 0, -1) for chosen in combinations(taken, size))
        for chosen, _ in zip(choices, range(MOST_CHOICES), strict=False):
            earlier = self._with(chosen)
            solved = self._solved(part, chosen)
            if solved is not None:
                ours: dict[str, Any] = {}
                for result in solved:
                    ours = {**result.answers, **ours}
                given = given_of(part, part.methods[0], earlier)
                yield Question(catalogue()[part.task], given, ours, part.digits), self._sources(chosen)

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

    def _solved(self, part: Part, chosen: Sequence[tuple[Source, ...]]) -> list[PartResult] | None:
        """The part solved with own values; None where that has no verified solution."""
        earlier = self._with(chosen)
        sources = [source for group in chosen for source in group]
        key = (part.id, *((id_, name, str(earlier[id_].answers.get(name))) for id_, name in sources))
        if key not in self.solved:
            self.solved[key] = _verified(part, earlier)
        return self.solved[key]

    def _of(self, id_: str) -> OwnResult:
        """A part with all own values: solved with those of earlier parts, then with its own answers in their places."""
        part, result = self.parts[id_], self.ours[id_][0]
        taken = [each for each in taken_by(part, self.earlier()) if self._own(each)]
        own: dict[str, tuple[Source, ...]] = {}
        if taken and (solved := self._solved(part, taken)) is not None:
            result = solved[0]
            own = dict.fromkeys(result.answers, self._sources(taken))
        submitted = self.submitted.get(id_, {})
        if result.status is not Status.VERIFIED or not submitted:
            return OwnResult(result, own)
        earlier = self._with(taken) if own else self.earlier()
        question = Question(
            catalogue()[part.task], given_of(part, part.methods[0], earlier), result.answers, part.digits
        )
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


def _verified(part: Part, earlier: Earlier) -> list[PartResult] | None:
    """The part solved, by all its methods; None where that fails."""
    try:
        found = solve_part(part, earlier)
    except STRANGE:  # the own values are of a form that the task was never meant for
        return None
    return found if all(result.status is Status.VERIFIED for result in found) else None


def taken_by(part: Part, earlier: Earlier) -> list[tuple[Source, ...]]:
    """What a part takes from earlier ones: each group of answers comes from one solution of one part."""
    values = [*part.options.values(), getattr(part.system, "gain", None)]
    groups: list[tuple[Source, ...]] = [((each.part, each.answer),) for each in values if isinstance(each, Reference)]
    if isinstance(part.system, EarlierPart):
        found = earlier[part.system.part].answers
        names = "ABCD" if "A" in found else [name for name in TRANSFER if name in found][:1]
        groups.append(tuple((part.system.part, name) for name in names))
    return list(dict.fromkeys(groups))


__all__ = ["OwnResult", "OwnResults", "Source", "taken_by"]
