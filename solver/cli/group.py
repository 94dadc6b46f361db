"""The group of commands, where a file in place of a command means: solve it."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import click
from click.shell_completion import CompletionItem

BROKEN_PIPE = 141  # as the shell has it: 128 + SIGPIPE
DEFAULT = "run"
ENDINGS = (".yaml", ".yml")
OWN_OPTIONS = ("-h", "--help", "--version", "--completion")


class FileOrCommand(click.Group):
    """`solve problem.yaml` is `solve run problem.yaml`; a word that is neither a command nor a file is an error."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Take options in first place as those of `run`: `solve -f json problem.yaml`."""
        if args and args[0].startswith("-") and args[0].partition("=")[0] not in OWN_OPTIONS:
            args = [DEFAULT, *args]
        return super().parse_args(ctx, args)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Return the command of that name, or `run` if the first word is a file."""
        if self.get_command(ctx, args[0]) is None:
            if looks_like_file(args[0]):
                args = [DEFAULT, *args]
            elif file := next((args[0] + each for each in ENDINGS if Path(args[0] + each).is_file()), ""):
                message = f"No such command {args[0]!r}. Did you mean {file}?"
                raise click.UsageError(message, ctx)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: click.Context) -> object:
        """Run the command. A reader that has seen enough, `head` say, ends it quietly."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            return stop_writing()

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem]:
        """Return the commands that begin like that; a file may stand in place of one."""
        return [*super().shell_complete(ctx, incomplete), CompletionItem(incomplete, type="file")]

    def list_commands(self, ctx: click.Context) -> list[str]:  # noqa: ARG002 - click's signature
        """Return the commands in the order they were added: the order of use."""
        return list(self.commands)


def stop_writing() -> int:
    """Send what is still to be written nowhere; return the exit code of a command whose reader is gone."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return BROKEN_PIPE


def looks_like_file(word: str) -> bool:
    """Whether a word means a file: by its ending, a separator, being "-", or because there is one of that name."""
    return word == "-" or word.lower().endswith(ENDINGS) or "/" in word or "\\" in word or Path(word).exists()
