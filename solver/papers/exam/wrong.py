"""Wrong answers that several students share: usual mistakes, equal values, values of another variant, pairs.

Equal wrong values are looked for among those who were asked the same, whatever their variants are called. A value that
a usual mistake leads to, or that follows from an earlier wrong one, tells nothing about who wrote it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

from solver.classroom import Marking
from solver.classroom.verdicts import AnswerVerdict, PartVerdict, Verdict
from solver.papers.exam.grades import Graded
from solver.papers.exam.marking import Solutions
from solver.papers.exam.model import Exam
from solver.render.plain import sympy_text

Marked = Sequence[tuple[Graded, Marking]]
"""The files that were marked, with their markings."""


@dataclass(frozen=True, slots=True)
class Common:
    """Something in an answer that several students share, in words (Markdown), with those students.

    `wrong` of those who were `asked` the same have it wrong in whatever way; both are 0 where that is not counted.
    """

    answer: str
    words: str
    students: tuple[str, ...]
    wrong: int = 0
    asked: int = 0


@dataclass(frozen=True, slots=True)
class Pair:
    """Two students who share several wrong values: the answers, out of so many that both have wrong."""

    students: tuple[str, str]
    answers: tuple[str, ...]
    both_wrong: int


@dataclass(frozen=True, slots=True)
class Wrong:
    """A wrong answer: whose, and to which question, as `group` tells it; `text` is the value, "" where it is words."""

    file: Graded
    part: PartVerdict
    answer: AnswerVerdict
    group: tuple[str, int]
    text: str

    @property
    def name(self) -> str:
        """The answer as the report names it: `2.a.K`."""
        return f"{self.part.id}.{self.answer.name}"

    @property
    def student(self) -> str:
        """Whose it is: the student, or the file where it names none."""
        return self.file.student or self.file.file

    @property
    def unexplained(self) -> bool:
        """Whether it has a value that neither a usual mistake nor an earlier wrong value leads to."""
        return bool(self.text) and not self.answer.mistake and not self.answer.follows


def wrong_of(exam: Exam, there: Marked, solutions: Solutions) -> list[Wrong]:
    """Return the wrong answers."""
    twins = _Twins(exam, solutions)
    return [
        Wrong(each, part, answer, (part.id, twins.of(part.id, each.variant)), _text(answer.value))
        for each, marking in there
        for part in marking.parts
        for answer in part.answers.values()
        if answer.verdict is Verdict.WRONG
    ]


class _Twins:
    """Tells the first variant that asks the same as a variant does, question by question."""

    def __init__(self, exam: Exam, solutions: Solutions) -> None:
        self.first: dict[tuple[int, int], int] = {}
        for place, question in enumerate(exam.questions):
            known: dict[int, int] = {}
            for variant in sorted(solutions):
                same = id(solutions[variant][place])  # what is the same is solved once
                self.first[question.number, variant] = known.setdefault(same, variant)

    def of(self, part: str, variant: int) -> int:
        """Return the first variant that asks the same in this part, the variant itself where that is not known."""
        return self.first.get((int(part.split(".", maxsplit=1)[0]), variant), variant)

    def asked(self, there: Marked) -> Counter[tuple[str, int]]:
        """Return how many were asked each part of each question."""
        asked = {(each.student or each.file, part.id, self.of(part.id, each.variant))
                 for each, marking in there for part in marking.parts}  # fmt: skip
        return Counter((part, variant) for _, part, variant in asked)


def mistakes_made(wrong: Iterable[Wrong]) -> tuple[Common, ...]:
    """Return the usual mistakes, those made most first."""
    return _common((each, each.answer.mistake, str(each.answer.reason)) for each in wrong if each.answer.mistake)


def equal_values(exam: Exam, there: Marked, solutions: Solutions) -> tuple[Common, ...]:
    """Return wrong values that several students share who were asked the same, and nothing explains."""
    twins, wrong = _Twins(exam, solutions), wrong_of(exam, there, solutions)
    asked, fell = (
        twins.asked(there),
        Counter((name, group) for _, name, group in {(each.student, each.name, each.group) for each in wrong}),
    )
    groups: dict[tuple[str, tuple[str, int], str], list[Wrong]] = {}
    for each in wrong:
        if each.unexplained:
            groups.setdefault((each.name, each.group, each.text), []).append(each)
    found = [
        Common(name, some[0].answer.typed or text, _names(some), fell[name, group], asked[group])
        for (name, group, text), some in groups.items()
        if len(_names(some)) > 1
    ]
    return tuple(sorted(found, key=lambda each: (-len(each.students), each.answer, each.words)))


def pairs_of(wrong: Sequence[Wrong]) -> tuple[Pair, ...]:
    """Return the pairs of students who share two unexplained wrong values or more, the most first.

    Both must have been asked the same there. A student of several files is one.
    """
    of: dict[str, dict[tuple[str, int, str], str]] = {}
    holders: dict[tuple[str, int, str, str], list[str]] = {}
    for each in wrong:
        key = (each.name, each.group[1], each.answer.name)
        of.setdefault(each.student, {})[key] = each.text
        if each.unexplained:
            holders.setdefault((*key, each.text), []).append(each.student)
    shared: dict[tuple[str, str], set[str]] = {}
    for (name, *_), students in holders.items():
        for pair in combinations(sorted(set(students)), 2):
            shared.setdefault(pair, set()).add(name)
    found = [
        Pair(pair, tuple(sorted(names)), len(of[pair[0]].keys() & of[pair[1]].keys()))
        for pair, names in shared.items()
        if len(names) > 1
    ]
    return tuple(sorted(found, key=lambda each: (-len(each.answers), each.both_wrong, each.students)))


def of_another_variant(exam: Exam, wrong: Iterable[Wrong], solutions: Solutions) -> tuple[Common, ...]:
    """Return wrong values that are those of another variant, and nothing explains."""
    right: dict[tuple[str, str], dict[str, int]] = {}
    for variant, of_questions in solutions.items():
        for question, solution in zip(exam.questions, of_questions, strict=True):
            for part in reversed(solution.parts):
                for name, value in part.answers.items():
                    key = f"{question.number}.{part.id}", name
                    right.setdefault(key, {}).setdefault(_text(value), variant)
    alone = [each for each in wrong if each.unexplained]
    found = ((each, right.get((each.part.id, each.answer.name), {}).get(each.text)) for each in alone)
    return _common((each, str(other), str(other)) for each, other in found if other is not None)


def _common(found: Iterable[tuple[Wrong, str, str]]) -> tuple[Common, ...]:
    """Return what is alike, by answer and a word for it: what most students share comes first."""
    groups: dict[tuple[str, str], tuple[str, list[Wrong]]] = {}
    for each, alike, words in found:
        groups.setdefault((each.name, alike), (words, []))[1].append(each)
    ordered = sorted(groups.items(), key=lambda item: (-len(item[1][1]), item[0]))
    return tuple(Common(name, words, _names(some)) for (name, _), (words, some) in ordered)


def _names(some: Iterable[Wrong]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(each.student for each in some))


def _text(value: object) -> str:
    """Return a value as text, "" for words and verdicts, of which there are too few to tell anybody apart."""
    return "" if value is None or isinstance(value, bool | str) else sympy_text(value)


__all__ = [
    "Common",
    "Pair",
    "Wrong",
    "equal_values",
    "mistakes_made",
    "of_another_variant",
    "pairs_of",
    "wrong_of",
]
