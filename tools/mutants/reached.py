"""A plugin for pytest that writes down which lines of the program each test runs, and how long the test takes.

`python -m pytest -p tools.mutants.reached` leaves one file a worker in `build/reached/`; `read` puts them together.
"""

from __future__ import annotations

import json
import os
import time
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import coverage
import pytest

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "build" / "reached"


@dataclass
class Reached:
    """What is known of the tests: seconds of each that passed, and the tests that run a line of a file."""

    seconds: dict[str, float] = field(default_factory=dict)
    lines: dict[str, dict[int, set[str]]] = field(default_factory=lambda: defaultdict(lambda: defaultdict(set)))

    def tests_of(self, file: str, first: int, last: int) -> set[str]:
        """The tests that run one of these lines."""
        lines = self.lines.get(file, {})
        return {test for line in range(first, last + 1) for test in lines.get(line, ()) if test in self.seconds}

    def tests_of_file(self, file: str) -> set[str]:
        """The tests that run any line of the file in a test."""
        return {test for tests in self.lines.get(file, {}).values() for test in tests if test in self.seconds}


def read(folder: Path = FOLDER) -> Reached:
    """Put together what all workers wrote down."""
    reached = Reached()
    for times in folder.glob("*.json"):
        reached.seconds.update(json.loads(times.read_text(encoding="utf-8")))
        data = coverage.CoverageData(str(times.with_suffix(".lines")))
        data.read()
        for file in data.measured_files():
            name = Path(file).relative_to(ROOT).as_posix()
            for line, tests in data.contexts_by_lineno(file).items():
                reached.lines[name][line].update(filter(None, tests))
    return reached


class Recorder:
    """Switches the context of the measurement at each test."""

    def __init__(self, worker: str) -> None:
        self.file = FOLDER / f"{worker}-{os.getpid()}.json"
        self.seconds: dict[str, float] = {}
        self.failed: set[str] = set()
        lines = str(self.file.with_suffix(".lines"))
        self.coverage = coverage.Coverage(lines, source=[str(ROOT / "solver")], config_file=False, messages=False)
        self.coverage.start()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """Run one test in its own context; a slow one is not for slips."""
        if item.get_closest_marker("slow"):
            return (yield)
        name = item.nodeid.partition("@")[0]  # xdist names the group of a test there
        self.coverage.switch_context(name)
        start = time.process_time()
        result = yield
        self.seconds[name] = time.process_time() - start
        self.coverage.switch_context("")
        return result

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Remember what does not pass: it can tell nothing of a slip."""
        if not report.passed:
            self.failed.add(report.nodeid.partition("@")[0])

    def pytest_sessionfinish(self) -> None:
        """Write down what was seen."""
        self.coverage.stop()
        self.coverage.save()
        passed = {test: seconds for test, seconds in self.seconds.items() if test not in self.failed}
        self.file.write_text(json.dumps(passed), encoding="utf-8")


def pytest_configure(config: Any) -> None:
    """Record in the workers; where there are none, here."""
    worker = os.environ.get("PYTEST_XDIST_WORKER", "")
    FOLDER.mkdir(parents=True, exist_ok=True)
    if worker or not config.getoption("numprocesses", None):
        config.pluginmanager.register(Recorder(worker or "alone"))
