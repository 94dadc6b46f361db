"""The work of `solve exam --export`: the questions of all variants in one file that a learning system imports."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from solver.cli.destination import NAMELESS, STANDARD, AtFault, write_whole
from solver.cli.solving import SOLVED, UNSOLVED
from solver.papers.export.formats import EXPORTS
from solver.papers.export.making import quiz_of
from solver.papers.export.summary import counted, told

if TYPE_CHECKING:
    from solver.cli.examining import Order
    from solver.papers.exam.drawing import Drawn, Means
    from solver.papers.exam.model import Exam


def write_exports(order: Order, exam: Exam, variants: Sequence[Sequence[Drawn]], means: Means) -> int:
    """Write the bank of an exam in the formats asked for, say what a person must mark; return the exit code."""
    bank = quiz_of(exam, variants, means)
    if bank.faults:
        for fault in bank.faults:
            click.echo(f"error: {fault}", err=True)
        click.echo("nothing was written: every question of every variant must be told", err=True)
        return UNSOLVED
    for each in bank.left_out:
        click.echo(f"left out, as it has no solution: {each}", err=True)
    if not bank.quiz.groups:
        click.echo("nothing was written: no question has a solution", err=True)
        return UNSOLVED
    paths = []
    for name in order.exports:
        export = EXPORTS[name]
        path = order.folder / f"{_stem(order)}{export.suffix}"
        if order.file != STANDARD and path.resolve() == Path(order.file).resolve():
            raise AtFault(f"{path} is the exam itself; it is not overwritten")
        write_whole(path, export.write(bank.quiz))
        paths.append(str(path))
    for line in told(bank.quiz):
        click.echo(line, err=True)
    click.echo(f"{counted(bank.quiz)}, all verified")
    click.echo(f"wrote {', '.join(paths)}")
    return SOLVED


def _stem(order: Order) -> str:
    path = Path(NAMELESS if order.file == STANDARD else order.file)
    return path.stem if path.suffix.lower() in {".yaml", ".yml"} else path.name
