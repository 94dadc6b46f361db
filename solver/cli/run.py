"""`solve problem.yaml`: the options. The work is in `solving`, imported when it is wanted."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import click
from click.shell_completion import CompletionItem

from solver.cli.completing import Completed, listed
from solver.cli.executing import Workers, executing
from solver.cli.language import LANGUAGE, NOTATION, known
from solver.document.formats import FORMATS

DETAILS = ("question", "key", "brief", "full", "tutor")
CHECKS = ("none", "summary", "table")
PDF_ENGINE = click.option("--pdf-engine", type=click.Choice(["tex", "typst"]),
                          help="What makes a PDF. Default: TeX where it is installed, else typst.")  # fmt: skip
TEMPLATES = click.option("--templates", metavar="DIR",
                         type=click.Path(exists=True, file_okay=False, resolve_path=True, path_type=Path),
                         help="Templates that take precedence over the program's own.")  # fmt: skip

AGAIN = click.option("--again", is_flag=True, help="Make all again, also what is there and unchanged.")


class FormatList(Completed[tuple[str, ...]]):
    """Some of the output formats, separated by commas; `others` are names that stand beside those of a solution."""

    name = "formats"

    def __init__(self, *others: str) -> None:
        self.known = (*others, *FORMATS)

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> tuple[str, ...]:
        """Return the formats named, each once; fails with the nearest name for an unknown one."""
        words = list(dict.fromkeys(word.strip().lower() for word in value.split(",") if word.strip()))
        for word in words:
            if word not in self.known:
                from difflib import get_close_matches

                close = get_close_matches(word, self.known, n=1)
                hint = f" Did you mean {close[0]}?" if close else ""
                self.fail(f"no format {word!r}; there are {', '.join(self.known)}.{hint}", param, ctx)
        if not words:
            self.fail(f"no format named; there are {', '.join(self.known)}", param, ctx)
        return tuple(words)

    def completed(self, incomplete: str) -> list[CompletionItem]:
        """Return how the list may go on."""
        return listed(incomplete, self.known)


class Seconds(click.FloatRange):
    """A time of up to a day."""

    name = "seconds"

    def __init__(self) -> None:
        super().__init__(min=0, min_open=True, max=86400)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        """Return the number; fails outside of the range, and for nan, which a range lets through."""
        number = float(super().convert(value, param, ctx))
        if math.isnan(number):
            self.fail("nan is not a time", param, ctx)
        return number


TIME_LIMIT = click.option("--time-limit", metavar="SECONDS", type=Seconds(), default=60, show_default=True,
                          help="For each part by each method.")  # fmt: skip


@click.command(short_help="Solve problem files (what `solve problem.yaml` does).")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@click.option("-f", "--format", "formats", type=FormatList(), help="html, latex, pdf, md, json, text: one or more.")
@click.option(
    "-o", "--output", metavar="PATH", help="A file, a folder, or - for standard output. Default: beside FILE."
)
@click.option("--detail", type=click.Choice(DETAILS), default="full", show_default=True, help="How much is written.")
@click.option("--checks", type=click.Choice(CHECKS), help="How checks are told. Default: none in a question or a key, "
              "else a summary.")  # fmt: skip
@PDF_ENGINE
@click.option("--no-sources", is_flag=True, help="Do not name the literature.")
@TEMPLATES
@LANGUAGE
@NOTATION
@click.option("--open", "open_page", is_flag=True, help="Open the page in a browser.")
@click.option("--watch", is_flag=True, help="Go on: write again whenever a FILE changes, and let the open page reload.")
@click.option("--port", type=click.IntRange(min=1, max=65535), help="Of the pages that --watch shows. Default: any.")
@TIME_LIMIT
@click.option("--memory-limit", metavar="MB", type=click.IntRange(min=16, max=2**20), default=2048, show_default=True,
              help="For each part by each method.")  # fmt: skip
@executing
@AGAIN
@click.option("-v", "--verbose", is_flag=True, help="List every check.")
@click.pass_context
def run(  # noqa: PLR0913, PLR0917 - a parameter for each option of the command
    ctx: click.Context,
    files: tuple[str, ...],
    formats: tuple[str, ...] | None,
    output: str | None,
    detail: str,
    checks: str | None,
    pdf_engine: str | None,
    no_sources: bool,
    templates: Path | None,
    language: str | None,
    notation: str | None,
    open_page: bool,
    watch: bool,
    port: int | None,
    time_limit: float,
    memory_limit: int,
    again: bool,
    verbose: bool,
    workers: Workers,
) -> None:
    """Solve each FILE and write the worked solution, beside the file unless -o says where.

    FILE may be a folder, a pattern ('ch1/*.yaml', '**/*.yaml') or - for standard input. One bad file does not stop the
    rest; the worst exit code is returned.
    """
    from solver.cli.destination import Destination
    from solver.cli.inputs import problems_in, tell
    from solver.cli.solving import Request, solve_files
    from solver.document.model import Presentation

    inputs = problems_in(files)
    code = tell(inputs)
    destination = Destination.named(output, formats, inputs.files, several=inputs.several)
    _refuse_to_watch(inputs.files, standard_output=destination.standard_output, port=port, watch=watch)
    told = ("json" in destination.formats, checks or "", not no_sources, known(language, templates, ctx), notation)
    presentation = Presentation(detail, templates, *told, pdf_engine=pdf_engine)
    limits = time_limit, memory_limit
    several = inputs.several
    request = Request(inputs.files, destination, presentation, open_page, *limits, verbose, workers, several, again)
    if watch:
        from solver.cli.watching import watch_problems

        ctx.exit(watch_problems(request, port or 0) if inputs.files else code)
    ctx.exit(max(code, solve_files(request)) if inputs.files else code)


def _refuse_to_watch(files: tuple[str, ...], *, standard_output: bool, port: int | None, watch: bool) -> None:
    """Raise click.UsageError where there is nothing that --watch could look at or write."""
    if not watch:
        if port is not None:
            raise click.UsageError("--port is that of the pages of --watch.")
        return
    if "-" in files or standard_output:
        raise click.UsageError("--watch looks at files and writes files: name a FILE, and with -o a file or a folder.")
