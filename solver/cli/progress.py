"""Progress on a terminal while files are being solved; nothing where standard error is not a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count
from typing import TYPE_CHECKING

from solver.progress import bar as bar_of
from solver.progress import same_screen

if TYPE_CHECKING:
    from solver.limits import Notify, Progress


class Meter:
    """Shows which of several files is being solved, and which part of it by which method."""

    def __init__(self, files: int) -> None:
        self.files = files
        self.done = 0

    def next_file(self) -> None:
        """Count a file as finished."""
        self.done += 1

    @contextmanager
    def file(self, name: str) -> Iterator[Notify | None]:
        """Show a bar while a file is being solved; yields what is to be told of its progress."""
        if not sys.stderr.isatty():
            yield None
            return
        from rich.console import Console
        from rich.progress import BarColumn, SpinnerColumn, TextColumn, TimeElapsedColumn
        from rich.progress import Progress as Bars

        columns = (SpinnerColumn(), TextColumn("{task.description}", markup=False), BarColumn(), TimeElapsedColumn())
        with Bars(
            *columns, console=Console(stderr=True), transient=True, auto_refresh=False, redirect_stdout=same_screen()
        ) as bars:
            bar = bars.add_task(name, total=self.files)

            def notify(progress: Progress) -> None:
                which = f"{name} ({self.done + 1} of {self.files}), " if self.files > 1 else ""
                share = self.done + progress.index / progress.total
                bars.update(bar, description=f"{which}part {progress.part} by {progress.method}", completed=share)
                bars.refresh()

            yield notify


@contextmanager
def bar(what: str, total: int) -> Iterator[Callable[[], object]]:
    """Show how many of some things are done, and the time left, on a terminal; yields what counts one more."""
    done = count(1)
    with bar_of(what, total, left=True) as tell:
        yield lambda: tell(next(done), total, what)


@contextmanager
def search_bar(total: int) -> Iterator[Callable[[int, int], object]]:
    """Show how many things are done, of a family how many draws were made, and the time left, as `bar` does."""
    with bar_of("solving", total, left=True) as tell:
        yield lambda draws, done: tell(done, total, f"{draws} draws" if draws else "solving")
