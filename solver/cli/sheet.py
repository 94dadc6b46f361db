"""`solve sheet problem.yaml`: the blank answer file."""

from __future__ import annotations

import os
from pathlib import Path

import click

from solver.cli.language import LANGUAGE, known
from solver.cli.run import Seconds


@click.command(short_help="Write the blank answer file of a problem.")
@click.argument("problem")
@click.option("-o", "--output", metavar="FILE", help="Where to write it. Default: standard output.")
@click.option("--templates", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path),
              help="Templates that take precedence over the program's own.")  # fmt: skip
@LANGUAGE
@click.option("--time-limit", metavar="SECONDS", type=Seconds(), default=60, show_default=True, help="For each part.")
@click.pass_context
def sheet(
    ctx: click.Context,
    problem: str,
    output: str | None,
    templates: Path | None,
    language: str | None,
    time_limit: float,
) -> None:
    """Write a file to fill in: the parts of PROBLEM, the names of the answers, how each is written.

    `solve check --syntax` then says how it is read, and `solve check` marks it.
    """
    from solver.classroom.blank import blank_answers
    from solver.cli.destination import STANDARD, write_whole
    from solver.cli.papers import CheckRequest, Problems
    from solver.cli.progress import Meter
    from solver.cli.solving import INPUT_AT_FAULT, settle
    from solver.document.model import Presentation
    from solver.limits import Limits
    from solver.problem.source import InputError

    to_file = output is not None and output != STANDARD
    if to_file and output is not None and Path(output).exists():
        raise click.UsageError(f"{output} exists already; it will not be overwritten.")
    settle()
    told = Presentation(templates=templates, language=known(language, templates, ctx))
    request = CheckRequest((), None, None, None, False, told, Limits(time_limit))
    try:
        solution = Problems(request, Meter(1)).solution(problem)
    except InputError as error:
        click.echo(error.render(), err=True)
        ctx.exit(INPUT_AT_FAULT)
    folder = Path(output).resolve().parent if to_file and output is not None else Path.cwd()
    named = "" if problem == STANDARD else Path(os.path.relpath(Path(problem).resolve(), folder)).as_posix()
    text = blank_answers(solution, named, templates)
    if not to_file or output is None:
        click.echo(text, nl=False)
        return
    write_whole(Path(output), text.encode())
    click.echo(f"wrote {output}; mark it with: solve check {problem} {output}")
