"""The work of `solve problem.yaml`: read, solve within limits, write, report; one file after the other."""

from __future__ import annotations

import io
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, TextIO

import click

from solver.cli.bugs import report_bug
from solver.cli.destination import STANDARD, AtFault, Destination, write_whole
from solver.cli.progress import Meter
from solver.document.formats import FORMATS
from solver.problem.source import Diagnostic, InputError, Source
from solver.startup import begin_loading, end_loading, quiet_threads
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.document.model import Document, Presentation
    from solver.problem.model import Problem

SOLVED, UNSOLVED, INPUT_AT_FAULT = 0, 1, 2


@dataclass(frozen=True, slots=True)
class Request:
    """What the command line asks for."""

    files: tuple[str, ...]
    destination: Destination
    presentation: Presentation
    open_page: bool
    time_limit: float
    memory_limit: int
    verbose: bool


def solve_files(request: Request) -> int:
    """Solve each file; return the worst exit code. What is wrong with one file does not stop the others."""
    settle()
    if len(request.files) > 1:
        from solver.limits.child import load_all_algebra

        load_all_algebra()  # once, and not in the child of each file
    meter = Meter(len(request.files))
    return max(_guarded(request, file, meter) for file in request.files)


def settle() -> None:
    """Set this process up for solving: one thread, little garbage collection, an orderly end."""
    quiet_threads()
    _end_orderly()


def _end_orderly() -> None:
    """Make SIGTERM and SIGHUP end this process by an exit, so that the child is ended too."""

    def end(number: int, frame: FrameType | None) -> None:  # noqa: ARG001 - the signature of a handler
        raise SystemExit(128 + number)

    for name in ("SIGTERM", "SIGHUP"):
        if hasattr(signal, name) and threading.current_thread() is threading.main_thread():
            signal.signal(getattr(signal, name), end)


def written_of(request: Request, file: str) -> tuple[int, list[Path]]:
    """Solve one file; return the exit code and the files written, none where the file is at fault."""
    code = _guarded(request, file, Meter(1))
    return code, [] if code == INPUT_AT_FAULT else list(request.destination.paths(file).values())


def _guarded(request: Request, file: str, meter: Meter) -> int:
    """Solve one file; whatever goes wrong becomes words on standard error and an exit code."""
    try:
        return _solve(request, file, meter)
    except InputError as error:
        click.echo(error.render(), err=True)
        return INPUT_AT_FAULT
    except click.ClickException as error:
        click.echo(f"{file}: error: {error.format_message()}", err=True)
        return error.exit_code
    except BrokenPipeError:
        raise  # it concerns all files
    except Exception as bug:  # noqa: BLE001 - the boundary of a file: a bug in one must not stop the rest
        return report_bug(bug, file)
    finally:
        end_loading()
        meter.next_file()


def _solve(request: Request, file: str, meter: Meter) -> int:
    is_first = begin_loading()  # until `_rehearse` has loaded all, and the child
    import sympy.tensor.tensor  # noqa: F401 - here, so that the child has it too; the first sum needs the tensors

    from solver.limits import Child, Limits, Supervision, solve_within

    limits = Limits(request.time_limit, request.memory_limit)
    with Child() as child:  # it loads the algebra while the problem is being read
        from solver.problem.reader import read_problem
        from solver.tasks import catalogue

        problem = read_problem(source_of(file), catalogue())
        with meter.file(file) as notify:
            rehearsal = partial(_rehearse, request, problem) if is_first else None
            supervision = Supervision(notify, rehearsal, child)
            solved = solve_within(problem, limits, request.presentation, supervision)
    return _deliver(request, file, solved.document("" if file == STANDARD else Path(file).name))


