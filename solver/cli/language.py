"""The options that say in which language and with which symbols a solution or a sheet is told."""

from __future__ import annotations

from pathlib import Path

import click

from solver.symbols import NOTATIONS

LANGUAGE = click.option(
    "--language", metavar="NAME", help="The language of what is written: en, de. Default: what the problem says, or en."
)
NOTATION = click.option(
    "--notation", type=click.Choice(tuple(NOTATIONS)), help="Its symbols. Default: what the problem says, or course."
)


def known(language: str | None, templates: Path | None, ctx: click.Context) -> str | None:
    """Return the language, None if none is named; fails with the nearest name for one that there is not."""
    from solver.problem.source import did_you_mean
    from solver.words import languages

    there = languages(templates)
    if language is not None and language not in there:
        suggestion = did_you_mean(language, there)
        hint = f" (did you mean '{suggestion}'?)" if suggestion else f"; there are {', '.join(there)}"
        raise click.BadParameter(f"there is no language '{language}'{hint}", ctx, param_hint="--language")
    return language
