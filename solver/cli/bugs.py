"""What is said when the program itself is at fault."""

from __future__ import annotations

import os
import traceback

import click


def report_bug(bug: Exception, file: str = "") -> int:
    """Say that there is a bug, with its traceback if SOLVE_DEBUG is set; return the exit code."""
    place = f"{file}: " if file else ""
    click.echo(f"{place}internal error: {type(bug).__name__}: {bug}", err=True)
    if os.environ.get("SOLVE_DEBUG"):
        traceback.print_exception(bug)
    else:
        click.echo(
            "This is a bug in solve; please report it with the output of the same command under SOLVE_DEBUG=1.",
            err=True,
        )
    return 1
