"""What the marks of a class say: how they are spread, how hard each question was, and which mistakes were made most.

Facility is the mean share of the marks. Separation is the correlation of the marks of a question with those of all
others (item-rest): near 1 who does well elsewhere does well here; near 0 or below it tells nobody apart.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from statistics import StatisticsError, correlation, fmean, median, pstdev

from solver.classroom import Marking
from solver.classroom.verdicts import AnswerVerdict, PartVerdict, Verdict
from solver.papers.exam.grades import Graded
from solver.papers.exam.marking import Solutions
from solver.papers.exam.model import Exam
from solver.render.plain import sympy_text

BARS = 10
FEWEST = 5
"""Of fewer papers a correlation says nothing."""


@dataclass(frozen=True, slots=True)
class Item:
    """A question or a part: mean marks, their share, how well it separates (None: unknown), how many had all, none."""

    name: str
    title: str
    out_of: float
    mean: float
    facility: float
    separation: float | None
    full: int
    none: int
    is_part: bool


@dataclass(frozen=True, slots=True)
class Common:
    """Something in an answer that several students share, in words (Markdown), with those students."""

    answer: str
    words: str
    students: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Statistics:
    """Of all papers: the marks, how many fall into each tenth of those there are, items, mistakes, equal answers."""

    out_of: float
    mean: float
    median: float
    deviation: float
    least: float
    most: float
    bars: tuple[tuple[float, float, int], ...]
    items: tuple[Item, ...]
    mistakes: tuple[Common, ...]
    equal: tuple[Common, ...]
    foreign: tuple[Common, ...]


def statistics_of(exam: Exam, graded: Sequence[Graded], solutions: Solutions) -> Statistics | None:
    """Return what the marks say, None where nothing could be marked."""
    there = [(each, each.marking) for each in graded if each.marking is not None]
    markings = [marking for _, marking in there]
    if not markings:
        return None
    totals, out_of = [float(each.marks) for each in markings], markings[0].out_of
    return Statistics(
        out_of=float(out_of),
        mean=fmean(totals),
        median=median(totals),
        deviation=pstdev(totals),
        least=min(totals),
        most=max(totals),
        bars=_bars([each.marks for each in markings], out_of),
        items=tuple(_items(exam, markings)),
        mistakes=_common((part, answer, answer.mistake, answer.reason, each) for each, part, answer in _wrong(there)
                         if answer.mistake),
        equal=_equal(there),
        foreign=_foreign(exam, there, solutions),
    )  # fmt: skip


def _bars(marks: Sequence[Fraction], out_of: Fraction) -> tuple[tuple[float, float, int], ...]:
    """Return from where to where, and how many; all marks belong to the last one."""
    width = (out_of or Fraction(1)) / BARS
    places = [min(BARS - 1, int(each / width)) for each in marks]
    return tuple((float(i * width), float((i + 1) * width), places.count(i)) for i in range(BARS))


def _items(exam: Exam, markings: Sequence[Marking]) -> Iterator[Item]:
    """Yield each question, and its parts where it has several."""
    for question in exam.questions:
        names = [f"{question.number}.{part.id}" for part in question.problem.parts]
        yield _item(str(question.number), question.title, names, markings, is_part=False)
        for name in names if len(names) > 1 else ():
            yield _item(name, "", [name], markings, is_part=True)


def _item(name: str, title: str, parts: Sequence[str], markings: Sequence[Marking], *, is_part: bool) -> Item:
    chosen = [[part for part in each.parts if part.id in parts] for each in markings]
    marks = [sum((part.marks for part in each), Fraction(0)) for each in chosen]
    out_of = sum((part.out_of for part in chosen[0]), Fraction(0))
    rest = [each.marks - own for each, own in zip(markings, marks, strict=True)]
    mean = fmean(map(float, marks))
    return Item(
        name=name,
        title=title,
        out_of=float(out_of),
        mean=mean,
        facility=mean / float(out_of) if out_of else 0.0,
        separation=_separation(marks, rest),
        full=sum(each == out_of for each in marks),
        none=sum(each == 0 for each in marks),
        is_part=is_part,
    )


def _separation(marks: Sequence[Fraction], rest: Sequence[Fraction]) -> float | None:
    """Return the correlation, None of few papers or where all are alike."""
    if len(marks) < FEWEST:
        return None
    try:
        return round(correlation([*map(float, marks)], [*map(float, rest)]), 2) + 0.0
    except StatisticsError:
        return None


Wrong = tuple[Graded, PartVerdict, AnswerVerdict]


def _wrong(there: Sequence[tuple[Graded, Marking]]) -> Iterator[Wrong]:
    """Yield the wrong answers."""
    for each, marking in there:
        for part in marking.parts:
            for answer in part.answers.values():
                if answer.verdict is Verdict.WRONG:
                    yield each, part, answer


def _common(found: Iterator[tuple[PartVerdict, AnswerVerdict, str, object, Graded]]) -> tuple[Common, ...]:
    """Return what is alike, by part, answer and a word for it: what most students share comes first."""
    groups: dict[tuple[str, str], tuple[str, list[str]]] = {}
    for part, answer, alike, words, each in found:
        name = f"{part.id}.{answer.name}"
        groups.setdefault((name, alike), (str(words), []))[1].append(each.student or each.file)
    ordered = sorted(groups.items(), key=lambda item: (-len(item[1][1]), item[0]))
    return tuple(Common(name, words, tuple(dict.fromkeys(students))) for (name, _), (words, students) in ordered)


def _equal(there: Sequence[tuple[Graded, Marking]]) -> tuple[Common, ...]:
    """Return wrong values that students of one variant share and no usual mistake explains."""
    found = (
        (part, answer, f"{each.variant}: {text}", answer.typed or text, each)
        for each, part, answer in _wrong(there)
        if not answer.mistake and (text := _text(answer.value))
    )
    return tuple(each for each in _common(found) if len(each.students) > 1)


def _foreign(exam: Exam, there: Sequence[tuple[Graded, Marking]], solutions: Solutions) -> tuple[Common, ...]:
    """Return wrong values that are those of another variant."""
    right: dict[tuple[str, str], dict[str, int]] = {}
    for variant, of_questions in solutions.items():
        for question, solution in zip(exam.questions, of_questions, strict=True):
            for part in reversed(solution.parts):
                for name, value in part.answers.items():
                    key = f"{question.number}.{part.id}", name
                    right.setdefault(key, {}).setdefault(_text(value), variant)
    found = (
        (part, answer, str(other), str(other), each)
        for each, part, answer in _wrong(there)
        if (text := _text(answer.value)) and (other := right.get((part.id, answer.name), {}).get(text)) is not None
    )
    return _common(found)


def _text(value: object) -> str:
    """Return a value as text, "" for words and verdicts, of which there are too few to tell anybody apart."""
    return "" if value is None or isinstance(value, bool | str) else sympy_text(value)
