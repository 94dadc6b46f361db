"""The bank of an exam: its questions in all variants as items, each group of variants of one part together."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from hashlib import sha256
from unicodedata import normalize

from solver.papers.exam.drawing import Drawn, Means
from solver.papers.exam.model import Exam, Question, Variant
from solver.papers.export.items import FACTOR, BankMade, ItemsMade, bank_made
from solver.papers.export.quiz import Group, Quiz
from solver.words import Phrase

LONGEST = 40
"""Letters of the exam's title in an identifier."""

WHOLE = 80
"""Letters of an identifier, and some more where it is short of one of its own: Moodle keeps 100."""

DIGEST = 10
"""Letters at the end of one that is cut off; they stand for what is missing."""


@dataclass(frozen=True, slots=True)
class Bank:
    """The bank, why questions are missing in it, and which parts are, as they have no solution."""

    quiz: Quiz
    faults: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()


def for_bank(means: Means) -> Means:
    """Return the means by which questions are drawn for a bank: each is solved once, for its items, too."""
    return replace(means, partly=True, make=bank_made, factor=FACTOR)


def quiz_of(exam: Exam, variants: Sequence[Sequence[Drawn]], means: Means) -> Bank:
    """Return the bank of an exam whose questions were drawn `for_bank`; what is the same in all is in it once."""
    messages = means.presentation.messages(exam.questions[0].problem.display)
    namer = _Namer(exam, messages.say)
    groups: dict[tuple[int, int, bool], Group] = {}
    faults: list[str] = []
    left_out: dict[str, None] = {}
    for drawn, variant in _asked(exam, variants):
        made = drawn.made
        if not isinstance(made, BankMade):
            raise AssertionError("it was not drawn for a bank")
        if made.items.fault:
            faults.append(f"{namer.title(drawn.question)}: {made.items.fault}")
            continue
        left_out |= dict.fromkeys(f"{namer.title(drawn.question)}: {each}" for each in made.items.left_out)
        for key, group in namer.groups(drawn.question, variant, made.items):
            before = groups.get(key)
            groups[key] = replace(before, items=(*before.items, *group.items)) if before else group
    ordered = tuple(groups[key] for key in sorted(groups))
    return Bank(Quiz(exam.title, exam.course, messages.language, ordered), tuple(faults), tuple(left_out))


def _asked(exam: Exam, variants: Sequence[Sequence[Drawn]]) -> Iterator[tuple[Drawn, Variant | None]]:
    """Yield each question of each variant once; with no variant where it is the same in all."""
    for place, question in enumerate(exam.questions):
        if question.problem.family is None or len(variants) == 1:
            yield variants[0][place], None
        else:
            yield from ((drawn[place], variant) for drawn, variant in zip(variants, exam.variants, strict=True))


class _Namer:
    """Names items and groups: by the exam, the number of the question, the part, the seed and the variant."""

    def __init__(self, exam: Exam, say: Callable[[str], str]) -> None:
        self.exam = exam
        self.say = say
        self.taken: set[str] = set()

    def title(self, question: Question) -> str:
        """Return what a question is called."""
        numbered = self.say(Phrase("Question {number}", number=question.number))
        return f"{question.number}. {question.title}" if question.title else numbered

    def groups(
        self, question: Question, variant: Variant | None, made: ItemsMade
    ) -> Iterator[tuple[tuple[int, int, bool], Group]]:
        """Yield the items of a question, each in a group of its own and with its place among the groups."""
        title, ids = self.title(question), [part.id for part in question.problem.parts]
        for place, (letter, name, items) in enumerate(made.parts):
            for item in items:
                is_rest = item.essay is not None and len(items) > 1
                called = f"({letter}) {name}"
                called = f"{called}, {self.say('in words')}" if is_rest else called
                path = (
                    (self.exam.title, title, called)
                    if len(made.parts) > 1 or len(items) > 1
                    else (self.exam.title, title)
                )
                words = [f"{title}, {called}" if len(path) > 2 else title]
                words += [self.say(Phrase("Variant {number}", number=variant.label))] if variant else []
                named = replace(
                    item,
                    identifier=self._identifier(question, ids[place], "rest" if is_rest else "", variant),
                    name=", ".join(words),
                    variant=variant.label if variant else "",
                    tags=(*item.tags, *([words[1]] if variant else [])),
                )
                yield (question.number, place, is_rest), Group(path, (named,))

    def _identifier(self, question: Question, part: str, half: str, variant: Variant | None) -> str:
        """Return a name of small letters, digits and hyphens that no other item has."""
        drawn = [str(self.exam.seed), _slug(variant.label)] if variant else []
        words = [_slug(self.exam.title)[:LONGEST].strip("-"), str(question.number), _slug(part), half, *drawn]
        name = "-".join(filter(None, words))
        name = name if name[:1].isalpha() else f"exam-{name}"
        if len(name) > WHOLE:
            name = f"{name[: WHOLE - DIGEST - 1].rstrip('-')}-{sha256(name.encode()).hexdigest()[:DIGEST]}"
        chosen, number = name, 1
        while chosen in self.taken:
            number += 1
            chosen = f"{name}-again-{number}"
        self.taken.add(chosen)
        return chosen


def _slug(text: str) -> str:
    """Return the letters and digits of a text, small and without accents, with hyphens between them."""
    plain = normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    return re.sub(r"[^a-z0-9]+", "-", plain).strip("-")
