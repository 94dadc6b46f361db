"""What a shell completes: files, folders, tasks, models, formats. Imports no algebra.

`solve --completion bash` prints the script that has the shell ask for it; the rest is click's own.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import click
from click.shell_completion import CompletionItem, get_completion_class

SHELLS = ("bash", "zsh", "fish")
VARIABLE = "_SOLVE_COMPLETE"
FILES = ("files", "problem", "exam", "table", "report", "changes")
"""Parameters that are files, by name; those with one of the `metavar`s below are files or folders too."""

KINDS = {"FILE": "file", "PATH": "file", "FOLDER": "dir", "DIR": "dir"}
NAMES = {("tasks", "name"): "tasks", ("models", "name"): "models", ("new", "task"): "new"}
"""Parameters that are names, by command and name."""


class Files(click.types.StringParamType):
    """A text that names a file, or with kind "dir" a folder."""

    def __init__(self, kind: str = "file") -> None:
        self.kind = kind

    def shell_complete(
        self,
        ctx: click.Context,  # noqa: ARG002 - click's signature
        param: click.Parameter,  # noqa: ARG002 - as above
        incomplete: str,
    ) -> list[CompletionItem]:
        """Leave it to the shell."""
        return [CompletionItem(incomplete, type=self.kind)]


class Named(click.types.StringParamType):
    """A text that is one of the names of a list."""

    def __init__(self, kind: str) -> None:
        self.kind = kind

    def shell_complete(
        self,
        ctx: click.Context,  # noqa: ARG002 - click's signature
        param: click.Parameter,  # noqa: ARG002 - as above
        incomplete: str,
    ) -> list[CompletionItem]:
        """Return the names that begin like that."""
        return [CompletionItem(name) for name in _names(self.kind) if name.startswith(incomplete)]


def _names(kind: str) -> Iterator[str]:
    """Yield names of tasks, of models, or of what can be begun anew."""
    if kind == "models":
        from solver.problem.library import model_names

        yield from model_names()
        return
    from solver.tasks import catalogue

    if kind == "new":
        from solver.cli.beginnings import BEGINNINGS

        yield from BEGINNINGS
    yield from catalogue()


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
