"""What the marks of a class say: how they are spread, how hard each question was, and which mistakes were made most.

Facility is the mean share of the marks. Separation is Pearson's correlation of the marks of a question with those of
the rest of the exam (the corrected item-total correlation; where all have all marks or none it is the corrected
point-biserial one): near 1 who does well elsewhere does well here; near 0 or below it tells nobody apart.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from statistics import StatisticsError, correlation, fmean, median, pstdev

from solver.classroom import Marking
from solver.papers.exam.grades import Graded, counted
from solver.papers.exam.marking import Solutions
from solver.papers.exam.model import Exam
from solver.papers.exam.wrong import Common, Pair, equal_values, mistakes_made, of_another_variant, pairs_of, wrong_of

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
    pairs: tuple[Pair, ...]
    foreign: tuple[Common, ...]


def statistics_of(exam: Exam, graded: Sequence[Graded], solutions: Solutions) -> Statistics | None:
    """Return what the marks say, None where none can be counted.

    Students of several files have their part in mistakes and equal answers, once, and none in the spread of marks.
    """
    there = [(each, each.marking) for each in graded if each.marking is not None]
    markings = [each.marking for each in counted(graded) if each.marking is not None]
    if not markings:
        return None
    wrong = wrong_of(exam, there, solutions)
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
        mistakes=mistakes_made(wrong),
        equal=equal_values(exam, there, solutions),
        pairs=pairs_of(wrong),
        foreign=of_another_variant(exam, wrong, solutions),
    )


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
