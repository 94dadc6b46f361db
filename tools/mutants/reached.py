"""A plugin for pytest that writes down which statements of the program each test runs, and how long the test takes.

`python -m pytest -p tools.mutants.reached` leaves one file a worker in `build/reached/`; `read` puts them together.
"""

from __future__ import annotations

import json
import os
import resource
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tools.mutants.noting import ROOT, program

FOLDER = ROOT / "build" / "reached"
Lines = Sequence[Sequence[int]]


@dataclass
class Record:
    """What one worker wrote down."""

    tests: list[str]
    files: dict[str, tuple[int, Lines]]
    """By file: the number of its first statement, and first and last line of each."""
    ran: np.ndarray[Any, np.dtype[np.uint8]]
    """A row of bits for each test, one for each statement."""
    changed: set[str] = field(default_factory=set)
    """Files whose lines are no longer what they were."""

    def tests_of(self, file: str, line: int) -> set[str]:
        """The tests that run the innermost statement on this line."""
        if file in self.changed:
            return self.tests_of_file(file)
        number, lines = self.files.get(file, (0, ()))
        around = [i for i, (first, last) in enumerate(lines) if first <= line <= last]
        return self._tests(number + max(around, key=lambda i: lines[i][0])) if around else set()

    def tests_of_file(self, file: str) -> set[str]:
        """The tests that run any statement of the file."""
        number, lines = self.files.get(file, (0, ()))
        return set().union(*(self._tests(number + i) for i in range(len(lines))))

    def _tests(self, number: int) -> set[str]:
        column = self.ran[:, number // 8] >> (7 - number % 8) & 1
        return {self.tests[i] for i in np.flatnonzero(column)}


@dataclass
class Reached:
    """What is known of the tests: seconds of each that passed, and what they run."""

    seconds: dict[str, float] = field(default_factory=dict)
    records: list[Record] = field(default_factory=list)

    def tests_of(self, file: str, line: int) -> set[str]:
        """The tests that run the innermost statement on this line."""
        return set().union(*(each.tests_of(file, line) for each in self.records)) & self.seconds.keys()

    def tests_of_file(self, file: str) -> set[str]:
        """The tests that run any statement of the file inside a function."""
        return set().union(*(each.tests_of_file(file) for each in self.records)) & self.seconds.keys()


def read(folder: Path = FOLDER) -> Reached:
    """Put together what all workers wrote down; of a file that has changed since, what runs any of it."""
    reached, now = Reached(), json.loads(json.dumps(program().files()))
    for written in sorted(folder.glob("*.json"), key=lambda path: path.stat().st_mtime):
        record = json.loads(written.read_text(encoding="utf-8"))
        reached.seconds.update(record["seconds"])
        ran = np.load(written.with_suffix(".npz"))["ran"]
        changed = {file for file, (_, lines) in record["files"].items() if now.get(file, (0, ()))[1] != lines}
        reached.records.append(Record(record["tests"], record["files"], ran, changed))
    return reached


class Recorder:
    """Asks after each test what ran."""

    def __init__(self, worker: str) -> None:
        self.file = FOLDER / f"{worker}-{os.getpid()}.json"
        self.names: dict[str, str] = {}
        self.seconds: dict[str, float] = {}
        self.ran: dict[str, np.ndarray[Any, np.dtype[np.uint8]]] = {}

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """Run one test and note it; a slow one is not for slips."""
        if item.get_closest_marker("slow"):
            return (yield)
        name = self.names[item.nodeid] = _name(item)
        program().ran()
        start = _seconds()
        result = yield
        self.seconds[name] = _seconds() - start
        self.ran[name] = np.packbits(program().ran())
        return result

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Forget what does not pass: it can tell nothing of a slip."""
        if not report.passed:
            self.seconds.pop(self.names.get(report.nodeid, ""), None)

    def pytest_sessionfinish(self) -> None:
        """Write down what was seen, if anything was."""
        if not self.ran:
            return
        files = program().files()
        text = {"seconds": self.seconds, "tests": [*self.ran], "files": files}
        self.file.write_text(json.dumps(text), encoding="utf-8")
        np.savez_compressed(self.file.with_suffix(".npz"), ran=np.array([*self.ran.values()], dtype=np.uint8))


def _name(item: pytest.Item) -> str:
    """The name of a test, without the group that xdist puts at its end."""
    marker = item.get_closest_marker("xdist_group")
    return item.nodeid.removesuffix(f"@{marker.args[0]}") if marker else item.nodeid


def _seconds() -> float:
    """The processor's time of this process and of those it started."""
    both = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in both)


def _runs_tests(options: Any) -> bool:
    """Whether tests run in this process: a worker, or the only one there is."""
    return "PYTEST_XDIST_WORKER" in os.environ or not getattr(options, "numprocesses", None)


@pytest.hookimpl(tryfirst=True)
def pytest_load_initial_conftests(early_config: Any) -> None:
    """Have the program noted before a conftest imports it."""
    if _runs_tests(early_config.known_args_namespace):
        program().watch()


def pytest_configure(config: Any) -> None:
    """Record in the workers; where there are none, here."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    if _runs_tests(config.option):
        config.pluginmanager.register(Recorder(os.environ.get("PYTEST_XDIST_WORKER", "alone")))
