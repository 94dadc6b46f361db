"""A class marked in Python: `solver.check_exam("exam.yaml", "answers/")`.

>>> import solver
>>> marked = solver.check_exam("exam.yaml", "answers/", jobs=2)
>>> Path("grades.csv").write_text(marked.grades(), encoding="utf-8")
>>> [(each.student, each.marking.marks) for each in marked.papers if each.marking]
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from solver.api import source_of
from solver.classroom.reading.files import answer_files, load_submitted
from solver.document.model import Presentation, in_a_frame
from solver.executors import Processes
from solver.limits import Limits
from solver.messages import Messages
from solver.papers.exam.drawing import Means
from solver.papers.exam.grades import Graded, data_of, grades_table, missing
from solver.papers.exam.handed_in import HandedIn, handed_in
from solver.papers.exam.marking import Solutions, Worked, marked, prepared, solutions_of, worked_of
from solver.papers.exam.model import Exam
from solver.papers.exam.overriding import fitted, names_of, with_changes
from solver.papers.exam.reading import read_exam
from solver.papers.exam.report import report_page
from solver.papers.exam.sheet import exam_sheet
from solver.papers.interface.exams import Given
from solver.problem.data import source_of_data
from solver.problem.source import Diagnostic, Fault, InputError, Source
from solver.progress import Tell, Watch, shown

Answers = str | Path | Sequence[str | Path] | Mapping[str, Mapping[Any, Any]]
"""A folder of answer files, files, or by student what is answered: `{"Ada": {1: {"a": {"K": [1, 2]}}}}`."""


@dataclass(frozen=True)
class MarkedExam:
    """The papers of a class, each marked against its own variant. In a notebook it shows itself as the report."""

    exam: Exam
    papers: tuple[Graded, ...]
    """One for each file: its student, variant and marking, or `fault`: why it could not be marked."""

    solutions: Solutions = field(repr=False)
    messages: Messages = field(repr=False)
    templates: Path | None = None
    worked: Worked = field(default_factory=dict, repr=False)

    @property
    def missing(self) -> list[str]:
        """The students of the class of whom there is no file."""
        return missing(self.exam, self.papers)

    def grades(self) -> str:
        """Return the grades as CSV: what `--csv` writes."""
        return grades_table(self.exam, self.papers)

    def report(self) -> str:
        """Return the page of what the marks say: what `--report` writes."""
        return report_page(self.exam, self.papers, self.solutions, self.templates, self.messages)

    def sheet(self, file: str | Path, *, answers: bool = False) -> str:
        """Return the page to hand back for a file, or a student: with the right `answers`, if that is wanted.

        Below is the worked solution where the class was marked with `solution=True`. Raises KeyError where there is no
        such file, ValueError where it could not be marked.
        """
        graded = next((each for each in self.papers if str(file) in {each.file, each.student}), None)
        if graded is None:
            raise KeyError(f"no file and no student {str(file)!r}")
        return exam_sheet(
            self.exam, graded, self.solutions.get(graded.variant, ()), self.templates, key=answers, worked=self.worked
        )

    def data(self) -> list[dict[str, Any]]:
        """Return the markings as dictionaries, lists, texts and numbers: what `solve check -f json` prints."""
        return data_of(self.papers)

    def _repr_html_(self) -> str:
        """The report in a frame of its own."""
        return in_a_frame(self.report(), self.exam.title)

    def __repr__(self) -> str:
        count = sum(each.marking is not None for each in self.papers)
        return f"<exam {self.exam.title!r}: {count} of {len(self.papers)} files marked>"


def check_exam(  # noqa: PLR0913 - all but the first two have names
    exam: Given,
    answers: Answers,
    *,
    partial_credit: str | None = None,
    override: Given | None = None,
    solution: bool = False,
    detail: str = "full",
    jobs: int = 1,
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    progress: Watch = None,
    **limits: Any,
) -> MarkedExam:
    """Mark the answers of a class to an exam, each against its own variant, as `solve check exam.yaml answers/` does.

    `partial_credit` is "entries", "none" or "named", whatever the problems say; `override` are an instructor's changes,
    a file as for `--override`; with `solution` sheets have the worked solution, in so much `detail`. A file that cannot
    be read, or of which it is not sure whose it is, is not marked and says why. Raises
    `solver.problem.source.InputError` where the exam, a file that it names, or a change is at fault, and where there is
    nothing to mark: no such file or folder, or no answer file in it.
    """
    told = Presentation(detail, Path(templates) if templates else None, language=language, notation=notation)
    within = Limits(**limits)
    read = read_exam(source_of(exam))
    files = _handed_in(answers, read)
    with Processes(jobs) as executor, shown(progress) as tell:
        variants = {each.submission.variant for each in files if each.submission is not None}
        tell(0, len(files), "solving")
        ruled = partial(prepared, told, partial_credit)
        means = Means(told, within, executor)
        solutions = solutions_of(read, variants, means, ruled)
        graded = _graded(files, solutions, means, tell)
        worked = worked_of(solutions, means) if solution else {}
    if override is not None:
        graded = _overridden(source_of(override), read, graded)
    messages = told.messages(read.questions[0].problem.display)
    return MarkedExam(read, graded, solutions, messages, told.templates, worked)


def _graded(files: Sequence[HandedIn], solutions: Solutions, means: Means, tell: Tell) -> tuple[Graded, ...]:
    papers = [each.submission for each in files if each.submission is not None]
    markings = marked(papers, solutions, means)
    graded = []
    for number, each in enumerate(files):
        tell(number, len(files), "marking")
        graded.append(each.graded(markings))
    return tuple(graded)


def _overridden(source: Source, exam: Exam, graded: Sequence[Graded]) -> tuple[Graded, ...]:
    """Return the papers with an instructor's changes; raises InputError where one does not fit, or is of nobody."""
    changes, wrong = fitted(source, exam, [(each.file, each.student) for each in graded])
    changed = []
    for each in graded:
        found = changes.of(*names_of(exam, each.file, each.student)) if each.marking is not None else None
        try:
            changed.append(each if found is None else with_changes(each, found))
        except Fault as fault:
            wrong += fault.diagnostics
    if wrong:
        raise InputError(source, wrong)
    return tuple(changed)


def _handed_in(answers: Answers, exam: Exam) -> list[HandedIn]:
    """Read what was handed in: files, or by student the answers, or what a file says beside them: the variant.

    Raises InputError where the only file is not there, or a folder has no answer file.
    """
    if isinstance(answers, Mapping):
        given: dict[str, dict[str, Any]] = {}
        for student, each in answers.items():
            said = each if isinstance(each, Mapping) and "answers" in each else {"answers": each}
            given[f"<{student}>"] = {"student": student, **said}
        return [handed_in(name, partial(source_of_data, each, name), exam) for name, each in given.items()]
    named = [Path(answers)] if isinstance(answers, str | Path) else [Path(each) for each in answers]
    if isinstance(answers, str | Path) and not named[0].is_dir():
        load_submitted(named[0])  # that it is not there is told of a file among others by its place in the table
    files = [file for each in named for file in (_answer_files(each) if each.is_dir() else [each])]
    return [handed_in(str(file), partial(load_submitted, file), exam) for file in files]


def _answer_files(folder: Path) -> list[Path]:
    if found := answer_files(folder):
        return found
    raise InputError(Source(str(folder), ""), [Diagnostic("there is no answer file in this folder; they end in .yaml")])


__all__ = ["MarkedExam", "check_exam"]
