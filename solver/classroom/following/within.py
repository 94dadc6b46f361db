"""What follows from the student's own answers to the same question, by the formulas that its task declares."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import islice, product
from typing import Any

from solver.classroom.following.trivial import trivial
from solver.classroom.judging.entries import entrywise
from solver.classroom.judging.question import STRANGE, Question
from solver.classroom.submitted import Submitted
from solver.decimals import exactly
from solver.derivation.consequences import Consequence
from solver.words import Told

MOST_VALUES = 4
"""Values that an answer may have: the student's, those that follow from other ones, ours."""

MOST_LETTERS = 16
"""Decimals that letters stand for in a formula; of more the values as they stand are taken."""

MOST_TRIED = 24
"""Choices of values from which one answer may follow."""


@dataclass(frozen=True)
class Value:
    """A value that an answer may have, and the own answers that it comes from (none: it is ours)."""

    what: Submitted
    own: tuple[str, ...] = ()


class OwnAnswers:
    """The answers to a question: as submitted, as they follow from what was submitted, and ours."""

    def __init__(self, question: Question, submitted: Mapping[str, Submitted]) -> None:
        self.question = question
        self.submitted = submitted
        self.known: dict[str, list[Value]] = {}

    @cached_property
    def ours(self) -> Mapping[str, Any]:
        """Our answers, decimals as exact numbers."""
        return {name: exactly(value) for name, value in self.question.ours.items()}

    def values(self, name: str) -> list[Value]:
        """The values of an answer from which others may follow; the student's own first, ours last."""
        if name not in self.known:
            found = [] if (own := self._submitted(name)) is None else [Value(own, (name,))]
            found += islice(self.following(name), MOST_VALUES - 2)
            self.known[name] = [*found, *([Value(_plain(self.ours[name]))] if name in self.ours else [])]
        return self.known[name]

    def replacements(self, name: str) -> Iterator[Submitted]:
        """Yield what would be right in place of an answer: what completes the others, what follows from them, ours."""
        for formula in self.question.task.consequences:
            if formula.name == name and formula.completing:
                yield from (value.what for value in self._by(formula))
        yield from (value.what for value in self.values(name))

    def following(self, name: str) -> Iterator[Value]:
        """Yield the values of an answer that follow from own values of others."""
        for formula in self.question.task.consequences:
            if formula.name == name and not formula.completing:
                yield from self._by(formula)

    def _by(self, formula: Consequence) -> Iterator[Value]:
        choices = product(*(self._sources(name, formula) for name in formula.of))
        for chosen in islice(choices, MOST_TRIED):
            own = tuple(dict.fromkeys(name for value in chosen for name in value.own))
            if own and (found := self._found(formula, [value.what for value in chosen])) is not None:
                yield Value(found, own)

    def _sources(self, name: str, formula: Consequence) -> list[Value]:
        """The values from which a formula may take an answer.

        What is completed stands in coordinates of its own: more zeros than ours there make nothing trivial.
        """
        values = self.values(name)
        if formula.completing and (own := self._clear(name)) is not None and (name,) not in (v.own for v in values):
            return [Value(own, (name,)), *values]
        return values

    def _submitted(self, name: str) -> Submitted | None:
        """The value submitted, where it is clear, another than ours and not trivial."""
        own = self._clear(name)
        return None if own is None or trivial(own.value, self.ours.get(name)) else own

    def _clear(self, name: str) -> Submitted | None:
        """The value submitted, where it is clear and another than ours; coarse decimals as they stand."""
        each = self.submitted.get(name)
        if each is None or each.others or each.value == self.ours.get(name):
            return None
        return each.with_digits(self.question.digits)

    def _found(self, formula: Consequence, sources: list[Submitted]) -> Submitted | None:
        """What the formula makes of its sources; with their decimals kept where letters can stand for them."""
        decimals = {symbol: each for source in sources for symbol, each in source.decimals.items()}
        try:
            value = self._carried_out(formula, [source.value for source in sources])
            if value is None or not formula.symbolic or not 0 < len(decimals) <= MOST_LETTERS:
                return None if value is None else _plain(value)
            form = self._carried_out(formula, [source.form for source in sources])
            return Submitted(value, form, decimals) if form is not None else _plain(value)
        except (*STRANGE, Told):  # the formula has no meaning for these values
            return None

    def _carried_out(self, formula: Consequence, sources: list[Any]) -> Any:
        found = {**self.ours, **dict(zip(formula.of, sources, strict=True))}
        return formula.formula(self.question.given, found)

    def compared(self, name: str) -> Iterator[tuple[Submitted, Any, tuple[str, ...]]]:
        """Yield a reading of a submitted value, its entries beside what follows, and from which own answers it does."""
        each = self.submitted[name]
        ordered = self.question.task.answers[name].ordered
        for value in self.following(name):
            for reading in (each, *each.others):
                firm = reading.with_digits(self.question.digits)
                both = replace(firm, decimals={**firm.decimals, **value.what.decimals})
                if (entries := entrywise(both, value.what.form, ordered=ordered)) is not None:
                    yield reading, entries, value.own


def _plain(value: Any) -> Submitted:
    """A value that was not written with decimals."""
    return Submitted(value, value)
