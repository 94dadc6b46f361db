"""`solve variants problem.yaml`: the options. The work is in `drawing`, imported when it is wanted."""

from __future__ import annotations

from pathlib import Path

import click

from solver.cli.executing import Workers, executing
from solver.cli.language import LANGUAGE, NOTATION, known
from solver.cli.run import AGAIN, DETAILS, PDF_ENGINE, TEMPLATES, TIME_LIMIT, FormatList


@click.command(short_help="Draw members of a family of problems.")
@click.argument("problem")
@click.option("--count", type=click.IntRange(min=1, max=10_000), default=1, show_default=True, help="How many members.")
@click.option("--seed", type=int, default=1, show_default=True, help="The same seed draws the same members anywhere.")
@click.option("-f", "--format", "formats", type=FormatList("yaml"), default="yaml", show_default=True,
              help="yaml, html, latex, pdf, md, json, text: one or more.")  # fmt: skip
@click.option("-o", "--output", metavar="FOLDER", help="Where they are written. Default: PROBLEM-variants.")
@click.option("--check", is_flag=True, help="Tell the spread of difficulty: digits, steps, nested roots, decimals.")
@click.option("--draws", type=click.IntRange(min=1, max=100_000_000), default=100_000, show_default=True,
              help="So many draws are made at most.")  # fmt: skip
@click.option("--detail", type=click.Choice(DETAILS), default="full", show_default=True, help="How much is written.")
@PDF_ENGINE
@TEMPLATES
@LANGUAGE
@NOTATION
@executing
@AGAIN
@TIME_LIMIT
@click.option("--memory-limit", metavar="MB", type=click.IntRange(min=16, max=2**20), default=2048, show_default=True,
              help="For each member.")  # fmt: skip
@click.pass_context
def variants(  # noqa: PLR0913, PLR0917 - a parameter for each option of the command
    ctx: click.Context,
    problem: str,
    count: int,
    seed: int,
    formats: tuple[str, ...],
    output: str | None,
    check: bool,
    draws: int,
    detail: str,
    pdf_engine: str | None,
    templates: Path | None,
    language: str | None,
    notation: str | None,
    workers: Workers,
    again: bool,
    time_limit: float,
    memory_limit: int,
) -> None:
    """Draw members of the family that PROBLEM tells by its keys vary, require and nice; solve and verify each.

    They are written as problem files of their own, or as pages or data of their solutions. The exit code is 1 where
    there are fewer than asked for, and what rejected the others is told.
    """
    from solver.startup import quiet_threads

    quiet_threads()  # before numpy is imported
    from solver.cli.drawing import Order, draw_members
    from solver.document.model import Presentation
    from solver.limits import Limits

    told = Presentation(
        detail,
        templates,
        "json" in formats,
        language=known(language, templates, ctx),
        notation=notation,
        pdf_engine=pdf_engine,
    )
    limits = Limits(time_limit, memory_limit)
    ctx.exit(draw_members(Order(problem, count, seed, formats, output, told, limits, check, draws, workers, again)))
