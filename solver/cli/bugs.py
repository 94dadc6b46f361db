"""What is said when the program itself is at fault."""

from __future__ import annotations

import os
import traceback

import click

BUG = 1
"""The exit code."""


def report_bug(bug: Exception, file: str = "") -> int:
    """Say that there is a bug, with its traceback if SOLVE_DEBUG is set; return the exit code."""
    click.echo(words_of(bug, file), err=True)
    return BUG


def words_of(bug: Exception, file: str = "") -> str:
    """Return what is said of a bug."""
    place = f"{file}: " if file else ""
    head = f"{place}internal error: {type(bug).__name__}: {bug}"
    if os.environ.get("SOLVE_DEBUG"):
        return head + "\n" + "".join(traceback.format_exception(bug)).rstrip()
    return head + "\nThis is a bug in solve; please report it with the output of the same command under SOLVE_DEBUG=1."
