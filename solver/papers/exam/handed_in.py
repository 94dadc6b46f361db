"""Answer files of a class as they lie in a folder: what each of them says, or why it cannot be marked."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass

from solver.classroom import Marking
from solver.classroom.reading.answer_file import root_of_answers
from solver.papers.exam.grades import NOT_READABLE, Graded
from solver.papers.exam.marking import together
from solver.papers.exam.model import Exam
from solver.papers.exam.submitted import ExamSubmission, NotPlacedError, read_exam_submission
from solver.papers.exam.whose import may_be_of
from solver.problem.nodes import MappingNode
from solver.problem.source import InputError, Source

MOST_OF_A_FILE = 3
"""So many errors of a file are told: who marks a class reads those of many."""


@dataclass(frozen=True)
class HandedIn:
    """An answer file and what it says, or why it cannot be read."""

    name: str
    submission: ExamSubmission | None = None
    fault: str = ""
    student: str = ""
    status: str = ""

    def graded(self, markings: Iterator[tuple[Marking, ...]]) -> Graded:
        """Return it with its marking, the next one where it could be read."""
        if self.submission is None:
            return Graded(self.name, self.student, fault=self.fault, status=self.status)
        student, of_questions = self.submission.student, next(markings)
        whole = together(student, of_questions)
        return Graded(self.name, student, self.submission.variant, whole, of_questions=of_questions)


def handed_in(name: str, read: Callable[[], Source], exam: Exam) -> HandedIn:
    """Return what an answer file says to an exam; what is wrong with it is kept in words."""
    try:
        return HandedIn(name, read_exam_submission(read(), exam))
    except InputError as error:
        root: MappingNode | None = None
        with suppress(InputError):
            root = root_of_answers(error.source)
        status = error.status if isinstance(error, NotPlacedError) else NOT_READABLE
        return HandedIn(name, fault=error.first(MOST_OF_A_FILE), student=may_be_of(name, root, exam), status=status)
