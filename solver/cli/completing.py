"""What a shell completes: files, folders, tasks, models, formats. Imports no algebra.

`solve --completion bash` prints the script that has the shell ask for it; the rest is click's own.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TypeVar

import click
from click.shell_completion import CompletionItem, get_completion_class

import solver

Kind = TypeVar("Kind")

SHELLS = ("bash", "zsh", "fish")
VARIABLE = "_SOLVE_COMPLETE"
FILES = ("files", "problem", "exam", "table", "report", "changes")
"""Parameters that are files, by name; those with one of the `metavar`s below are files or folders too."""

KINDS = {"FILE": "file", "PATH": "file", "FOLDER": "dir", "DIR": "dir"}
NAMES = {("tasks", "name"): "tasks", ("models", "name"): "models", ("new", "task"): "new"}
"""Parameters that are names, by command and name."""


class Completed(click.ParamType[Kind]):
    """A type of parameters that says itself how a word may go on."""

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> list[CompletionItem]:  # noqa: ARG002 - click's signature
        """Return how a word may go on, whatever stands beside it."""
        return self.completed(incomplete)

    def completed(self, incomplete: str) -> list[CompletionItem]:
        """Return how a word may go on."""
        raise NotImplementedError


class Files(Completed[str], click.types.StringParamType):
    """A text that names a file, or with kind "dir" a folder."""

    def __init__(self, kind: str = "file") -> None:
        self.kind = kind

    def completed(self, incomplete: str) -> list[CompletionItem]:
        """Leave it to the shell."""
        return [CompletionItem(incomplete, type=self.kind)]


class Named(Completed[str], click.types.StringParamType):
    """A text that is one of the names of a list."""

    def __init__(self, kind: str) -> None:
        self.kind = kind

    def completed(self, incomplete: str) -> list[CompletionItem]:
        """Return the names that begin like that."""
        return [CompletionItem(name) for name in _names(self.kind) if name.startswith(incomplete)]


def _names(kind: str) -> Iterator[str]:
    """Yield names of tasks, of models, or of what can be begun anew."""
    if kind == "models":
        from solver.problem.library import model_names

        yield from model_names()
        return
    if kind == "new":
        from solver.cli.beginnings import BEGINNINGS

        yield from BEGINNINGS
    yield from _tasks()


def _tasks() -> Iterator[str]:
    """Yield the names of tasks, each that of its file: the catalogue, which knows more, takes five times as long."""
    for path in Path(solver.__file__).parent.glob("tasks/*/*.py"):
        if re.search(rf"^{path.stem}\b.* = Task\(", path.read_text(encoding="utf-8"), re.MULTILINE):
            yield path.stem


def listed(incomplete: str, known: Iterable[str]) -> list[CompletionItem]:
    """Return how a list with commas may go on by one of the names known."""
    before, comma, last = incomplete.rpartition(",")
    given = before.split(",")
    return [CompletionItem(before + comma + each) for each in known if each.startswith(last) and each not in given]


def make_complete(commands: Iterable[click.Command]) -> None:
    """Say of the parameters of commands what completes them, where their type does not."""
    for command in commands:
        for each in command.params:
            kind = KINDS.get(str(each.metavar or "").strip(".")) or ("file" if each.name in FILES else "")
            if type(each.type) is not click.types.StringParamType:
                continue
            if (found := NAMES.get((command.name or "", each.name or ""))) is not None:
                each.type = Named(found)
            elif kind:
                each.type = Files(kind)


def tell_completion(ctx: click.Context, param: click.Parameter, shell: str | None) -> None:  # noqa: ARG001 - click's
    """Print the script of a shell, and end."""
    if shell is None or ctx.resilient_parsing:
        return
    found = get_completion_class(shell)
    if found is None:  # click knows each of those that can be chosen
        raise click.UsageError(f"there is no completion for {shell}")
    root = ctx.find_root()
    click.echo(found(root.command, {}, "solve", VARIABLE).source())
    ctx.exit()
