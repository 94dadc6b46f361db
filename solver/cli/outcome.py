"""What became of a problem file: what is to be written and told. The same wherever it was made."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypeVar

import click

from solver.cli.bugs import BUG, words_of
from solver.cli.destination import STANDARD, AtFault, write_whole
from solver.document.formats import FORMATS
from solver.problem.source import InputError
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.model import Document, Presentation

SOLVED, UNSOLVED, INPUT_AT_FAULT = 0, 1, 2
Kind = TypeVar("Kind")


@dataclass(frozen=True, slots=True)
class Screen:
    """How wide standard output is, and which colours it has: None where it is no terminal."""

    width: int
    colours: str | None = None

    @classmethod
    def here(cls) -> Self:
        """Return that of this process."""
        from rich.console import Console

        from solver.render.terminal import WIDTH

        if not sys.stdout.isatty():
            return cls(WIDTH)
        console = Console()
        return cls(console.width, console.color_system)


@dataclass(frozen=True, slots=True)
class Asked:
    """What is asked of a file: where each format goes (none: to standard output), how it is told."""

    file: str
    formats: tuple[str, ...]
    paths: Mapping[str, Path]
    presentation: Presentation
    screen: Screen
    verbose: bool = False

    @property
    def name(self) -> str:
        """The name of the problem's file, "" for standard input."""
        return "" if self.file == STANDARD else Path(self.file).name


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a file: its exit code, what is told, and the contents of files by their paths.

    `wrote` has what is told once a path is written, of those that are worth it; what stands beside one follows it. The
    path "-" is standard output.
    """

    code: int
    out: str = ""
    err: str = ""
    files: Mapping[str, bytes] = field(default_factory=dict)
    wrote: Mapping[str, str] = field(default_factory=dict)

    def deliver(self, file: str) -> tuple[Outcome, list[Path]]:
        """Write the files; return what is told of that and the exit code, without them, and the paths written."""
        code, err, told, written = self.code, self.err, list[str](), list[Path]()
        failed = False
        for path, content in self.files.items():
            if path == STANDARD:
                sys.stdout.buffer.write(content)
                sys.stdout.flush()
                continue
            if failed and path not in self.wrote:
                continue
            try:
                write_whole(Path(path), content)
            except AtFault as fault:
                failed, code = True, max(code, fault.exit_code)
                err += f"{file}: error: {fault.format_message()}\n"
                continue
            failed = False
            if path in self.wrote:
                told.append(self.wrote[path] + "\n")
                written.append(Path(path))
        return Outcome(code, self.out + "".join(told), err), written

    def tell(self) -> int:
        """Tell what there is to tell; return the exit code."""
        if self.err:
            click.echo(self.err, nl=False, err=True)
        if self.out:
            click.echo(self.out, nl=False)
        return self.code


def guarded(file: str, make: Callable[[], Kind], *, bugs: bool = True) -> Kind | Outcome:
    """Return what is made; whatever goes wrong becomes words and an exit code: `bugs` of the program, or they pass."""
    try:
        return make()
    except InputError as error:
        return Outcome(INPUT_AT_FAULT, err=error.render() + "\n")
    except click.ClickException as error:
        return Outcome(error.exit_code, err=f"{file}: error: {error.format_message()}\n")
    except BrokenPipeError:
        raise  # it concerns all files
    except Exception as bug:  # the boundary of a file: a bug in one must not stop the rest
        if not bugs:
            raise
        return Outcome(BUG, err=words_of(bug, file) + "\n")


def outcome_of(document: Document, asked: Asked) -> Outcome:
    """Return what is written and told of a solution; raises AtFault."""
    for fault in dict.fromkeys(part.fault for part in document.parts if part.fault):
        if asked.presentation.templates is not None:  # a fault of ours leaves the part unsolved
            raise AtFault(f"cannot make the solution: {fault}")
    if not asked.paths:
        content = rendered(document, asked.formats[0])
        return Outcome(_code(document), err=_what_is_wrong(document), files={STANDARD: content})
    files, wrote, err, code = dict[str, bytes](), dict[str, str](), "", _code(document)
    for format_, path in asked.paths.items():
        try:
            files[str(path)] = rendered(document, format_)
        except AtFault as fault:
            err += f"{asked.file}: error: {fault.format_message()}\n"
            code = max(code, fault.exit_code)
            continue
        wrote[str(path)] = document.messages.say(Phrase("wrote {path}", path=path))
        for name, content in FORMATS[format_].beside(document).items():
            files[str(path.with_name(name))] = content
    return Outcome(code, _summary(document, asked), err, files, wrote)


def rendered(document: Document, format_: str) -> bytes:
    """Return the solution in a format; raises AtFault."""
    with in_words(format_):
        return document.rendered(format_)


@contextmanager
def in_words(what: str) -> Iterator[None]:
    """Turn a fault of templates or of TeX into an error in words: it lies outside of the program."""
    from jinja2 import TemplateError

    from solver.render.pdf import PdfUnavailable

    try:
        yield
    except (PdfUnavailable, TemplateError) as error:
        raise AtFault(f"cannot make {what}: {error}") from error


def _code(document: Document) -> int:
    from solver.derivation import Status

    return SOLVED if document.status is Status.VERIFIED else UNSOLVED


def _what_is_wrong(document: Document) -> str:
    """Return which parts are not verified, and why."""
    from solver.derivation import Status
    from solver.render.prose import inline_as_text

    say, lines = document.messages.say, []
    for part in document.parts:
        if part.status is not Status.VERIFIED:
            head = say(Phrase("part {id} ({method})", id=part.id, method=part.method))
            lines.append(f"{head}: {say(part.status)}: {inline_as_text(part.reason)}\n")
    return "".join(lines)


def _summary(document: Document, asked: Asked) -> str:
    from rich.console import Console

    from solver.render.terminal import print_summary

    file, screen = io.StringIO(), asked.screen
    coloured = bool(screen.colours)
    colours: Any = screen.colours if coloured else "auto"
    console = Console(file=file, highlight=False, width=screen.width, force_terminal=coloured, color_system=colours)
    print_summary(document, console, verbose=asked.verbose)
    return file.getvalue()
