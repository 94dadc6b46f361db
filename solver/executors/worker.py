"""A process that makes one call after the other, with what it has cached: the parent's side, and its own."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterable
from contextlib import suppress
from importlib import import_module
from math import inf
from multiprocessing.connection import Connection, wait
from time import monotonic
from typing import Any

from solver.executors.executor import Arguments
from solver.executors.starting import WARM, apart, begin_server, context_of, deaf
from solver.limits.call import Exceeded, answer
from solver.limits.child import Limits, cause_of_death, restrict
from solver.startup import end_loading


class Worker:
    """A process; `place` is that of the call it is at, which ends at the time `end` at the latest, `made` of them."""

    def __init__(self, method: str) -> None:
        context = context_of(method)
        self.channel, its_end = context.Pipe()
        self.process = context.Process(target=serve, args=(its_end, method), daemon=True)
        if method == "forkserver":
            begin_server()
        with apart(), deaf():
            self.process.start()
        its_end.close()
        self.is_ready = False
        self.limits = Limits()
        self.place = self.made = 0
        self.end = inf

    def begin(self, place: int, limits: Limits, function: Callable[..., Any], arguments: Arguments) -> None:
        """Let it make a call. Its time begins when the process is ready."""
        self.place, self.limits = place, limits
        self.end = monotonic() + limits.seconds if self.is_ready else inf
        with suppress(OSError):  # it is dead; `result` will tell
            self.channel.send((limits, function, arguments))

    def has_ended(self) -> bool:
        """Whether the call has a result, met its time limit, or the process is dead."""
        if not self.is_ready and self.channel.poll(0):
            with suppress(EOFError, OSError):  # as above
                self.is_ready = self.channel.recv()
                self.end = monotonic() + self.limits.seconds
                return self.channel.poll(0)
            return True
        return self.channel.poll(0) or monotonic() >= self.end

    def result(self) -> Any:
        """Return the result of the call, or Exceeded."""
        try:
            if not self.channel.poll(0):
                return Exceeded(self.limits.told)
            answered, result = self.channel.recv()
        except (EOFError, OSError):
            self.process.join(1.0)
            return Exceeded(cause_of_death(self.process.exitcode))
        self.made += 1
        return result if answered else Exceeded(result)

    def kill(self) -> None:
        """End the process at once, with all that it has started."""
        if self.channel.closed:
            return
        end_group(self.process.pid)
        self.process.kill()
        self.process.join()
        self.channel.close()


def wait_for(workers: Iterable[Worker]) -> None:
    """Return when one of them may have ended its call."""
    some = list(workers)
    end = min(worker.end for worker in some)
    wait([worker.channel for worker in some], None if end == inf else max(0.0, end - monotonic()))


def end_group(pid: int | None) -> None:
    """End a process that leads a group of its own, and the group: TeX, say, which it has started."""
    if pid is not None and hasattr(os, "killpg"):
        with suppress(OSError):  # it is gone, or had no time to lead one
            os.killpg(pid, signal.SIGKILL)


def serve(channel: Connection, method: str) -> None:
    """Make the calls that are received; send (True, result), or (False, the reason) and end: the life of a worker."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    if hasattr(os, "setpgid"):
        os.setpgid(0, 0)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    multiprocessing.current_process().daemon = False  # it may start children of its own, which end with its group
    if method != "fork":
        import_module(WARM)
    end_loading()
    with suppress(EOFError, OSError):  # the parent is gone
        channel.send(True)
        while _serve_one(channel):
            pass


def _serve_one(channel: Connection) -> bool:
    """Make a call and send what it gives; return whether the process is fit for another one."""
    limits, function, arguments = channel.recv()
    restrict(limits, 1)
    return answer(channel.send, limits, function, arguments)


def _end_with_parent() -> None:
    """End this process, and what it has started, when its parent has ended, however that came about."""
    parent = multiprocessing.parent_process()
    if parent is None:
        return
    parent.join()
    end_group(os.getpid())
    os._exit(1)
