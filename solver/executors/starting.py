"""How workers are started: from a server that has loaded all algebra once, or anew where nothing can be forked safely.

What is started imports no script of the user and nothing from the folder in which the command was called.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from solver.limits.child import FORKS

if TYPE_CHECKING:
    from multiprocessing.context import ForkContext, ForkServerContext, SpawnContext

WARM = "solver.executors.warm"


def start_method() -> str:
    """Return how workers are started on this system."""
    return "forkserver" if FORKS else "spawn"


def context_of(method: str) -> ForkContext | ForkServerContext | SpawnContext:
    """Return the means to start processes by one of the methods of `multiprocessing`."""
    match method:
        case "fork":
            return multiprocessing.get_context("fork")
        case "forkserver":
            return multiprocessing.get_context("forkserver")
        case _:
            return multiprocessing.get_context("spawn")


def begin_server() -> None:
    """Start the server of workers, if it is not running: it loads all algebra while this process goes on."""
    from multiprocessing import forkserver  # noqa: PLC0415 - there is none on every system

    multiprocessing.set_forkserver_preload([WARM])
    resource_tracker.ensure_running()  # first, since it lets through the signals that it found blocked
    with apart(), deaf():
        forkserver.ensure_running()


@contextmanager
def apart() -> Iterator[None]:
    """Let a process that is started within it import what this one would, but not `__main__`.

    The user's script would run again in it; and a file `random.py` in the current folder is not Python's.
    """
    main, environment = sys.modules["__main__"], dict(os.environ)
    nobody = ModuleType("__main__")
    nobody.__spec__ = None
    sys.modules["__main__"] = nobody
    os.environ["PYTHONSAFEPATH"] = "1"
    os.environ["PYTHONPATH"] = os.pathsep.join(each or str(Path.cwd()) for each in sys.path)
    try:
        yield
    finally:
        sys.modules["__main__"] = main
        for name in ("PYTHONSAFEPATH", "PYTHONPATH"):
            os.environ.pop(name)
            if name in environment:
                os.environ[name] = environment[name]


@contextmanager
def deaf() -> Iterator[None]:
    """Let a process that is started within it not hear Ctrl-C, from its first moment: this process ends it."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
