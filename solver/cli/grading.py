"""The work of `solve check exam.yaml answers/`: each file against its own variant, reports, the table of grades."""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from solver.classroom.report.text import print_marking
from solver.classroom.report.words import number
from solver.cli.delivery import Delivery
from solver.cli.destination import STANDARD, write_whole
from solver.cli.handed_in import read_paper, readings_of, source_of_exam
from solver.cli.marks_kept import marks_kept, tidy, working
from solver.cli.overriding import overriding
from solver.cli.papers import CheckRequest
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, in_words, source_of
from solver.cli.syntax import tell
from solver.messages import Messages
from solver.problem.source import InputError

if TYPE_CHECKING:
    from solver.executors import Executor
    from solver.papers.exam.grades import Graded
    from solver.papers.exam.handed_in import HandedIn
    from solver.papers.exam.marking import Solutions, Worked
    from solver.papers.exam.model import Exam


def check_exam(request: CheckRequest, file: str, files: Sequence[str], others: Sequence[str] = ()) -> int:
    """Mark the answers to an exam; return the worst exit code: 1 where an answer is wrong, 2 where a file is at fault.

    What is wrong with one file is told, and stops no other; `others` stand beside them and are only told.
    """
    from solver.papers.exam.drawing import Means
    from solver.papers.exam.marking import marked, prepared, solutions_of, worked_of
    from solver.papers.exam.reading import read_exam

    try:
        exam = read_exam(source_of(file) if file in request.files else source_of_exam(file, files))
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    read = [read_paper(name, exam, "" if file in request.files else file) for name in files]
    papers = [each.submission for each in read if each.submission is not None]
    try:
        named = [(each.name, each.submission.student if each.submission else "") for each in read]
        override = overriding(request.changes, exam, named)
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    kept = marks_kept(request, file, files)
    with working(request, kept) as executor:
        means = Means(request.presentation, request.limits, executor, kept=kept)
        try:
            told = partial(prepared, request.presentation, request.partial)
            solutions = solutions_of(exam, {each.variant for each in papers}, means, told)
        except InputError as error:
            click.echo(error.render(), err=True)
            return UNSOLVED
        if request.syntax:
            return _tell_readings(request, read, solutions, executor)
        markings = marked(papers, solutions, means)
        graded = [override.applied(each.graded(markings)) for each in read]
        wanted = request.solution and request.chosen_format == "html"
        worked = worked_of(solutions, means) if wanted else {}
    tidy(request, kept)
    if request.chosen_format == "html":
        _write_sheets(request, exam, graded, solutions, worked)
    else:
        _tell(request, graded)
    if others:
        click.echo(f"passed over, no answer files by their names: {', '.join(others)}", err=True)
    _write_report(request, exam, graded, solutions)
    return max(override.code, _conclude(request, exam, graded))


def _write_report(request: CheckRequest, exam: Exam, graded: Sequence[Graded], solutions: Solutions) -> None:
    """Write what the marks say, where it is asked for."""
    if not request.report:
        return
    from solver.papers.exam.report import report_page

    messages = request.presentation.messages(exam.questions[0].problem.display)
    with in_words("the report"):
        page = report_page(exam, graded, solutions, request.templates, messages)
    write_whole(Path(request.report), page.encode())
    click.echo(f"wrote {request.report}", err=True)


def _tell_readings(request: CheckRequest, read: Sequence[HandedIn], solutions: Solutions, executor: Executor) -> int:
    """Say how the values of each file are read; return the worst exit code."""
    from solver.papers.exam.marking import read_as

    there = [each.submission for each in read if each.submission is not None]
    found = read_as(there, solutions, request.limits, request.templates, executor)
    said = (readings_of(each, request, found, solutions) for each in read)
    return tell(said, len(read), as_json=request.format == "json")


def _tell(request: CheckRequest, graded: Sequence[Graded]) -> None:
    """Write the markings, as text or as a list of data, where they are asked for."""
    if request.chosen_format == "json":
        from solver.papers.exam.grades import data_of

        items = data_of(graded)
        content = json.dumps(items, ensure_ascii=False, allow_nan=False, indent=1) + "\n"
    else:
        content = "".join(_text(request, each) for each in graded if each.marking is not None)
    if request.output is None or request.output == STANDARD:
        sys.stdout.write(content)
        sys.stdout.flush()
        return
    place = Path(request.output)
    if place.is_dir() or request.output.endswith("/"):
        place /= "marked.json" if request.chosen_format == "json" else "marked.txt"
    write_whole(place, content.encode())
    click.echo(f"wrote {place}", err=True)


def _write_sheets(
    request: CheckRequest, exam: Exam, graded: Sequence[Graded], solutions: Solutions, worked: Worked
) -> None:
    """Write a sheet for each file that was marked, beside it or into the folder named."""
    for (variant, number_), document in worked.items():
        if document is None:
            click.echo(f"question {number_} of variant {variant}: its worked solution met the limit", err=True)
    from solver.papers.exam.sheet import exam_sheet

    delivery = Delivery(request, [each.file for each in graded], several=len(graded) > 1)
    for each in graded:
        if each.marking is not None:
            with in_words("the sheet"):
                page = exam_sheet(
                    exam, each, solutions[each.variant], request.templates, key=request.key, worked=worked
                )
            path = delivery.write(each.file, page.encode())
            click.echo(f"{each.file}: {number(each.marking.marks)} of {number(each.marking.out_of)}; wrote {path}")


def _text(request: CheckRequest, each: Graded) -> str:
    from rich.console import Console

    from solver.render.terminal import WIDTH

    if each.marking is None:
        return ""
    messages = Messages(request.templates, request.presentation.language or "en")
    console = Console(highlight=False, width=WIDTH, force_terminal=False)
    with console.capture() as captured:
        print_marking(each.marking, f"{each.file}, variant {each.variant}", console, messages)
    return captured.get()


def _conclude(request: CheckRequest, exam: Exam, graded: Sequence[Graded]) -> int:
    """Write the table, say which files cannot be read and of whom there is none; return the worst exit code."""
    from solver.papers.exam.grades import grades_table, missing, several_of, unmarked

    if request.table:
        write_whole(Path(request.table), grades_table(exam, graded).encode())
        click.echo(f"wrote {request.table}", err=True)
    markings = [each.marking for each in graded if each.marking is not None]
    for student, files in several_of(graded).items():
        click.echo(f"several files of {student} were marked: {', '.join(files)}", err=True)
    if blank := [each.file for each in graded if each.is_blank]:
        click.echo(f"nothing is answered in: {', '.join(blank)}", err=True)
    for status, files in unmarked(graded).items():
        click.echo(f"{status}: {', '.join(files)}", err=True)
    if absent := missing(exam, graded):
        click.echo(f"no file of: {', '.join(absent)}", err=True)
    click.echo(f"marked {len(markings)} of {len(graded)} files", err=True)
    if len(markings) < len(graded):
        return INPUT_AT_FAULT
    return SOLVED if all(each.all_right for each in markings) else UNSOLVED
