"""The work of `solve check exam.yaml --override`: an instructor's changes, fitted to the papers of a class."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import click

from solver.classroom.reading.change_file import Changes
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, source_of
from solver.problem.source import Fault, InputError

if TYPE_CHECKING:
    from solver.papers.exam.grades import Graded
    from solver.papers.exam.model import Exam


@dataclass
class Overriding:
    """The changes to papers of an exam, if there are any; `code` is 2 where some of them do not fit."""

    exam: Exam
    changes: Changes | None = None
    code: int = SOLVED

    def applied(self, graded: Graded) -> Graded:
        """Return a paper with its changes; what does not fit is told, and leaves the paper as it is."""
        from solver.papers.exam.overriding import names_of, with_changes

        if self.changes is None or graded.marking is None:
            return graded
        found = self.changes.of(*names_of(self.exam, graded.file, graded.student))
        if found is None:
            return graded
        try:
            return with_changes(graded, found)
        except Fault as fault:
            click.echo(InputError(self.changes.source, fault.diagnostics).render(), err=True)
            self.code = INPUT_AT_FAULT
            return graded


def overriding(file: str | None, exam: Exam, papers: Sequence[tuple[str, str]]) -> Overriding:
    """Return the changes of a file for papers, each the name of its file and its student.

    Raises InputError where the file is wrong, or names parts or answers that the exam has not; keys that name no paper
    are told.
    """
    from solver.papers.exam.overriding import fitted

    if file is None:
        return Overriding(exam)
    changes, strangers = fitted(source_of(file), exam, papers)
    if strangers:
        click.echo(InputError(changes.source, strangers).render(), err=True)
    return Overriding(exam, changes, INPUT_AT_FAULT if strangers else SOLVED)
