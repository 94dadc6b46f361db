"""An instructor's changes to the marks of an exam: parts are called `2.a`, as wherever the marks are shown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from solver.classroom.changed import changed
from solver.classroom.reading.change_file import StudentChanges
from solver.papers.exam.grades import Graded
from solver.papers.exam.model import Exam
from solver.problem.model import Part


def parts_of(exam: Exam) -> Mapping[str, Part]:
    """Return the parts of an exam by their names in it."""
    return {f"{each.number}.{part.id}": part for each in exam.questions for part in each.problem.parts}


def names_of(file: str, student: str) -> list[str]:
    """Return what an instructor may call a paper: the file, its name with and without the ending, the student."""
    path = Path(file)
    return [name for name in (file, path.name, path.stem, student) if name]


def with_changes(graded: Graded, changes: StudentChanges) -> Graded:
    """Return a marked paper with the changes; raises Fault where an answer would earn more than it carries."""
    if graded.marking is None:
        raise ValueError("a file that cannot be read has no marks to change")
    whole = changed(graded.marking, changes)
    parts, of_questions = iter(whole.parts), []
    for each in graded.of_questions:
        of_question = tuple(replace(next(parts), id=part.id) for part in each.parts)
        of_questions.append(replace(each, parts=of_question))
    return replace(graded, marking=whole, of_questions=tuple(of_questions))
