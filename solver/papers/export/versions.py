"""The questions of an exam with the versions a student may get: all parts of a version have the same numbers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from solver.papers.export.quiz import Asked, Field, Group, Item, Quiz
from solver.problem.hundredths import told_in_hundredths


@dataclass(frozen=True, slots=True)
class Version:
    """A question with the numbers of one variant, "" where all have the same: an item or more, in order."""

    variant: str
    items: tuple[Item, ...]

    @property
    def marks(self) -> Fraction:
        """What its items carry together."""
        return sum((item.marks for item in self.items), Fraction(0))


@dataclass(frozen=True, slots=True)
class Question:
    """A question by its number from 1 and its title (plain)."""

    number: int
    title: str
    versions: tuple[Version, ...]

    def of(self, variant: str) -> Version:
        """Return the version of a variant."""
        return next(each for each in self.versions if each.variant in {variant, ""})


def questions_of(quiz: Quiz) -> list[Question]:
    """Return the questions: groups whose paths differ in the part only belong together."""
    found: dict[tuple[str, ...], list[Group]] = {}
    for group in quiz.groups:
        found.setdefault(group.path[:2], []).append(group)
    return [Question(number, path[-1], _versions(groups)) for number, (path, groups) in enumerate(found.items(), 1)]


def variants_of(questions: Sequence[Question]) -> list[str]:
    """Return the variants in order; there is one, "", where all students get the same."""
    labels = dict.fromkeys(version.variant for question in questions for version in question.versions)
    return [label for label in labels if label] or [""]


def _versions(groups: Sequence[Group]) -> tuple[Version, ...]:
    items = [item for group in groups for item in group.items]
    labels = [label for label in dict.fromkeys(item.variant for item in items) if label] or [""]
    return tuple(Version(label, tuple(each for each in items if each.variant in {label, ""})) for label in labels)


def marks_of_fields(asked: Asked) -> dict[Field, Fraction]:
    """Return what each field of an answer carries: equal shares, in hundredths that add up where the whole is some."""
    fields = list(asked.fields)
    shares = [asked.marks / len(fields) for _ in fields]
    return dict(zip(fields, told_in_hundredths(shares), strict=True))


def decimal(marks: Fraction) -> str:
    """Return marks as a decimal number, exact where that is possible within twelve digits."""
    return f"{float(marks):.12g}"
