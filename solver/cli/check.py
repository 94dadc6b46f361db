"""`solve check problem.yaml answers.yaml`: the options. The work is in `checking`, imported when it is wanted."""

from __future__ import annotations

from pathlib import Path

import click

from solver.cli.executing import Workers, executing
from solver.cli.language import LANGUAGE, NOTATION, known
from solver.cli.run import AGAIN, DETAILS, Seconds
from solver.problem.model import RULES

FORMATS = ("text", "json", "html")


@click.command(short_help="Mark students' answers to a problem.")
@click.argument("files", nargs=-1, required=True, metavar="[PROBLEM|EXAM] ANSWERS...")
@click.option("-f", "--format", "format_", type=click.Choice(FORMATS), help="text (on the terminal), json, or html: "
              "a sheet to hand back.")  # fmt: skip
@click.option("-o", "--output", metavar="PATH", help="A file, a folder, or - for standard output. Default: "
              "sheets beside the answers, text and json on standard output.")  # fmt: skip
@click.option("--csv", "table", metavar="FILE", help="Also write a table of marks, one line for each answer file.")
@click.option("--report", metavar="FILE", help="Also write what the marks of an exam say: a page with their spread, "
              "how hard each question was, and the mistakes made most.")  # fmt: skip
@click.option("--partial", type=click.Choice(RULES), help="What wrong answers earn, whatever the problem says: in "
              "proportion to right entries, nothing, or what named mistakes leave.")  # fmt: skip
@click.option("--answers", "key", is_flag=True, help="Show the right values on the sheet.")
@click.option("--override", "changes", metavar="FILE", help="An instructor's verdicts, marks and comments, which win.")
@click.option("--syntax", is_flag=True, help="Only say how each value is read: no verdicts, no marks.")
@click.option("--solution", is_flag=True, help="Show the worked solution below the sheet.")
@click.option("--detail", type=click.Choice(DETAILS), default="full", show_default=True, help="How much of it.")
@click.option("--templates", metavar="DIR", type=click.Path(exists=True, file_okay=False, path_type=Path),
              help="Templates that take precedence over the program's own.")  # fmt: skip
@LANGUAGE
@NOTATION
@click.option("--time-limit", metavar="SECONDS", type=Seconds(), default=60,
              show_default=True, help="For each part, solved or marked.")  # fmt: skip
@click.option("--memory-limit", metavar="MB", type=click.IntRange(min=16, max=2**20), default=2048, show_default=True,
              help="For each part, solved or marked.")  # fmt: skip
@executing
@AGAIN
@click.pass_context
def check(  # noqa: PLR0913, PLR0917 - a parameter for each option of the command
    ctx: click.Context,
    files: tuple[str, ...],
    format_: str | None,
    output: str | None,
    table: str | None,
    report: str | None,
    partial: str | None,
    key: bool,
    changes: str | None,
    syntax: bool,
    solution: bool,
    detail: str,
    templates: Path | None,
    language: str | None,
    notation: str | None,
    time_limit: float,
    memory_limit: int,
    workers: Workers,
    again: bool,
) -> None:
    """Mark each file of ANSWERS, of a folder or of a pattern, by what PROBLEM asks, not by likeness to a key.

    Without PROBLEM the answer file names it by the key 'problem'. One bad file does not stop the rest. Answers to an
    exam are marked against the variant of each student, with the marks of the exam. Called again with other answers,
    only what changed is marked.
    """
    if syntax and (output or table or changes or format_ == "html"):
        raise click.UsageError("--syntax prints text or, with -f json, data; it goes with no -o, --csv and --override.")
    from solver.cli.checking import check_files
    from solver.cli.papers import CheckRequest
    from solver.document.model import Presentation
    from solver.limits import Limits

    told = Presentation(detail, templates, language=known(language, templates, ctx), notation=notation)
    limits = Limits(time_limit, memory_limit)
    rules = partial, key, syntax, changes, workers, report, again
    marked = CheckRequest(files, format_, output, table, solution, told, limits, *rules)
    ctx.exit(check_files(marked))
