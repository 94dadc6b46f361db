"""The work of `solve exam`: read, draw, solve and verify all questions, write, and say what was written."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import click

from solver.classroom.reading.files import is_filled
from solver.cli.destination import NAMELESS, STANDARD, AtFault, write_changed
from solver.cli.executing import Workers
from solver.cli.exporting import write_exports
from solver.cli.filled import asked_in, changed_since, keep_asked, tell_left_over
from solver.cli.kept import Record, hash_of_folder, key_of
from solver.cli.progress import bar, search_bar
from solver.cli.solving import INPUT_AT_FAULT, SOLVED, UNSOLVED, in_words, settle, source_of
from solver.cli.store import Store
from solver.document.model import Presentation
from solver.limits import Limits
from solver.papers.exam.drawing import Drawn, Means, drawn, shared, to_be_made
from solver.papers.exam.making import ANSWERS, answer_file, facts_of_paper, files_of, variants_table
from solver.papers.exam.model import Exam
from solver.papers.exam.reading import read_exam
from solver.papers.export.making import for_bank
from solver.papers.kept import NOTHING
from solver.problem.source import InputError
from solver.render import pdf

PAPER = "paper "
"""Names of papers in the record begin so."""


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
    space: float | None = None
    exports: tuple[str, ...] = ()
    again: bool = False

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
    if "pdf" in order.formats:
        with in_words("PDF"):  # before anything is solved for nothing
            pdf.chosen(order.presentation.pdf_engine)
    try:
        exam = read_exam(source_of(order.file))
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    store = Store(order.folder, order.presentation.templates, anew=order.again)
    with order.workers.executor() as executor, Record(order.folder, anew=order.again) as record:
        space = None if order.space is None else Fraction(str(order.space))
        kept = NOTHING if order.exports else store  # nothing stands beside an export
        means = Means(order.presentation, order.limits, executor, order.draws, space, kept)
        means = for_bank(means) if order.exports else means
        code = _make(order, exam, means, record)
        if code == SOLVED and not order.exports:
            store.forget_others()
            record.forget_others(lambda name: name.startswith(PAPER))
        return code


def _make(order: Order, exam: Exam, means: Means, record: Record) -> int:
    """Draw the variants and write them; return the exit code."""
    try:
        with search_bar(to_be_made(exam)) as tell:
            variants = drawn(exam, means, tell)
    except InputError as error:  # a question is not verified, or a family has too few members
        click.echo(error.render(), err=True)
        kept = means.kept.place
        aside = f"; what was solved is kept in {kept} for the next time" if kept else ""
        click.echo(f"nothing was written: every question of every variant must be verified{aside}", err=True)
        return UNSOLVED
    if order.exports:
        return write_exports(order, exam, variants, means)
    return _write(order, exam, variants, means, record)


def _write(order: Order, exam: Exam, variants: Sequence[Sequence[Drawn]], means: Means, record: Record) -> int:
    code = SOLVED
    told, engine = order.presentation, pdf.chosen(order.presentation.pdf_engine) if "pdf" in order.formats else ""
    keys = {
        pair[0].label: key_of(hash_of_folder(told.templates), engine, facts_of_paper(exam, *pair, order.formats, means))
        for pair in zip(exam.variants, variants, strict=True)
    }
    with bar("writing", len(variants)) as advance:
        for files in files_of(exam, variants, order.formats, means, lambda each: _is_there(record, each.label, keys)):
            if files.fault:
                click.echo(f"{files.variant.label}: error: cannot make the paper: {files.fault}", err=True)
                code = INPUT_AT_FAULT
            _write_all(order, files.contents)
            if not files.fault and not files.unchanged:
                record.put(PAPER + files.variant.label, keys[files.variant.label], files.contents, {})
            advance()
    named = "" if order.file == STANDARD else _seen_from(order.folder / ANSWERS, Path(order.file))
    sheets = {
        f"{ANSWERS}/answers-{variant.label}.yaml": answer_file(exam, named, variant, questions).encode()
        for variant, questions in zip(exam.variants, variants, strict=True)
    }
    asked = {f"{ANSWERS}/answers-{variant.label}.yaml": asked_in(variant, questions)
             for variant, questions in zip(exam.variants, variants, strict=True)}  # fmt: skip
    for name in [name for name in sheets if is_filled(order.folder / name)]:
        changed = changed_since(record, name, asked[name])
        click.echo(f"kept {order.folder / name}: there are answers in it{changed}", err=True)
        del sheets[name]
    _write_all(order, {**sheets, "variants.csv": variants_table(exam, variants).encode()})
    for name in sheets:
        keep_asked(record, name, asked[name])
    tell_left_over(order.folder, [each.label for each in exam.variants])
    whose = f"{len(exam.students)} students" if exam.students else f"{exam.count} variants"
    many = "1 question" if len(exam.questions) == 1 else f"{len(exam.questions)} questions"
    click.echo(f"{many}, {whose if len(variants) > 1 else 'one paper'}, all verified")
    for number, members in shared(variants).items():
        whose = "all students have its only member" if members == 1 else f"students have its {members} members in turn"
        click.echo(f"question {number}: {whose}, as variants.csv tells", err=True)
    if "pdf" in order.formats and (named := _without_glyphs(exam, order.presentation.pdf_engine)):
        click.echo(f"the fonts of the PDFs lack letters of {named}; they are named there, and HTML has them", err=True)
    if named := _in_words(exam, order.formats, engine):
        click.echo(f"TeX draws no SVG: it has words in the place of {named}; HTML and typst show it", err=True)
    click.echo(f"wrote papers, keys ({', '.join(order.formats)}), answer files and variants.csv to {order.folder}")
    return code


def _is_there(record: Record, label: str, keys: Mapping[str, str]) -> bool:
    """Whether paper and key of a variant were made of the same as now, and are as they were."""
    return record.get(PAPER + label, keys[label]) is not None


def _without_glyphs(exam: Exam, wanted: str | None) -> str:
    """Return the students whose names a PDF cannot show as they are written."""
    lacking = [each for each in exam.students if not pdf.shows(each, wanted)]
    return ", ".join(lacking[:5]) + (f" and {len(lacking) - 5} more" if lacking[5:] else "")


def _in_words(exam: Exam, formats: Sequence[str], engine: str) -> str:
    """Return the pictures that papers by TeX have in words only."""
    if "latex" not in formats and engine != pdf.TEX:
        return ""
    drawings = [(question.number, address) for question in exam.questions
                for address, image in question.problem.images.items() if image.is_drawing]  # fmt: skip
    return ", ".join(f"{address} (question {number})" for number, address in drawings)


def _write_all(order: Order, contents: Mapping[str, bytes]) -> None:
    read = Path(order.file).resolve() if order.file != STANDARD else None
    for name, content in contents.items():
        path = order.folder / name
        if path.resolve() == read:
            raise AtFault(f"{path} is the exam itself; it is not overwritten")
        write_changed(path, content)


def _seen_from(folder: Path, file: Path) -> str:
    return Path(os.path.relpath(file.resolve(), folder.resolve())).as_posix()
