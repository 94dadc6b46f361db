"""Calls made by processes of this machine, which stay alive from one to the next."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any
from weakref import finalize

from solver.executors.executor import Arguments, Executor
from solver.executors.starting import begin_server, start_method
from solver.executors.worker import Worker, wait_for
from solver.limits import Exceeded, Limits

RENEWED = 2000
"""A worker makes so many calls; what it remembers of them is then forgotten with it."""


class Processes(Executor):
    """So many processes at most, started when they are wanted, each for one call at a time.

    A call that is stuck, dead or too large is ended alone, with its process, and another one goes on with the rest.
    By the method "fork" they have what this process has loaded by then, and else all algebra.
    """

    def __init__(self, jobs: int = 1, method: str | None = None) -> None:
        self.jobs = jobs
        self.method = method or start_method()
        self.idle: list[Worker] = []
        finalize(self, _kill, self.idle)

    def begin(self) -> None:
        """Let the algebra be loaded already."""
        if self.method == "forkserver":
            begin_server()

    def calls(
        self, limits: Limits, function: Callable[..., Any], calls: Iterable[Arguments]
    ) -> Iterator[tuple[int, Any]]:
        """Make the calls; see `Executor.calls`."""
        left = enumerate(calls)
        busy: list[Worker] = []
        try:
            while True:
                while len(busy) < self.jobs and (following := next(left, None)) is not None:
                    busy.append(self.idle.pop() if self.idle else Worker(self.method))
                    busy[-1].begin(following[0], limits, function, following[1])
                if not busy:
                    return
                wait_for(busy)
                for worker in [worker for worker in busy if worker.has_ended()]:
                    place, result = worker.place, worker.result()
                    if isinstance(result, Exceeded) or worker.made >= RENEWED:
                        worker.kill()
                        busy.remove(worker)
                    elif (following := next(left, None)) is not None:
                        worker.begin(following[0], limits, function, following[1])
                    else:
                        busy.remove(worker)
                        self.idle.append(worker)
                    yield place, result
        finally:
            _kill(busy)

    def close(self) -> None:
        """End the processes."""
        _kill(self.idle)


def _kill(workers: list[Worker]) -> None:
    while workers:
        workers.pop().kill()
