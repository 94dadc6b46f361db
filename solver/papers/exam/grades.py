"""The grades of a class as a table: a line for each file, and one for each student without a file."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from solver.classroom import Marking
from solver.classroom.report.hundredths import marks_that_add_up
from solver.classroom.report.table import harmless
from solver.classroom.report.words import number
from solver.papers.exam.model import Exam


@dataclass(frozen=True, slots=True)
class Graded:
    """An answer file by its name, with its variant and marking, or `fault`: why it cannot be read.

    `marking` is that of all questions together, `of_questions` are those of each.
    """

    file: str
    student: str = ""
    variant: int = 0
    marking: Marking | None = None
    fault: str = ""
    of_questions: tuple[Marking, ...] = ()


def missing(exam: Exam, graded: Sequence[Graded]) -> list[str]:
    """Return the students of the class of whom there is no file that can be read."""
    there = {each.student for each in graded if each.marking is not None}
    return [student for student in exam.students if student not in there]


def grades_table(exam: Exam, graded: Sequence[Graded]) -> str:
    """Return the grades as CSV: the marks of each part `2.a` and question `2`, in hundredths that add up."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    names = [name for each in exam.questions for name in (*_parts(each.number, exam), str(each.number))]
    writer.writerow(["file", "student", "variant", *names, "total", "out of", "needs review"])
    for each in graded:
        first = [harmless(each.file), harmless(each.student), each.variant or ""]
        if each.marking is None:
            writer.writerow([*first, *("" for _ in names), "not readable", "", "yes"])
            continue
        total, of_parts, _ = marks_that_add_up(each.marking)
        review = "yes" if each.marking.needs_review else "no"
        writer.writerow([*first, *_cells(exam, of_parts), number(total), number(each.marking.out_of), review])
    numbers = {student: place for place, student in enumerate(exam.students, 1)}
    for student in missing(exam, graded):
        writer.writerow(["", harmless(student), numbers[student], *("" for _ in names), "no file", "", "yes"])
    return content.getvalue()


def _parts(question: int, exam: Exam) -> list[str]:
    return [f"{question}.{part.id}" for part in exam.questions[question - 1].problem.parts]


def _cells(exam: Exam, of_parts: Mapping[str, Fraction]) -> Iterator[object]:
    for each in exam.questions:
        marks = [of_parts[name] for name in _parts(each.number, exam)]
        yield from map(number, marks)
        yield number(sum(marks, Fraction(0)))
