"""`solve exam exam.yaml`: the options. The work is in `examining`, imported when it is wanted."""

from __future__ import annotations

from pathlib import Path

import click
from click.core import ParameterSource

from solver.cli.executing import Workers, executing
from solver.cli.language import LANGUAGE, NOTATION, known
from solver.cli.run import AGAIN, DETAILS, PDF_ENGINE, TEMPLATES, TIME_LIMIT, FormatList

FORMATS = ("html", "pdf", "latex")
EXPORTS = ("moodle", "qti", "canvas")


class ExamFormatList(FormatList):
    """Some of the formats of papers, separated by commas."""

    def __init__(self) -> None:
        super().__init__()
        self.known = FORMATS


class ExportList(FormatList):
    """Some of the learning systems that an exam can be exported to, separated by commas."""

    def __init__(self) -> None:
        super().__init__()
        self.known = EXPORTS


@click.command(short_help="Write the papers, keys and answer files of an exam.")
@click.argument("exam")
@click.option("-f", "--format", "formats", type=ExamFormatList(), default="html", show_default=True,
              help="html, pdf, latex: one or more.")  # fmt: skip
@click.option("-o", "--output", metavar="FOLDER", help="Where they are written. Default: EXAM-papers beside EXAM.")
@click.option("--export", "exports", type=ExportList(),
              help="moodle, qti, canvas: in place of papers a file for each that such a system imports.")  # fmt: skip
@click.option("--detail", type=click.Choice(DETAILS[1:]), default="key", show_default="key; full in exports",
              help="How much the key tells, or the feedback of an export; full has the worked steps.")  # fmt: skip
@click.option("--draws", type=click.IntRange(min=1, max=100_000_000), default=100_000, show_default=True,
              help="So many draws are made at most for a family.")  # fmt: skip
@click.option("--space", metavar="MM", type=click.FloatRange(0, 100),
              help="Leave so many millimetres blank for each mark of a part, at least 20 for each part.")  # fmt: skip
@PDF_ENGINE
@TEMPLATES
@LANGUAGE
@NOTATION
@executing
@AGAIN
@TIME_LIMIT
@click.option("--memory-limit", metavar="MB", type=click.IntRange(min=16, max=2**20), default=2048, show_default=True,
              help="For each question.")  # fmt: skip
@click.pass_context
def exam(  # noqa: PLR0913, PLR0917 - a parameter for each option of the command
    ctx: click.Context,
    exam: str,
    formats: tuple[str, ...],
    output: str | None,
    exports: tuple[str, ...] | None,
    detail: str,
    draws: int,
    space: float | None,
    pdf_engine: str | None,
    templates: Path | None,
    language: str | None,
    notation: str | None,
    workers: Workers,
    again: bool,
    time_limit: float,
    memory_limit: int,
) -> None:
    """Write the papers of EXAM without answers, the keys with marks, and a file for each student to fill in.

    There is one of each for a variant or a student; `variants.csv` tells who has which, with the values drawn. Where
    a question tells a family it has other numbers in each. Nothing is written unless all is solved and verified.
    With --export the questions are written as a bank for a learning system, and nothing else is.
    """
    from solver.startup import quiet_threads

    quiet_threads()  # before numpy is imported
    from solver.cli.examining import Order, write_exam
    from solver.document.model import Presentation
    from solver.limits import Limits

    chosen = {name for name in ("formats", "detail") if ctx.get_parameter_source(name) is not ParameterSource.DEFAULT}
    if exports and "formats" in chosen:
        raise click.UsageError("--export writes no papers, so -f means nothing beside it.")
    if exports and "detail" not in chosen:
        detail = "full"
    spoken = known(language, templates, ctx)
    told = Presentation(detail, templates, language=spoken, notation=notation, pdf_engine=pdf_engine)
    limits = Limits(time_limit, memory_limit)
    order = Order(exam, formats, output, told, limits, draws, workers, space, exports or (), again)
    ctx.exit(write_exam(order))
