"""`solve FILE --watch`: what is written is written again when the file, its pictures or the templates change."""

from __future__ import annotations

import io
import os
import re
import time
import webbrowser
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack, redirect_stderr
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import unquote

import click

from solver.cli.serving import Board, Server
from solver.problem.images import KINDS
from solver.problem.yaml_tree import MAX_BYTES

if TYPE_CHECKING:
    from solver.cli.solving import Request

TICK = 0.06
"""Seconds between two looks at the files."""
SETTLED = 0.05
"""Seconds for which a file must stay as it is: an editor may write in several goes, or put another file in place."""
MISSING = 1.0
"""Seconds after which it is told that a file is gone."""
SHOWN = 2000
IMAGE = re.compile(r"!\[[^\]]*\]\(\s*<?([^)>\n]+?)>?(?:\s+[\"'][^)]*)?\)")

Mark = tuple[tuple[str, object], ...]
Work = Callable[[str], tuple[int, list[Path]]]
"""Makes what is wanted of a file; what is wrong goes to standard error. Returns the exit code and the files written."""


@dataclass
class Watched:
    """A file that is watched; `others` are files beside it that count too, `mark` is how all were when last used."""

    file: str
    others: Callable[[str], Iterable[Path]]
    mark: Mark = ()
    pages: list[Path] = field(default_factory=list)
    fault: str = ""

    def now(self) -> Mark:
        """Return how the files are: when and with what size they were written, and which ones they are."""
        return tuple((str(path), _state(path)) for path in (Path(self.file), *self.others(self.file)))


def watch(
    watched: Sequence[Watched], work: Work, *, port: int, tell: Callable[[str], object], serves: bool = True
) -> int:
    """Make what is wanted whenever a file changes, until Ctrl-C; return 0. `tell` is given the address of the pages."""
    board = Board()
    with ExitStack() as stack:
        server = stack.enter_context(Server(board, port)) if serves else None
        if server is not None:
            click.echo(f"the page is at {server.address_of()}", err=True)
        click.echo("watching; Ctrl-C ends it", err=True)
        try:
            for number, changed in enumerate(_changes(watched)):
                for each in changed:
                    _make(each, work)
                board.show(_pages(watched), "\n\n".join(each.fault for each in watched if each.fault)[:SHOWN])
                if number == 0 and server is not None:
                    tell(server.address_of())
        except KeyboardInterrupt:
            click.echo("no longer watching", err=True)
    return 0


def watch_problems(request: Request, port: int) -> int:
    """Solve the files of a request, and each again when it changes; return the exit code."""
    from solver.cli.solving import settle

    settle()
    templates = request.presentation.templates
    watched = [Watched(file, lambda name: beside_problem(name, templates)) for file in request.files]
    serves = "html" in request.destination.formats
    opens = request.open_page and serves

    def open_page(address: str) -> None:
        if opens and not webbrowser.open(address):
            click.echo(f"no browser could be started; open {address} yourself", err=True)

    with _Worker(request) as worker:
        return watch(watched, worker.work, port=port, tell=open_page, serves=serves)


class _Worker:
    """Solves files in a process that stays warm; templates that changed are read by a new one."""

    def __init__(self, request: Request) -> None:
        from solver.executors import Processes

        self.request = request
        self.executor = Processes(1)
        self.templates: object = self._templates()

    def work(self, file: str) -> tuple[int, list[Path]]:
        """Solve, write and tell a file; return the exit code and the files written."""
        from solver.cli.batch import made_of

        if (templates := self._templates()) != self.templates:
            self.executor.close()
            self.templates = templates
        outcome, written = made_of(self.request, file, self.executor).deliver(file)
        return outcome.tell(), written

    def _templates(self) -> object:
        folder = self.request.presentation.templates
        return [(path, _state(path)) for path in sorted(folder.rglob("*"))] if folder is not None else []

    def __enter__(self) -> _Worker:
        self.executor.begin()
        return self

    def __exit__(self, *_: object) -> None:
        self.executor.close()


def _changes(watched: Sequence[Watched]) -> Iterator[list[Watched]]:
    """Yield the files that changed, all of them at first; waits in between."""
    gone: dict[str, float] = {}
    first = True
    while True:
        changed = [each for each in watched if first or each.now() != each.mark]
        changed = [each for each in changed if first or not _is_for_a_moment_gone(each, gone)]
        first = False
        if changed:
            for each in changed:
                each.mark = _settled(each)
            yield changed
        else:
            time.sleep(TICK)


def _is_for_a_moment_gone(each: Watched, gone: dict[str, float]) -> bool:
    """Whether a file is not there, but may be about to be put in place."""
    if Path(each.file).exists():
        gone.pop(each.file, None)
        return False
    since = gone.setdefault(each.file, time.monotonic())
    return time.monotonic() - since < MISSING


def _settled(each: Watched) -> Mark:
    """Return how the files are when they do not change any more."""
    before = each.now()
    while True:
        time.sleep(SETTLED)
        now = each.now()
        if now == before:
            return now
        before = now


def _make(each: Watched, work: Work) -> None:
    """Do the work on a file; say what is wrong, and keep it for the page."""
    start = time.perf_counter()
    with redirect_stderr(io.StringIO()) as said:
        code, pages = work(each.file)
    words = said.getvalue()
    if words:
        click.echo(words, err=True, nl=False)
    each.fault = words.strip() if code > 1 or not pages else ""
    each.pages = pages or each.pages
    click.echo(f"{time.strftime('%H:%M:%S')}  {each.file}: {time.perf_counter() - start:.2f} s", err=True)


def _pages(watched: Sequence[Watched]) -> dict[str, bytes]:
    """Return what was written, by names that are told apart by their folders where needed."""
    paths = list(dict.fromkeys(path for each in watched for path in each.pages if path.is_file()))
    common = os.path.commonpath([path.resolve().parent for path in paths]) if paths else ""
    return {Path(os.path.relpath(path.resolve(), common)).as_posix(): path.read_bytes() for path in paths}


def _state(path: Path) -> object:
    try:
        found = path.stat()
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def beside_problem(file: str, templates: Path | None) -> list[Path]:
    """Return the pictures that the text of a problem names, there or not, and the templates."""
    path, found = Path(file), list[Path]()
    try:
        text = path.read_bytes()[: MAX_BYTES + 1].decode("utf-8", "replace") if path.is_file() else ""
    except OSError:
        text = ""
    for address in IMAGE.findall(text):
        image = path.parent / unquote(address)
        if image.suffix.lower() in KINDS:
            found.append(image)
    if templates is not None:
        found += (each for each in sorted(templates.rglob("*")) if each.is_file())
    return found


__all__ = ["Watched", "beside_problem", "watch"]
