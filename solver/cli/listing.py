"""`solve tasks`, `solve new`, `solve schema`: what can be asked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from solver.derivation import Task


@click.command(short_help="List what can be asked, or all about one task.")
@click.argument("name", required=False)
def tasks(name: str | None) -> None:
    """List the catalogue of tasks; with NAME: its methods, options and answers."""
    if name:
        from solver.cli.catalogue_text import one

        text = one(_found(name))
    else:
        from solver.cli.overview import overview

        text = overview()
    click.echo(text)


@click.command(short_help="Write a commented problem file to start from.")
@click.argument("task")
@click.option("-o", "--output", metavar="FILE", help="Where to write it. Default: standard output.")
def new(task: str, output: str | None) -> None:
    """Write a problem file that asks TASK, with every option explained."""
    from pathlib import Path

    from solver.cli.destination import write_whole
    from solver.problem.template import new_problem

    text = new_problem(_found(task))
    if output in (None, "-"):
        click.echo(text, nl=False)
    elif Path(output).exists():
        raise click.UsageError(f"{output} exists already; it will not be overwritten.")
    else:
        write_whole(Path(output), text.encode())
        click.echo(f"wrote {output}; solve it with: solve {output}")


@click.command(short_help="Print the JSON Schema of problem files.")
def schema() -> None:
    """Print the JSON Schema of problem files, for editors that complete and check YAML."""
    import json

    from solver.problem.schema import json_schema
    from solver.tasks import catalogue

    click.echo(json.dumps(json_schema(catalogue()), indent=2, ensure_ascii=False))


def _found(name: str) -> Task[Any, Any]:
    """Return the task of that name; raises click.UsageError with the nearest name."""
    from solver.problem.source import did_you_mean
    from solver.tasks import catalogue

    known = catalogue()
    if name in known:
        return known[name]
    close = did_you_mean(name, known) or next((each for each in known if name.lower() in each), "")
    hint = f" Did you mean '{close}'?" if close else " `solve tasks` lists them."
    raise click.UsageError(f"there is no task '{name}'.{hint}")
