"""The work of `solve problem.yaml`: read, solve within limits, write, report; of many files `batch` has the work."""

from __future__ import annotations

import signal
import sys
import threading
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

import click

from solver.cli.destination import STANDARD, AtFault, Destination
from solver.cli.executing import Workers
from solver.cli.outcome import INPUT_AT_FAULT, SOLVED, UNSOLVED, Asked, Outcome, Screen, guarded, in_words, outcome_of
from solver.cli.progress import Meter
from solver.problem.source import Diagnostic, InputError, Source
from solver.startup import begin_loading, end_loading, quiet_threads

__all__ = [
    "INPUT_AT_FAULT",
    "SOLVED",
    "UNSOLVED",
    "Request",
    "asked_of",
    "in_words",
    "settle",
    "solve_files",
    "source_of",
]

if TYPE_CHECKING:
    from solver.document.model import Presentation
    from solver.problem.model import Problem


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
    workers: Workers = field(default_factory=Workers)
    several: bool = False
    again: bool = False


def solve_files(request: Request) -> int:
    """Solve each file; return the worst exit code. What is wrong with one file does not stop the others."""
    settle()
    if len(request.files) > 1 or (request.several and not request.open_page):
        from solver.cli.keeping import Solved

        kept = Solved(request, anew=request.again)
        if len(kept.told) == len(request.files):  # nothing that solves is loaded
            return max(kept.told[file].tell() for file in request.files)
        from solver.cli.batch import solve_many

        return solve_many(request, kept)
    return max(_guarded(request, file, Meter(1)) for file in request.files)


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


def _guarded(request: Request, file: str, meter: Meter) -> int:
    """Solve one file; whatever goes wrong becomes words on standard error and an exit code."""
    try:
        outcome, written = guarded(file, partial(_solve, request, file, meter)).deliver(file)
    finally:
        end_loading()
        meter.next_file()
    code = outcome.tell()
    if request.open_page and written:
        _open(written)
    return code


def _solve(request: Request, file: str, meter: Meter) -> Outcome:
    is_first = begin_loading()  # until `_rehearse` has loaded all, and the child
    import sympy.tensor.tensor  # noqa: F401 - here, so that the child has it too; the first sum needs the tensors

    from solver.limits import Child, Limits, Supervision, solve_within

    limits = Limits(request.time_limit, request.memory_limit)
    with Child() as child:  # it loads the algebra while the problem is being read
        from solver.problem.reader import read_problem
        from solver.tasks import catalogue

        problem = read_problem(source_of(file), catalogue())
        with meter.file(file) as notify:
            rehearsal = partial(_rehearse, request, file, problem) if is_first else None
            supervision = Supervision(notify, rehearsal, child)
            solved = solve_within(problem, limits, request.presentation, supervision)
    asked = asked_of(request, file, Screen.here())
    return outcome_of(solved.document(asked.name), asked)


def _rehearse(request: Request, file: str, problem: Problem) -> None:
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
        asked = asked_of(request, file, Screen.here())
        quick = {format_: path for format_, path in asked.paths.items() if format_ != "pdf"}
        if quick or asked.formats != ("pdf",):
            outcome_of(document, replace(asked, paths=quick))
    end_loading()


def asked_of(request: Request, file: str, screen: Screen) -> Asked:
    """Return what is asked of a file."""
    destination = request.destination
    paths = destination.paths(file)
    return Asked(file, destination.formats, paths, request.presentation, screen, request.verbose)


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


def _open(written: list[Path]) -> None:
    """Open the page (or the first file written) in a browser."""
    import webbrowser

    pages = [path for path in written if path.suffix == ".html"] or written
    if not webbrowser.open(pages[0].resolve().as_uri()):
        click.echo(f"no browser could be started; open {pages[0]} yourself", err=True)
