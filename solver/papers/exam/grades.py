"""The grades of a class as a table: a line for each file, and one for each student without a file."""

from __future__ import annotations

import csv
import io
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from solver.classroom import Marking
from solver.classroom.report.data import as_data
from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.table import harmless
from solver.classroom.report.words import number
from solver.papers.exam.model import Exam

NOT_READABLE = "not readable"


@dataclass(frozen=True, slots=True)
class Graded:
    """An answer file by its name, with its variant and marking, or `fault`: why it cannot be marked.

    `marking` is that of all questions together, `of_questions` are those of each. Of a file that is not marked `status`
    is the reason in two words, and `student` whose it may be.
    """

    file: str
    student: str = ""
    variant: int = 0
    marking: Marking | None = None
    fault: str = ""
    of_questions: tuple[Marking, ...] = ()
    status: str = NOT_READABLE

    @property
    def is_blank(self) -> bool:
        """Whether it was marked, and nothing is answered in it."""
        return self.marking is not None and not any(part.answers for part in self.marking.parts)


def missing(exam: Exam, graded: Sequence[Graded]) -> list[str]:
    """Return the students of the class of whom there is no file, not even one that is not marked."""
    there = {each.student for each in graded}
    return [student for student in exam.students if student not in there]


def several_of(graded: Sequence[Graded]) -> dict[str, list[str]]:
    """Return the students of whom several files were marked, with these: which one counts, a person decides."""
    files: dict[str, list[str]] = {}
    for each in graded:
        if each.marking is not None and each.student:
            files.setdefault(each.student, []).append(each.file)
    return {student: names for student, names in files.items() if len(names) > 1}


def data_of(graded: Sequence[Graded]) -> list[dict[str, Any]]:
    """Return the markings of a class as dictionaries, lists, texts and numbers, or why there is none."""
    several = several_of(graded)
    return [{**_data(each), "needs_review": needs_review(each, several)} for each in graded]


def _data(each: Graded) -> dict[str, Any]:
    if each.marking is None:
        return {"file": each.file, "student": each.student, "error": each.fault, "status": each.status}
    return {"file": each.file, "variant": each.variant, "student": each.student, **as_data(each.marking)}


def needs_review(each: Graded, several: Collection[str]) -> bool:
    """Whether a person should look at a file: also one without marks or answers, or one of several of a student."""
    return each.marking is None or each.marking.needs_review or each.student in several or each.is_blank


def counted(graded: Sequence[Graded]) -> list[Graded]:
    """Return the marked files that the spread of marks counts: those of students who handed in one."""
    several = several_of(graded)
    return [each for each in graded if each.marking is not None and each.student not in several]


def unmarked(graded: Sequence[Graded]) -> dict[str, list[str]]:
    """Return the files that were not marked, by the reason in two words."""
    found: dict[str, list[str]] = {}
    for each in graded:
        if each.marking is None:
            found.setdefault(each.status, []).append(each.file)
    return found


def grades_table(exam: Exam, graded: Sequence[Graded]) -> str:
    """Return the grades as CSV: the marks of each part `2.a` and question `2`, in hundredths that add up."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    names = [name for each in exam.questions for name in (*_parts(each.number, exam), str(each.number))]
    writer.writerow(["file", "student", "variant", *names, "total", "out of", "needs review"])
    several = several_of(graded)
    for each in graded:
        first = [harmless(each.file), harmless(each.student), each.variant or ""]
        if each.marking is None:
            writer.writerow([*first, *("" for _ in names), each.status, "", "yes"])
            continue
        told = in_hundredths(each.marking)
        review = "yes" if needs_review(each, several) else "no"
        writer.writerow([*first, *_cells(exam, told), number(told.marks), number(told.out_of), review])
    numbers = {student: place for place, student in enumerate(exam.students, 1)}
    for student in missing(exam, graded):
        writer.writerow(["", harmless(student), numbers[student], *("" for _ in names), "no file", "", "yes"])
    return content.getvalue()


def _parts(question: int, exam: Exam) -> list[str]:
    return [f"{question}.{part.id}" for part in exam.questions[question - 1].problem.parts]


def _cells(exam: Exam, marking: Marking) -> Iterator[object]:
    of_parts = {part.id: part.marks for part in marking.parts}
    for each in exam.questions:
        marks = [of_parts[name] for name in _parts(each.number, exam)]
        yield from map(number, marks)
        yield number(sum(marks, Fraction(0)))