def _rehearse(request: Request, problem: Problem) -> None:
    """Load what writes the solution, while the child solves: write one whose first part is not solved.

    What is loaded then stays, and garbage is collected without looking at it.
    """
    from solver.derivation import PartResult, Status
    from solver.document.works import document_of
    from solver.engine import Solution

    first = problem.parts[0]
    unsolved = PartResult(first.id, first.task, first.methods[0], Status.UNSOLVED)
    with suppress(AtFault):  # of what is wrong with templates it will be told with the solution itself
        document = document_of(Solution(problem, (unsolved,)), request.presentation)
        for format_ in request.destination.formats:
            if format_ != "pdf":
                _rendered(document, format_)
        if not request.destination.standard_output:
            _print_summary(document, [], file=io.StringIO(), verbose=request.verbose)
    end_loading()


def usable_cores() -> int:
    """Return how many cores this process may use."""
    usable: Callable[[int], Sequence[int] | set[int]] | None = getattr(os, "sched_getaffinity", None)
    return len(usable(0)) if usable else os.cpu_count() or 1


def source_of(file: str) -> Source:
    """Return the text of a file, or of standard input for "-"."""
    from solver.problem.files import load
    from solver.problem.yaml_tree import MAX_BYTES

    if file != STANDARD:
        return load(file)
    content = sys.stdin.buffer.read(MAX_BYTES + 1)
    source = Source("<standard input>", content.decode("utf-8-sig", "replace"))
    if len(content) > MAX_BYTES:
        raise InputError(source, [Diagnostic(f"the input is larger than {MAX_BYTES // 1024} KB")])
    if "\ufffd" in source.text:
        raise InputError(source, [Diagnostic("it is not a text in UTF-8")])
    return source


def _deliver(request: Request, file: str, document: Document) -> int:
    """Write the solution in all formats and print the summary; return the exit code."""
    for fault in dict.fromkeys(part.fault for part in document.parts if part.fault):
        if request.presentation.templates is not None:  # a fault of ours leaves the part unsolved
            raise AtFault(f"cannot make the solution: {fault}")
    if request.destination.standard_output:
        content = _rendered(document, request.destination.formats[0])
        sys.stdout.buffer.write(content)
        sys.stdout.flush()
        _tell_what_is_wrong(document)
        return _code(document)
    written: list[Path] = []
    codes = [_code(document)]
    for format_, path in request.destination.paths(file).items():
        try:
            write_whole(path, _rendered(document, format_))
            for name, content in FORMATS[format_].beside(document).items():
                write_whole(path.with_name(name), content)
            written.append(path)
        except AtFault as fault:
            click.echo(f"{file}: error: {fault.format_message()}", err=True)
            codes.append(fault.exit_code)
    _print_summary(document, written, verbose=request.verbose)
    if request.open_page:
        _open(written)
    return max(codes)


def _rendered(document: Document, format_: str) -> bytes:
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


def _tell_what_is_wrong(document: Document) -> None:
    """Say on standard error which parts are not verified."""
    from solver.derivation import Status

    for part in document.parts:
        if part.status is not Status.VERIFIED:
            say = document.messages.say
            head = say(Phrase("part {id} ({method})", id=part.id, method=part.method))
            click.echo(f"{head}: {say(part.status)}: {part.reason}", err=True)


def _print_summary(document: Document, written: list[Path], *, verbose: bool, file: TextIO | None = None) -> None:
    from rich.console import Console

    from solver.render.terminal import WIDTH, print_summary

    console = Console(file=file, highlight=False, width=None if sys.stdout.isatty() else WIDTH, soft_wrap=False)
    print_summary(document, console, verbose=verbose)
    for path in written:
        click.echo(document.messages.say(Phrase("wrote {path}", path=path)))


def _open(written: list[Path]) -> None:
    """Open the page (or the first file written) in a browser."""
    import webbrowser

    pages = [path for path in written if path.suffix == ".html"] or written
    if pages and not webbrowser.open(pages[0].resolve().as_uri()):
        click.echo(f"no browser could be started; open {pages[0]} yourself", err=True)
