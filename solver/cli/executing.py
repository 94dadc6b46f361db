"""The options that say who works: `--jobs`, `--engine`, `--scheduler`, for commands over many files or variants."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import wraps
from typing import TYPE_CHECKING, Any

import click

from solver.cli.destination import AtFault

if TYPE_CHECKING:
    from solver.executors import Executor

ENGINES = ("processes", "dask")
JOBS = click.option("--jobs", metavar="N", type=click.IntRange(min=1, max=256),
                    help="How many processes work. Default: the cores.")  # fmt: skip
ENGINE = click.option("--engine", type=click.Choice(ENGINES), default=ENGINES[0], show_default=True,
                      help="Who works: processes of this machine, or a Dask cluster.")  # fmt: skip
SCHEDULER = click.option("--scheduler", metavar="ADDRESS", help="The cluster's scheduler, as tcp://host:8786. Default: "
                         "a cluster of --jobs workers on this machine.")  # fmt: skip
ADDRESS = re.compile(r"(tcp|tls|ucx|ws|wss|inproc)://\S+")


@dataclass(frozen=True, slots=True)
class Workers:
    """Who works, as the command line says it."""

    jobs: int | None = None
    engine: str = ENGINES[0]
    scheduler: str | None = None

    @property
    def processes(self) -> int:
        """How many processes work on this machine: those asked for, or one for each core that this one may use."""
        return self.jobs or usable_cores()

    def executor(self) -> Executor:
        """Return who makes the calls: a context manager, which ends what it has started."""
        from solver.executors import Processes

        if self.engine == "dask":
            from solver.executors.cluster import Cluster

            return Cluster(self.scheduler, self.processes)
        return Processes(self.processes)

    def refuse_contradictions(self) -> None:
        """Raise click.UsageError where the options do not fit together."""
        if self.scheduler is None:
            return
        if self.engine != "dask":
            raise click.UsageError("--scheduler is the one of a Dask cluster: add --engine dask.")
        if self.jobs is not None:
            raise click.UsageError("--jobs is the number of processes here; a cluster has the workers that it has.")
        if not ADDRESS.fullmatch(self.scheduler):
            raise click.UsageError(f"{self.scheduler} is no address of a scheduler; one is tcp://host:8786.")


def executing(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the options, as one argument `workers`."""

    @JOBS
    @ENGINE
    @SCHEDULER
    @wraps(command)
    def with_workers(*arguments: Any, jobs: int | None, engine: str, scheduler: str | None, **options: Any) -> Any:
        workers = Workers(jobs, engine, scheduler)
        workers.refuse_contradictions()
        with _in_words(engine):
            return command(*arguments, workers=workers, **options)

    return with_workers


@contextmanager
def _in_words(engine: str) -> Iterator[None]:
    """Turn what keeps a cluster from working into an error in words."""
    if engine != "dask":
        yield
        return
    from solver.executors import Unavailable

    try:
        yield
    except Unavailable as error:
        raise AtFault(str(error)) from None


def usable_cores() -> int:
    """Return how many cores this process may use."""
    usable: Callable[[int], Sequence[int] | set[int]] | None = getattr(os, "sched_getaffinity", None)
    return len(usable(0)) if usable else os.cpu_count() or 1
