"""What is handed in to an exam: which exam the files answer, and what each of them says, or why it cannot be marked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from solver.classroom.reading.answer_file import node_naming, root_of_answers
from solver.classroom.syntax import Readings
from solver.cli.destination import STANDARD, AtFault
from solver.cli.named import named_in
from solver.cli.papers import CheckRequest, below, printable, submitted
from solver.cli.solving import INPUT_AT_FAULT, UNSOLVED, source_of
from solver.cli.syntax import Told
from solver.messages import Messages
from solver.problem.source import InputError, Source
from solver.problem.yaml_tree import parse_yaml
from solver.words import Phrase

NO_EXAM = "-"
"""Stands for answers to one problem among what answer files name."""

if TYPE_CHECKING:
    from solver.limits import Exceeded
    from solver.papers.exam.handed_in import HandedIn
    from solver.papers.exam.marking import Solutions
    from solver.papers.exam.model import Exam


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


def source_of_exam(exam: str, files: Sequence[str]) -> Source:
    """Return the text of an exam that is named, by files or on the command line; raises InputError.

    Where only files name it, what is wrong is told at the first place that does, with the way to call it.
    """
    try:
        return source_of(exam)
    except InputError as error:
        naming = [file for file in files if _exam_named_in(file) == exam]
        if not naming:
            raise
        source, said = submitted(naming[0]), error.diagnostics[0]
        node = node_naming(source, "exam")
        others = f"; {len(naming) - 1} more of the files name it" if naming[1:] else ""
        note = f"name it on the command line: solve check EXAM ANSWERS{others}"
        message = f"the exam {exam[:100]!r}: {said.message}"
        raise InputError(source, [node.diagnostic(message, said.suggestion, note)] if node else [said]) from None


def passed_over(named: Sequence[str], files: Sequence[str]) -> list[str]:
    """Return what is in folders and is not read, folders with a stroke behind them; hidden ones are none.

    It is told how answer files in folders below are named.
    """
    read = {Path(file).resolve() for file in files if file != STANDARD}
    folders = [Path(name) for name in named if Path(name).is_dir()]
    inside = [path for folder in folders for path in sorted(folder.iterdir()) if path.name[0] != "."]
    for each in filter(None, map(below, map(str, folders))):
        click.echo(each.strip(), err=True)
    others = [f"{path}/" if path.is_dir() else str(path) for path in inside if path.resolve() not in read]
    return [printable(each) for each in others]


def readings_of(
    read: HandedIn, request: CheckRequest, found: Iterator[Readings | Exceeded], solutions: Solutions
) -> Told:
    """Tell how the values of a file are read, the next ones where it could be read."""
    if read.submission is None:
        return Told(read.name, fault=read.fault, code=INPUT_AT_FAULT)
    readings = next(found)
    display = solutions[read.submission.variant][0].problem.display
    messages = Messages(request.templates, display.language, display.notation)
    name = f"{read.name}, {messages.say(Phrase('Variant {number}', number=read.submission.variant))}"
    if isinstance(readings, Readings):
        return Told.of(read.name if request.format == "json" else name, readings, messages)
    fault = messages.say(readings.reason)
    click.echo(f"{read.name}: error: {fault}", err=True)
    return Told(read.name, fault=fault, code=UNSOLVED)


def read_paper(name: str, exam: Exam, followed: str) -> HandedIn:
    """Read an answer file; what is wrong with it becomes words on standard error.

    Where the exam is `followed`, and not named on the command line, a file that names another one is at fault.
    """
    from solver.papers.exam.grades import NOT_READABLE
    from solver.papers.exam.handed_in import HandedIn, handed_in
    from solver.papers.exam.whose import may_be_of

    try:
        read = handed_in(name, partial(_answering, name, followed), exam)
    except AtFault as error:
        fault, student = f"{name}: error: {error.format_message()}", may_be_of(name, None, exam)
        read = HandedIn(name, fault=fault, student=student, status=NOT_READABLE)
    if read.fault:
        click.echo(read.fault, err=True)
    return read


def _answering(name: str, followed: str) -> Source:
    """Return the text of an answer file; raises InputError where it names another exam than the one followed."""
    from solver.papers.exam.submitted import NotPlacedError
    from solver.papers.exam.whose import ANOTHER_EXAM, Unplaced

    source = submitted(name)
    if followed and named_in(source, "exam", name) not in {"", followed}:
        message = f"it names another exam than most files, which answer {followed}"
        raise NotPlacedError(source, Unplaced(root_of_answers(source)["exam"].diagnostic(message), ANOTHER_EXAM))
    return source
