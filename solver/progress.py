"""How far a long call has come, shown where a person watches: in a notebook, on a terminal, and nowhere else.

Whoever works is given something to tell, and knows nothing of where it is shown.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from html import escape
from importlib import import_module
from time import monotonic
from typing import Any

Tell = Callable[[int, int, str], object]
"""Is told how many things are done, of how many, and what is being done."""

Watch = bool | Tell | None
"""Where progress is shown: None in a notebook, True on a terminal too, False nowhere; or a function that is told."""

PAUSE = 0.1
"""Seconds between two changes of a notebook's display while no more is done: a browser has to draw each."""


@contextmanager
def shown(watch: Watch = None) -> Iterator[Tell]:
    """Yield what is to be told of progress; what was shown of it goes away at the end."""
    if callable(watch):
        yield watch
    elif watch is not False and (shell := _notebook()) is not None:
        display = _Display(shell)
        try:
            yield display.show
        finally:
            display.clear()
    elif watch:
        with bar() as tell:
            yield tell
    else:
        yield lambda _done, _total, _doing: None


@contextmanager
def bar(doing: str = "", total: int | None = None, *, left: bool = False) -> Iterator[Tell]:
    """Show a bar on a terminal, with the time that is left if that is wanted; nothing where there is none."""
    if not sys.stderr.isatty():
        yield lambda _done, _total, _doing: None
        return
    from rich import progress as rich  # noqa: PLC0415 - scripts need none of it
    from rich.console import Console  # noqa: PLC0415 - as above

    clock = rich.TimeRemainingColumn() if left else rich.TimeElapsedColumn()
    columns = (rich.TextColumn("{task.description}", markup=False), rich.BarColumn(), rich.MofNCompleteColumn(), clock)
    with rich.Progress(*columns, console=Console(stderr=True), transient=True, redirect_stdout=same_screen()) as bars:
        change = partial(bars.update, bars.add_task(doing, total=total))
        yield lambda done, of, what: change(completed=done, total=of, description=what)


def same_screen() -> bool:
    """Whether what is printed goes to a terminal, as a bar does: rich would else print it on standard error, too."""
    return sys.stdout.isatty()


def _notebook() -> Any:
    """Return the shell of the notebook that this process works for, None where there is none."""
    get_shell = getattr(sys.modules.get("IPython"), "get_ipython", None)
    shell = get_shell() if get_shell is not None else None
    return shell if hasattr(shell, "kernel") else None


class _Display:
    """A place in the output of a cell that is written anew; calls of one cell share it."""

    latest: tuple[str, Any] = "", None

    def __init__(self, shell: Any) -> None:
        asked: Mapping[str, Any] = shell.get_parent() if hasattr(shell, "get_parent") else {}
        self.cell = str(asked.get("header", {}).get("msg_id", ""))
        known, handle = _Display.latest
        self.handle = handle if self.cell and known == self.cell else None
        self.done = -1
        self.next = 0.0

    def show(self, done: int, total: int, doing: str) -> None:
        """Show how far it is, unless that was shown a moment ago."""
        if done == self.done and monotonic() < self.next:
            return
        self.done, self.next = done, monotonic() + PAUSE
        named = escape(doing)
        told = f'<progress value="{done}" max="{max(total, 1)}" aria-label="{named}"></progress>'
        self._write(f"{doing}: {done} of {total} done", f"<div>{told} {named}, {done} of {total} done</div>")

    def clear(self) -> None:
        """Leave nothing to be seen."""
        if self.done >= 0:
            self._write("", "")

    def _write(self, plain: str, html: str) -> None:
        bundle = {"text/plain": plain, "text/html": html}
        if self.handle is None:
            display = import_module("IPython.display").display  # it is there where there is a notebook
            self.handle = display(bundle, raw=True, display_id=True)
            _Display.latest = self.cell, self.handle
        else:
            self.handle.update(bundle, raw=True)


__all__ = ["Tell", "Watch", "bar", "same_screen", "shown"]
