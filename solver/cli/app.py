"""The command line's entry: commands, and the boundary at which every error becomes words and an exit code."""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence

import click

from solver import __version__
from solver.cli.bugs import report_bug
from solver.cli.check import check
from solver.cli.completing import SHELLS, make_complete, tell_completion
from solver.cli.exam import exam
from solver.cli.group import FileOrCommand, stop_writing
from solver.cli.listing import models, new, schema, tasks
from solver.cli.run import run
from solver.cli.sheet import sheet
from solver.cli.variants import variants

INTERRUPTED = 130

EPILOG = """\b
Exit codes:
  0  every part is solved and every check passed
  1  a part could not be solved, a check failed, or (check) an answer is wrong,
     or with --syntax not read
  2  the input is at fault
"""


@click.group(cls=FileOrCommand, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="solve")
@click.option("--completion", type=click.Choice(SHELLS), expose_value=False, is_eager=True, callback=tell_completion,
              help="Print the script that completes words of a command in a shell.")  # fmt: skip
def cli() -> None:
    """Solve control-engineering problems step by step, and check every step.

    `solve problem.yaml` writes the worked solution beside the file (see `solve run --help` for the options).
    """


for command in (run, check, sheet, variants, exam, tasks, models, new, schema):
    cli.add_command(command)
make_complete(cli.commands.values())


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit code. No error ever leaves as a traceback."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a terminal without Unicode shows ? instead of nothing
    try:
        result = cli.main(args=arguments, prog_name="solve", standalone_mode=False)
        sys.stdout.flush()
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        click.echo("interrupted", err=True)
        return INTERRUPTED
    except BrokenPipeError:
        return stop_writing()
    except Exception as bug:  # noqa: BLE001 - the outermost boundary: whatever is left is a bug of the program
        return report_bug(bug)
    return result if isinstance(result, int) else 0
