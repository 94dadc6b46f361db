"""Calls made by a Dask cluster, each in a process beside a worker that keeps the limits. An extra: `distributed`.

Functions and results travel as pickles, which can run anything: a scheduler is to be trusted like the machine itself.
"""

from __future__ import annotations

import logging
import multiprocessing
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from multiprocessing import resource_tracker
from tempfile import gettempdir
from typing import TYPE_CHECKING, Any

from solver import __version__
from solver.executors.executor import Arguments, Executor, Unavailable
from solver.executors.processes import Processes
from solver.executors.starting import apart, deaf
from solver.limits import Exceeded, Limits
from solver.limits.child import as_bug
from solver.words import Phrase

if TYPE_CHECKING:
    from distributed import Client, Future

AT_HAND = 2
"""A worker has the next call at hand while it makes one."""

PATIENCE = 30
"""So many seconds are waited for a scheduler, and for a first worker."""

DEAF = "solver.executors.deaf"

INSTALL = "pip install 'solve-control[dask]'"


class Cluster(Executor):
    """The workers of a scheduler, or as many as there are `jobs` on this machine where none is named.

    A call whose worker is lost is made again by another one, a few times, and is then given up.
    """

    def __init__(self, scheduler: str | None = None, jobs: int = 1) -> None:
        self.scheduler = scheduler
        self.jobs = jobs
        self.client: Client | None = None

    def begin(self) -> None:
        """Connect with the cluster, or start one; raises Unavailable."""
        if self.client is not None:
            return
        try:
            import distributed  # noqa: PLC0415 - only who asks for a cluster needs it
        except ImportError:
            raise Unavailable(f"a cluster needs Dask: {INSTALL}") from None
        logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what is lost is told by us
        try:
            self.client = _started(self.jobs) if self.scheduler is None else _connected(self.scheduler)
            self.client.wait_for_workers(1, timeout=PATIENCE)
            self._refuse_strangers(self.client)
        except (OSError, distributed.TimeoutError) as error:
            self.close()
            where = self.scheduler or "the cluster on this machine"
            raise Unavailable(f"{where} does not answer, or has no workers: {error}") from None
        self.jobs = sum(self.client.nthreads().values())

    def _refuse_strangers(self, client: Client) -> None:
        """Raise Unavailable where workers have another version of the program, or none."""
        try:
            found = client.run(version)
        except ImportError as error:
            self.close()
            raise Unavailable(f"the program is not installed on the workers: {error}") from None
        for worker, its in found.items():
            if its != __version__:
                self.close()
                raise Unavailable(f"the worker {worker} has version {its} of the program, not {__version__}")

    def calls(
        self, limits: Limits, function: Callable[..., Any], calls: Iterable[Arguments]
    ) -> Iterator[tuple[int, Any]]:
        """Make the calls; see `Executor.calls`. Raises Unavailable where the cluster is lost."""
        from distributed import as_completed  # noqa: PLC0415 - as above

        self.begin()
        client = self._client()
        left = enumerate(calls)
        places: dict[Future[Any], int] = {}
        done = as_completed(loop=client.loop)

        def send() -> None:
            if (following := next(left, None)) is not None:
                future = client.submit(limited, limits, function, following[1], pure=False)
                places[future] = following[0]
                done.add(future)

        try:
            for _ in range(AT_HAND * self.jobs):
                send()
            for future in done:
                place, result = places.pop(future), _result_of(future)
                send()
                yield place, result
        finally:
            if places:
                with suppress(OSError):
                    client.cancel(list(places), force=True)

    def _client(self) -> Client:
        if self.client is None:
            raise AssertionError("it has begun")
        return self.client

    def close(self) -> None:
        """Leave the cluster; end it where it was started here."""
        if self.client is not None:
            client, self.client = self.client, None
            with suppress(OSError, TimeoutError):
                client.close()
                if self.scheduler is None and client.cluster is not None:
                    client.cluster.close()


def _connected(scheduler: str) -> Client:
    from distributed import Client  # noqa: PLC0415 - as above

    return Client(scheduler, timeout=PATIENCE, set_as_default=False)


def _started(jobs: int) -> Client:
    """Start a cluster on this machine, which nobody else can reach."""
    from distributed import Client, LocalCluster  # noqa: PLC0415 - as above

    resource_tracker.ensure_running()  # first, since it lets through the signals that it found blocked
    with apart(), deaf():
        cluster = LocalCluster(
            n_workers=jobs,
            threads_per_worker=1,
            processes=True,
            host="127.0.0.1",
            dashboard_address="127.0.0.1:0",
            silence_logs=logging.CRITICAL,
            local_directory=gettempdir(),
            preload=[DEAF],  # what its workers start lets the signals through again
        )
    return Client(cluster, set_as_default=False)


def _result_of(future: Future[Any]) -> Any:
    """Return what a call gave, or Exceeded; raises Unavailable."""
    from distributed import CancelledError, KilledWorker  # noqa: PLC0415 - as above

    try:
        return future.result()
    except KilledWorker:
        return Exceeded(Phrase("every worker that computed it was lost"))
    except (CancelledError, OSError) as error:
        raise Unavailable(f"the cluster is lost: {error}") from None
    except Exception as bug:  # noqa: BLE001 - the boundary of a call: a bug in one must not lose the others
        return Exceeded(as_bug(bug))


def version() -> str:
    """Return the version of the program."""
    return __version__


_OWN = threading.local()
"""The processes beside a worker, one for each of its threads."""


def limited(limits: Limits, function: Callable[..., Any], arguments: Arguments) -> Any:
    """Make a call within limits in a process beside this worker, which stays for the next."""
    processes: Processes | None = getattr(_OWN, "processes", None)
    if processes is None:
        processes = _OWN.processes = Processes(1)
        with suppress(AssertionError):  # a worker that somebody else has started may be none that has children
            multiprocessing.current_process().daemon = False
    ((_, result),) = processes.calls(limits, function, [arguments])
    return result
