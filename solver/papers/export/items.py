"""A question of the exam, solved and verified, as items for a learning system.

There is one for each part, two where some of its answers have fields and others do not.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import PurePath

from solver.derivation import Status
from solver.document.model import Document, WorkAnswer
from solver.document.works import document_of, solve_as_told
from solver.engine import Solution
from solver.papers.exam.question import Asked as Wanted
from solver.papers.exam.question import QuestionMade
from solver.papers.exam.scaling import scaled
from solver.papers.export.bench import Bench
from solver.papers.export.fields import NoField, asked_of_answer
from solver.papers.export.quiz import Asked, Essay, Item, Number, Text
from solver.papers.export.told import NUMBERS, key_of, question_of, solution_of
from solver.papers.judging import Judged
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.render.prose import inline_as_text, plain
from solver.tasks import catalogue
from solver.words import Phrase

ONLY = "Here only this is asked: {names}."
BELONGS = "Say of each vector to which eigenvalue it belongs."
LETTERED = re.compile(r" \([^()]*\)$")
"""The last bracket of what an answer is."""


@dataclass(frozen=True, slots=True)
class Told:
    """A question in words: as on a paper, as it is worked, as a key has it."""

    paper: Document
    worked: Document
    key: Document


@dataclass(frozen=True, slots=True)
class ItemsMade:
    """The items of each part of a question, with the part's letter and title; why there are none, if it failed.

    A part that has no solution has no items; `left_out` says of each why.
    """

    parts: tuple[tuple[str, str, tuple[Item, ...]], ...] = ()
    fault: str = ""
    left_out: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class BankMade(QuestionMade):
    """A question as it is asked in a bank; it stands on no paper."""

    items: ItemsMade = field(default_factory=ItemsMade)


FACTOR = 3
"""A question is solved, told and marked many times over: it may take so many times as long as one for a paper."""


def bank_made(draw: Judged, source: str, asked: Wanted) -> BankMade:
    """Solve and verify a question as `question_made` does, and make its items of the same solution."""
    solution, worked = _solved(draw, source, asked)
    judged = worked if worked.presentation.detail in {"full", "tutor"} else worked.told(detail="full")
    part = next((part for part in judged.parts if part.status is not Status.VERIFIED), None)
    reason = f"part {part.letter}: {inline_as_text(part.reason)}" if part else ""
    return BankMade(judged.status, reason, {}, items=_items_of(solution, worked))


def items_made(text: str, source: str, asked: Wanted) -> ItemsMade:
    """Solve, verify and tell a question, in this process. Identifiers and names are still those of its parts."""
    return _items_of(*_solved(Judged(read_problem(Source(source, text), catalogue())), source, asked))


def _solved(draw: Judged, source: str, asked: Wanted) -> tuple[Solution, Document]:
    """Return a question solved, and as it is told."""
    told = asked.presentation
    solution = solve_as_told(told.of(scaled(draw.problem, asked.marks)), told, draw.found)
    return solution, document_of(solution, told, PurePath(source).name)


def _items_of(solution: Solution, worked: Document) -> ItemsMade:
    """Return the items of a question as it is worked."""
    problem = solution.problem
    unsolved = {work.id: work for work in reversed(worked.parts) if work.status is not Status.VERIFIED}
    if worked.status is Status.FAILED:
        part = next(part for part in worked.parts if part.status is worked.status)
        return ItemsMade(fault=f"part {part.letter}: {inline_as_text(part.reason)}")
    paper, key = (worked.told(detail=detail, checks="") for detail in ("question", "key"))
    bench, words = Bench(solution), Told(paper, worked, key)
    letters = {work.id: (work.letter, work.title) for work in paper.parts if not work.case}
    items = {part.id: tuple(_Parted(bench, part, words).items()) for part in problem.parts if part.id not in unsolved}
    return ItemsMade(
        tuple((*letters[part.id], items.get(part.id, ())) for part in problem.parts),
        left_out=tuple(f"part {each.letter}: {inline_as_text(each.reason)}" for each in reversed(unsolved.values())),
    )


@dataclass(frozen=True)
class _Parted:
    """A part of a question: what it asks, told and marked."""

    bench: Bench
    part: Part
    told: Told

    def items(self) -> Iterator[Item]:
        """Yield the item with the answers that have fields, and the one with the others."""
        marks, part = self.bench.told_marks[self.part.id], self.part
        works = [work for work in self.told.worked.parts if work.id == part.id and not work.case]
        shown = {answer.name: answer for work in reversed(works) for answer in work.answers}
        names = [name for name in marks if name in shown]
        fields, reasons = dict[str, Asked](), dict[str, str]()
        partly = not set(self.bench.blank.ours(part.id)) <= set(marks)
        for name in names:
            try:
                answer = self._in_numbers(shown[name])
                fields[name] = asked_of_answer(self.bench, (part, name), _symbol(answer), self._meaning(answer))
                shown[name] = answer
            except NoField as why:
                reasons[name] = self.bench.blank.messages.say(why.args[0])
        if fields:
            item = self._item({name: marks[name] for name in fields}, shown, only=partly or bool(reasons))
            item = replace(item, answers=tuple(fields.values()))
            if any(isinstance(each, Number) for each in item.fields):
                told = Text(self.bench.blank.messages.say(Phrase(NUMBERS, digits=part.digits)))
                item = replace(item, question=replace(item.question, blocks=(*item.question.blocks, told)))
            yield item
        if reasons:
            more = [BELONGS] if fields and any(self.bench.declared((part, name)).vectors for name in reasons) else []
            item = self._item({name: marks[name] for name in reasons}, shown, only=partly or bool(fields), more=more)
            asked = tuple((_symbol(shown[name]), self._meaning(shown[name])) for name in reasons)
            yield replace(item, essay=Essay(asked, key_of(self.told.key, part.id, reasons), reasons))

    def _in_numbers(self, answer: WorkAnswer) -> WorkAnswer:
        """Return an answer that has fields without what its meaning says of letters: it has none."""
        about_letters = self.bench.declared((self.part, answer.name)).doc.endswith("stay letters)")
        return replace(answer, doc=LETTERED.sub("", answer.doc)) if about_letters else answer

    def _meaning(self, answer: WorkAnswer) -> str:
        """Return what an answer is; one without a symbol is named: "controllable: whether the rank is n"."""
        named = plain(self.bench.blank.messages.named(answer.name))
        return answer.doc if answer.symbol or named in answer.doc.lower() else f"{named}: {answer.doc}"

    def _named(self, answer: WorkAnswer) -> str:
        """Return what an answer is, with its symbol (Markdown)."""
        return f"${answer.symbol}$ ({answer.doc})" if answer.symbol else self._meaning(answer)

    def _item(
        self, marks: Mapping[str, Fraction], shown: Mapping[str, WorkAnswer], *, only: bool, more: Sequence[str] = ()
    ) -> Item:
        """Return an item that asks for the answers that carry these marks, still without fields."""
        say = self.told.paper.messages.say
        last = [say(Phrase(ONLY, names=", ".join(map(self._named, (shown[name] for name in marks)))))] if only else []
        last += map(say, more)
        return Item(
            identifier="",
            name="",
            question=question_of(self.told.paper, self.bench.problem, self.part, last),
            feedback=solution_of(self.told.worked, self.part.id),
            marks=sum(marks.values(), Fraction(0)),
            tags=(say(catalogue()[self.part.task].title),),
        )


def _symbol(answer: WorkAnswer) -> str:
    r"""Return the LaTeX of an answer's symbol; of one without a symbol its name, \text{rank}."""
    words = answer.name.replace("_", " ")
    return answer.symbol or rf"\text{{{words}}}"
