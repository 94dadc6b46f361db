"""The work of `solve check exam.yaml answers/`: each file against its own variant, reports, the table of grades."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from solver.classroom.reading.answer_file import root_of_answers
from solver.classroom.report.data import as_data
from solver.classroom.report.text import print_marking
from solver.classroom.report.words import number
from solver.classroom.syntax import Readings
from solver.cli.delivery import Delivery
from solver.cli.destination import STANDARD, AtFault, write_changed, write_whole
from solver.cli.named import named_in
from solver.cli.overriding import overriding
from solver.cli.papers import CheckRequest, submitted
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, in_words, source_of
from solver.cli.syntax import Told, tell
from solver.messages import Messages
from solver.problem.source import InputError
from solver.problem.yaml_tree import parse_yaml
from solver.words import Phrase

NO_EXAM = "-"
"""Stands for answers to one problem among what answer files name."""

if TYPE_CHECKING:
    from solver.classroom import Marking
    from solver.executors import Executor
    from solver.limits import Exceeded
    from solver.papers.exam.grades import Graded
    from solver.papers.exam.marking import Solutions, Worked
    from solver.papers.exam.model import Exam
    from solver.papers.exam.submitted import ExamSubmission
    from solver.problem.model import Problem


def exam_of(problem: str | None, files: Sequence[str]) -> str | None:
    """Return the exam that is named, or that most answer files name; None where answers are to one problem."""
    from solver.papers.exam.reading import is_exam

    if problem is not None:
        if problem == STANDARD:
            return None
        try:
            return problem if is_exam(parse_yaml(source_of(problem))) else None
        except InputError:
            return None  # what is wrong is told where it is read
    named = Counter(filter(None, map(_exam_named_in, files)))
    found, _ = named.most_common(1)[0] if named else (NO_EXAM, 0)
    return found if found != NO_EXAM else None


def _exam_named_in(file: str) -> str:
    """Return the exam that an answer file names, `NO_EXAM` where it names none, "" where that cannot be known."""
    try:
        named = named_in(submitted(file), "exam", file) if file != STANDARD else ""
    except InputError:  # it is told where the file is read
        return ""
    return named or NO_EXAM


def passed_over(named: Sequence[str], files: Sequence[str]) -> list[str]:
    """Return the files of folders that are not read since they do not end in .yaml; hidden ones are none."""
    read = {Path(file).resolve() for file in files if file != STANDARD}
    inside = [path for name in named if Path(name).is_dir() for path in sorted(Path(name).iterdir())]
    return [str(path) for path in inside if path.is_file() and path.resolve() not in read and path.name[0] != "."]


def check_exam(request: CheckRequest, file: str, files: Sequence[str], others: Sequence[str] = ()) -> int:
    """Mark the answers to an exam; return the worst exit code: 1 where an answer is wrong, 2 where a file is at fault.

    What is wrong with one file is told, and stops no other; `others` stand beside them and are only told.
    """
    from solver.papers.exam.drawing import Means
    from solver.papers.exam.marking import marked, solutions_of, worked_of
    from solver.papers.exam.reading import read_exam

    try:
        exam = read_exam(source_of(file))
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    read = [_read(name, exam, "" if file in request.files else file) for name in files]
    papers = [each.submission for each in read if each.submission is not None]
    try:
        named = [(each.name, each.submission.student if each.submission else "") for each in read]
        override = overriding(request.changes, exam, named)
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    with request.workers.executor() as executor:
        means = Means(request.presentation, request.limits, executor)
        try:
            solutions = solutions_of(exam, {each.variant for each in papers}, means, partial(_prepared, request))
        except InputError as error:
            click.echo(error.render(), err=True)
            return UNSOLVED
        if request.syntax:
            return _tell_readings(request, read, solutions, executor)
        markings = marked(papers, solutions, request.limits, request.templates, executor)
        graded = [override.applied(each.graded(markings)) for each in read]
        wanted = request.solution and request.chosen_format == "html"
        worked = worked_of(solutions, request.presentation, request.limits, executor) if wanted else {}
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


def _tell_readings(request: CheckRequest, read: Sequence[_Read], solutions: Solutions, executor: Executor) -> int:
    """Say how the values of each file are read; return the worst exit code."""
    from solver.papers.exam.marking import read_as

    there = [each.submission for each in read if each.submission is not None]
    found = read_as(there, solutions, request.limits, request.templates, executor)
    told = (each.told(request, found, solutions) for each in read)
    return tell(told, len(read), as_json=request.format == "json")


def _prepared(request: CheckRequest, problem: Problem) -> Problem:
    """Return a problem in the language asked for, and marked by the rule asked for."""
    from solver.problem.partial import ruled
    from solver.tasks import catalogue

    told = request.presentation.of(problem)
    return ruled(told, request.partial, catalogue()) if request.partial else told


@dataclass(frozen=True)
class _Read:
    """An answer file and what it says, or why it cannot be read."""

    name: str
    submission: ExamSubmission | None = None
    fault: str = ""

    def graded(self, markings: Iterator[tuple[Marking, ...]]) -> Graded:
        """Return it with its marking, the next one where it could be read."""
        from solver.papers.exam.grades import Graded
        from solver.papers.exam.marking import together

        if self.submission is None:
            return Graded(self.name, fault=self.fault)
        student, of_questions = self.submission.student, next(markings)
        whole = together(student, of_questions)
        return Graded(self.name, student, self.submission.variant, whole, of_questions=of_questions)

    def told(self, request: CheckRequest, found: Iterator[Readings | Exceeded], solutions: Solutions) -> Told:
        """Return how its values are read, the next ones where it could be read."""
        if self.submission is None:
            return Told(self.name, fault=self.fault, code=INPUT_AT_FAULT)
        readings = next(found)
        display = solutions[self.submission.variant][0].problem.display
        messages = Messages(request.templates, display.language, display.notation)
        name = f"{self.name}, {messages.say(Phrase('Variant {number}', number=self.submission.variant))}"
        if isinstance(readings, Readings):
            return Told.of(self.name if request.format == "json" else name, readings, messages)
        fault = messages.say(readings.reason)
        click.echo(f"{self.name}: error: {fault}", err=True)
        return Told(self.name, fault=fault, code=UNSOLVED)


def _read(name: str, exam: Exam, followed: str) -> _Read:
    """Read an answer file; what is wrong with it becomes words on standard error.

    Where the exam is `followed`, and not named on the command line, a file that names another one is at fault.
    """
    from solver.papers.exam.submitted import read_exam_submission

    try:
        source = submitted(name)
        if followed and named_in(source, "exam", name) not in {"", followed}:
            message = f"it names another exam than most files, which answer {followed}"
            raise InputError(source, [root_of_answers(source)["exam"].diagnostic(message)])
        return _Read(name, read_exam_submission(source, exam))
    except InputError as error:
        fault = error.render()
    except AtFault as error:
        fault = f"{name}: error: {error.format_message()}"
    click.echo(fault, err=True)
    return _Read(name, fault=fault)


def _tell(request: CheckRequest, graded: Sequence[Graded]) -> None:
    """Write the markings, as text or as a list of data, where they are asked for."""
    if request.chosen_format == "json":
        items = [_data(each) for each in graded]
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
            path = delivery.path_of(each.file)
            write_changed(path, page.encode())
            click.echo(f"{each.file}: {number(each.marking.marks)} of {number(each.marking.out_of)}; wrote {path}")


def _data(each: Graded) -> dict[str, Any]:
    if each.marking is None:
        return {"file": each.file, "student": "", "error": each.fault}
    return {"file": each.file, "variant": each.variant, "student": each.student, **as_data(each.marking)}


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
    from solver.papers.exam.grades import grades_table, missing

    if request.table:
        write_whole(Path(request.table), grades_table(exam, graded).encode())
        click.echo(f"wrote {request.table}", err=True)
    unread = [each.file for each in graded if each.marking is None]
    markings = [each.marking for each in graded if each.marking is not None]
    students = [each.student for each in graded if each.marking is not None and each.student]
    for student in dict.fromkeys(each for each in students if students.count(each) > 1):
        click.echo(f"several files of {student} were marked", err=True)
    if unread:
        click.echo(f"not readable: {', '.join(unread)}", err=True)
    if absent := missing(exam, graded):
        click.echo(f"no file of: {', '.join(absent)}", err=True)
    click.echo(f"marked {len(markings)} of {len(graded)} files", err=True)
    if unread:
        return INPUT_AT_FAULT
    return SOLVED if all(each.all_right for each in markings) else UNSOLVED
