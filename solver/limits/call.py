"""One function called within limits, on one item or on many, in child processes that can be killed."""

from __future__ import annotations

import signal
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from pickle import PickleError
from time import monotonic
from typing import Any

from solver.limits.child import Limits, as_bug, cause_of_death, new_context, restrict
from solver.words import Phrase

Arguments = tuple[Any, ...]


class Exceeded(Exception):  # noqa: N818 - a limit was met; no error of the program
    """The call was ended, or died; the reason, a phrase, says why."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


def call_within(limits: Limits, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return what the function returns; raises Exceeded where it takes too long or too much memory, or dies."""
    _, result = next(calls_within(limits, function, [arguments], 1))
    if isinstance(result, Exceeded):
        raise result
    return result


def calls_within(
    limits: Limits, function: Callable[..., Any], calls: Sequence[Arguments], jobs: int
) -> Iterator[tuple[int, Any]]:
    """Call the function with each of the arguments; yield the place of each call and its result, or Exceeded.

    They come as they are found. The limits are those of one call. Each of the `jobs` processes goes on to the next
    call, with what it has cached; one that met a limit is ended, and costs the others nothing.
    """
    left = deque(range(len(calls)))
    busy: list[_Worker] = []
    try:
        while left or busy:
            while left and len(busy) < jobs:
                busy.append(_Worker(limits, function, calls))
                busy[-1].begin(left.popleft())
            wait([worker.channel for worker in busy], max(0.0, min(worker.end for worker in busy) - monotonic()))
            for worker in [worker for worker in busy if worker.has_ended()]:
                place, result = worker.place, worker.result()
                if left and not isinstance(result, Exceeded):
                    worker.begin(left.popleft())
                else:
                    worker.kill()
                    busy.remove(worker)
                yield place, result
    finally:
        for worker in busy:
            worker.kill()


class _Worker:
    """A process that makes one call after the other; `place` is that of the call it is at, to `end` at that time."""

    def __init__(self, limits: Limits, function: Callable[..., Any], calls: Sequence[Arguments]) -> None:
        context = new_context()
        self.limits = limits
        self.channel, its_end = context.Pipe()
        self.process = context.Process(target=_work, args=(its_end, limits, function, calls), daemon=True)
        self.process.start()
        its_end.close()
        self.place = 0
        self.end = 0.0

    def begin(self, place: int) -> None:
        self.place, self.end = place, monotonic() + self.limits.seconds
        try:
            self.channel.send(place)
        except OSError:  # it is dead; `result` will tell
            return

    def has_ended(self) -> bool:
        return self.channel.poll(0) or monotonic() >= self.end

    def result(self) -> Any:
        """Return the result of the call, or Exceeded."""
        try:
            if not self.channel.poll(0):
                return Exceeded(Phrase("time limit of {seconds} s", seconds=f"{self.limits.seconds:g}"))
            answered, result = self.channel.recv()
        except (EOFError, OSError):
            self.process.join(1.0)
            return Exceeded(cause_of_death(self.process.exitcode))
        return result if answered else Exceeded(result)

    def kill(self) -> None:
        self.process.kill()
        self.process.join()
        self.channel.close()


def _work(channel: Connection, limits: Limits, function: Callable[..., Any], calls: Sequence[Arguments]) -> None:
    """Make the calls whose places are received, in the child; send (True, result), or (False, the reason) and end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    answered = True
    while answered:
        try:
            place = channel.recv()
        except (EOFError, OSError):  # the parent is gone
            return
        restrict(limits, len(calls))
        try:
            answered, result = True, function(*calls[place])
            channel.send((answered, result))
        except MemoryError:
            answered = _refuse(channel, Phrase("memory limit of {megabytes} MB", megabytes=limits.megabytes))
        except (RecursionError, PickleError):
            answered = _refuse(channel, "its result is nested too deeply")
        except Exception as bug:  # noqa: BLE001 - the boundary of a call: a bug in one must not lose the others
            answered = _refuse(channel, as_bug(bug))


def _refuse(channel: Connection, reason: str) -> bool:
    channel.send((False, reason))
    return False
