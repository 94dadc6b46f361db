"""An instructor's changes to the marks of an exam: parts are called `2.a`, as wherever the marks are shown."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from solver.classroom.changed import changed
from solver.classroom.reading.change_file import Changes, StudentChanges, read_changes
from solver.papers.exam.grades import Graded
from solver.papers.exam.marking import apart
from solver.papers.exam.model import Exam
from solver.papers.exam.whose import spelt_alike
from solver.problem.model import Part
from solver.problem.source import Diagnostic, InputError, Report, Source


def parts_of(exam: Exam) -> Mapping[str, Part]:
    """Return the parts of an exam by their names in it."""
    return {f"{each.number}.{part.id}": part for each in exam.questions for part in each.problem.parts}


def names_of(exam: Exam, file: str, student: str) -> list[str]:
    """Return what an instructor may call a paper: the file, its name with and without the ending, the student.

    The name of a student of the class is that of no other one's file.
    """
    path = Path(file)
    names = [name for name in (file, path.name, path.stem) if name not in exam.students or name == student]
    return [*names, *filter(None, [student])]


def fitted(source: Source, exam: Exam, papers: Sequence[tuple[str, str]]) -> tuple[Changes, list[Diagnostic]]:
    """Return the changes of a file for papers, each the name of its file and its student, and who is none of them.

    Raises InputError where the file is wrong, or names parts or answers that the exam has not.
    """
    names = [names_of(exam, *paper) for paper in papers]
    students = exam.students or tuple(dict.fromkeys(student for _, student in papers if student))
    changes = as_the_class_writes(read_changes(source), names, students)
    for each in names:
        if (found := changes.of(*each)) is not None:
            changes.refuse_unknown(found, parts_of(exam), "exam")
    return changes, list(changes.strangers(names))


def as_the_class_writes(changes: Changes, papers: Sequence[Sequence[str]], students: Sequence[str]) -> Changes:
    """Return the changes by the names of students as the class writes them, matched as those of answer files are.

    Names of files stay as they are. Raises InputError where a name may be that of several students, or stands twice.
    """
    files, found, report = {name for names in papers for name in names}, dict[str, StudentChanges](), Report()
    for name, each in changes.students.items():
        with report:
            alike = spelt_alike(name, students)
            if len(alike) > 1 and name not in files:
                note = "write the name as the class writes it"
                raise each.key.fault(f"'{name[:40]}' may be {' or '.join(alike)}", note=note)
            written = alike[0] if len(alike) == 1 and name not in files else name
            if written in found:
                raise each.key.fault(f"'{name[:40]}' is changed under another name too")
            found[written] = each
    if report.diagnostics:
        raise InputError(changes.source, report.diagnostics)
    return replace(changes, students=found)


def with_changes(graded: Graded, changes: StudentChanges) -> Graded:
    """Return a marked paper with the changes; raises Fault where an answer would earn more than it carries."""
    if graded.marking is None:
        raise ValueError("a file that cannot be read has no marks to change")
    whole = changed(graded.marking, changes)
    return replace(graded, marking=whole, of_questions=apart(whole, graded.of_questions))
