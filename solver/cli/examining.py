"""The work of `solve exam`: read, draw, solve and verify all questions, write, and say what was written."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from solver.classroom.reading.answer_file import is_blank, root_of_answers
from solver.cli.destination import NAMELESS, STANDARD, AtFault, write_whole
from solver.cli.drawing import progress
from solver.cli.executing import Workers
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, settle, source_of
from solver.document.model import Presentation
from solver.limits import Limits
from solver.papers.exam.drawing import Drawn, Means, drawn
from solver.papers.exam.making import ANSWERS, answer_file, files_of, variants_table
from solver.papers.exam.model import Exam
from solver.papers.exam.reading import read_exam
from solver.problem.nodes import MappingNode
from solver.problem.source import InputError


@dataclass(frozen=True, slots=True)
class Order:
    """What the command line asks for."""

    file: str
    formats: tuple[str, ...]
    output: str | None
    presentation: Presentation
    limits: Limits
    draws: int
    workers: Workers

    @property
    def folder(self) -> Path:
        """Where all is written."""
        if self.output is not None:
            return Path(self.output)
        path = Path(NAMELESS if self.file == STANDARD else self.file)
        stem = path.stem if path.suffix.lower() in (".yaml", ".yml") else path.name
        return path.with_name(f"{stem}-papers")


def write_exam(order: Order) -> int:
    """Make and write the papers, the keys and what goes with them; return the exit code."""
    if order.output == STANDARD or order.folder.is_file():
        raise click.UsageError("an exam is several files: name a folder with -o.")
    settle()
    try:
        exam = read_exam(source_of(order.file))
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    with order.workers.executor() as executor:
        return _make(order, exam, Means(order.presentation, order.limits, executor, order.draws))


def _make(order: Order, exam: Exam, means: Means) -> int:
    """Draw the variants and write them; return the exit code."""
    try:
        with progress(len(exam.variants)) as tell:
            variants = drawn(exam, means, tell)
    except InputError as error:  # a question is not verified, or a family has too few members
        click.echo(error.render(), err=True)
        click.echo("nothing was written: every question of every variant must be verified", err=True)
        return UNSOLVED
    return _write(order, exam, variants, means)


def _write(order: Order, exam: Exam, variants: Sequence[Sequence[Drawn]], means: Means) -> int:
    code = SOLVED
    for files in files_of(exam, variants, order.formats, means):
        if files.fault:
            click.echo(f"{files.variant.label}: error: cannot make the paper: {files.fault}", err=True)
            code = INPUT_AT_FAULT
        _write_all(order, files.contents)
    named = "" if order.file == STANDARD else _seen_from(order.folder / ANSWERS, Path(order.file))
    sheets = {
        f"{ANSWERS}/answers-{variant.label}.yaml": answer_file(exam, named, variant, questions).encode()
        for variant, questions in zip(exam.variants, variants, strict=True)
    }
    for name in [name for name in sheets if is_filled(order.folder / name)]:
        click.echo(f"kept {order.folder / name}: there are answers in it", err=True)
        del sheets[name]
    _write_all(order, {**sheets, "variants.csv": variants_table(exam, variants).encode()})
    whose = f"{len(exam.students)} students" if exam.students else f"{exam.count} variants"
    click.echo(f"{len(exam.questions)} questions, {whose if len(variants) > 1 else 'one paper'}, all verified")
    click.echo(f"wrote papers, keys ({', '.join(order.formats)}), answer files and variants.csv to {order.folder}")
    return code


def _write_all(order: Order, contents: Mapping[str, bytes]) -> None:
    read = Path(order.file).resolve() if order.file != STANDARD else None
    for name, content in contents.items():
        path = order.folder / name
        if path.resolve() == read:
            raise AtFault(f"{path} is the exam itself; it is not overwritten")
        write_whole(path, content)


def is_filled(path: Path) -> bool:
    """Whether a file holds answers, or what nobody but a person has written: it is not to be overwritten."""
    if not path.exists():
        return False
    try:
        answers = root_of_answers(source_of(str(path))).get("answers")
    except InputError:
        return True
    left = [answers] if answers is not None else []
    while left:
        node = left.pop()
        if not isinstance(node, MappingNode):
            if not is_blank(node):
                return True
            continue
        left += [entry.value for entry in node]
    return False


def _seen_from(folder: Path, file: Path) -> str:
    return Path(os.path.relpath(file.resolve(), folder.resolve())).as_posix()
