"""The work of `solve check`: solve the problem once, mark the answer files, report, tabulate."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path

import click

from solver.classroom import Marking, Submission, mark, mark_each
from solver.classroom.changed import changed
from solver.classroom.reading.change_file import Changes, StudentChanges, read_changes
from solver.classroom.report.table import as_csv, columns_of
from solver.cli.bugs import report_bug
from solver.cli.delivery import Delivery
from solver.cli.destination import STANDARD, AtFault, write_whole
from solver.cli.grading import check_exam
from solver.cli.handed_in import exam_of, passed_over
from solver.cli.inputs import is_one_file
from solver.cli.marks_kept import marks_kept, tidy, working
from solver.cli.papers import CheckRequest, Paper, Problems, files_in, told_apart
from solver.cli.progress import Meter
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, settle, source_of
from solver.cli.syntax import tell_readings
from solver.messages import Messages
from solver.papers.marked import MarkedBefore
from solver.problem.source import Fault, InputError, Source

EMPTY = Submission(Source("", ""), "", {})


def check_files(request: CheckRequest) -> int:
    """Mark all answer files; return the worst exit code: 1 where an answer is wrong, 2 where a file is at fault."""
    settle()
    problem, named = told_apart(request.files)
    files = files_in(named, problem, request.changes)
    several = len(files) > 1 or not all(map(is_one_file, named))
    _refuse_to_overwrite(request, (*files, *filter(None, (problem, request.changes))))
    if (exam := exam_of(problem, files)) is not None:
        return check_exam(request, exam, files, passed_over(named, (*files, *filter(None, (request.changes,)))))
    if request.report:
        raise click.UsageError("--report is about an exam: solve check EXAM ANSWERS.")
    delivery = Delivery(request, files, several)
    meter = Meter(len(files))
    kept = marks_kept(request, problem or "", files)
    problems = Problems(request, meter, kept)
    papers = [problems.paper(file, problem) for file in files]
    problems.tell_nameless()
    if request.syntax:
        return tell_readings(papers, problems)
    try:
        changes = read_changes(source_of(request.changes)) if request.changes else None
        code = _fit(changes, papers, problems) if changes is not None else SOLVED
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    desk = _Desk(request, problems, changes, delivery)
    code = max(code, desk.mark(papers, meter))
    tidy(request, kept)
    delivery.conclude()
    if request.table:
        _write_table(request.table, desk, problems)
    return code


def _refuse_to_overwrite(request: CheckRequest, files: Sequence[str]) -> None:
    read = {Path(file).resolve() for file in files if file != STANDARD}
    for path in (request.output, request.table, request.report):
        if path and path != STANDARD and Path(path).resolve() in read:
            raise click.UsageError(f"{path} is one of the files that are read; it is not overwritten.")


def _fit(changes: Changes, papers: Sequence[Paper], problems: Problems) -> int:
    """Raise InputError where changes name parts or answers that there are not; say which ones name no student."""
    strangers = changes.strangers([_names(paper) for paper in papers])
    for paper in papers:
        found = changes.of(*_names(paper))
        if found is not None and paper.submission is not None:
            parts = problems.solutions[paper.problem].problem.parts
            changes.refuse_unknown(found, {part.id: part for part in parts})
    if strangers:
        click.echo(InputError(changes.source, strangers).render(), err=True)
    return INPUT_AT_FAULT if strangers else SOLVED


class _Desk:
    """Marks papers, with an instructor's changes, and hands them back; `rows` are those of the table."""

    def __init__(self, request: CheckRequest, problems: Problems, changes: Changes | None, delivery: Delivery) -> None:
        self.request = request
        self.problems = problems
        self.changes = changes
        self.delivery = delivery
        self.rows: list[tuple[str, Marking | None]] = []

    def mark(self, papers: Sequence[Paper], meter: Meter) -> int:
        """Mark and hand back each paper, in order; return the worst exit code."""
        codes = [SOLVED]
        read = [paper for paper in papers if paper.submission is not None]
        pairs = [(self.problems.solutions[each.problem], each.submission) for each in read if each.submission]
        with working(self.request, self.problems.kept) if len(pairs) > 1 else nullcontext() as executor:
            memory = MarkedBefore(self.problems.kept)
            markings = mark_each(pairs, self.request.limits, self.request.templates, executor, memory)
            for paper in papers:
                codes.append(paper.code)
                marking = None
                if paper.submission is not None:
                    with meter.file(paper.name):
                        marking, code = self._with_changes(paper, next(markings))
                    codes.append(code)
                meter.next_file()
                self.rows.append((paper.name, marking))
                codes.append(self._hand_back(paper, marking))
        return max(codes)

    def _hand_back(self, paper: Paper, marking: Marking | None) -> int:
        """Hand a paper back; whatever goes wrong becomes words on standard error and an exit code."""
        try:
            self.delivery.hand_back(paper, marking, self.problems)
        except AtFault as error:
            click.echo(f"{paper.name}: error: {error.format_message()}", err=True)
            return error.exit_code
        except BrokenPipeError:
            raise  # it concerns all papers
        except Exception as bug:  # noqa: BLE001 - the boundary of a paper: a bug in one must not stop the rest
            return report_bug(bug, paper.name)
        return SOLVED

    def _with_changes(self, paper: Paper, marking: Marking) -> tuple[Marking, int]:
        """Return the marking with the instructor's changes, and its exit code."""
        found: StudentChanges | None = self.changes.of(*_names(paper)) if self.changes is not None else None
        if self.changes is not None and found is not None:
            try:
                marking = changed(marking, found)
            except Fault as fault:
                click.echo(InputError(self.changes.source, fault.diagnostics).render(), err=True)
                return marking, INPUT_AT_FAULT
        return marking, SOLVED if marking.all_right else UNSOLVED


def _names(paper: Paper) -> list[str]:
    """What an instructor may call a paper: the file, its name with and without the ending, the student's label."""
    path = Path(paper.name)
    label = paper.submission.student if paper.submission is not None else ""
    return [name for name in (paper.name, path.name, path.stem, label) if name]


def _write_table(path: str, desk: _Desk, problems: Problems) -> None:
    columns: dict[str, tuple[str, ...]] = {}
    for solution in problems.solutions.values():
        for id_, answers in columns_of(mark(solution, EMPTY)):
            columns[id_] = tuple(dict.fromkeys([*columns.get(id_, ()), *answers]))
    messages = next((problems.messages(name) for name in problems.solutions), Messages())
    write_whole(Path(path), as_csv(desk.rows, list(columns.items()), messages).encode())
    click.echo(f"wrote {path}", err=True)
