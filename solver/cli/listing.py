"""`solve tasks`, `solve models`, `solve new`, `solve schema`: what can be asked, and of what."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from collections.abc import Collection

    from solver.derivation import Task
    from solver.problem.model import Problem


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


@click.command(short_help="List the library of models, or all about one of them.")
@click.argument("name", required=False)
def models(name: str | None) -> None:
    """List the models that a problem can take as its system, `system: {model: NAME}`; with NAME: all about it."""
    from solver.cli.models_text import all_models, one_model
    from solver.problem.library import library_model, model_names

    if name and name not in model_names():
        raise click.UsageError(f"there is no model '{name}'.{_hint(name, model_names(), 'models')}")
    click.echo(one_model(library_model(name)) if name else all_models())


@click.command(short_help="Write a commented file to start from: a problem, a family, an exam.")
@click.argument("task")
@click.option("-o", "--output", metavar="FILE", help="Where to write it. Default: standard output.")
def new(task: str, output: str | None) -> None:
    """Write a problem file that asks TASK, with every option explained.

    `solve new exam` writes an exam, `solve new family` a problem with many sets of numbers; both run as they stand.
    """
    from pathlib import Path

    from solver.cli.beginnings import BEGINNINGS
    from solver.cli.destination import write_whole
    from solver.problem.template import new_problem

    begun = BEGINNINGS.get(task)
    text, what_next = begun or (new_problem(_found(task, BEGINNINGS)), "solve it with: solve {file}")
    if output in (None, "-"):
        click.echo(text, nl=False)
    elif Path(output).exists():
        raise click.UsageError(f"{output} exists already; it will not be overwritten.")
    else:
        write_whole(Path(output), text.encode())
        click.echo(f"wrote {output}; {what_next.format(file=output)}")


@click.command(short_help="Print the JSON Schema of problem files, answer files or changes.")
@click.argument("problem", required=False)
@click.option("--answers", is_flag=True, help="Of answer files; of those to PROBLEM, with its parts and answers.")
@click.option("--override", "changes", is_flag=True, help="Of an instructor's changes, for `solve check --override`.")
def schema(problem: str | None, answers: bool, changes: bool) -> None:
    """Print the JSON Schema of problem files, for editors that complete and check YAML."""
    if changes and (answers or problem):
        raise click.UsageError("--override is a schema of its own; it goes with nothing else.")
    if problem and not answers:
        raise click.UsageError("PROBLEM goes with --answers.")
    click.echo(json.dumps(_schema(problem, answers, changes), indent=2, ensure_ascii=False))


def _schema(problem: str | None, answers: bool, changes: bool) -> dict[str, Any]:
    from solver.problem.schema import json_schema
    from solver.tasks import catalogue

    if not (answers or changes):
        return json_schema(catalogue())
    from solver.classroom.schema import answers_schema, changes_schema

    return changes_schema() if changes else answers_schema(_read(problem) if problem else None)


def _read(file: str) -> Problem:
    """Return a problem; what is wrong with it ends the command, in words."""
    from solver.cli.destination import AtFault
    from solver.cli.solving import source_of
    from solver.problem.reader import read_problem
    from solver.problem.source import InputError
    from solver.tasks import catalogue

    try:
        return read_problem(source_of(file), catalogue())
    except InputError as error:
        raise AtFault(error.render()) from None


def _found(name: str, others: Collection[str] = ()) -> Task[Any, Any]:
    """Return the task of that name; raises click.UsageError with the nearest name, one of the others too."""
    from solver.tasks import catalogue

    known = catalogue()
    if name in known:
        return known[name]
    raise click.UsageError(f"there is no task '{name}'.{_hint(name, (*known, *others), 'tasks')}")


def _hint(name: str, known: Collection[str], command: str) -> str:
    """Return the nearest name as a question, or the command that lists them."""
    from solver.problem.source import did_you_mean

    close = did_you_mean(name, known) or next((each for each in known if name.lower() in each), "")
    return f" Did you mean '{close}'?" if close else f" `solve {command}` lists them."
