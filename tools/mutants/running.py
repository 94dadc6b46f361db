"""Running the tests that could see a slip: each in a process forked from one that has read the libraries already."""

from __future__ import annotations

import importlib
import multiprocessing
import os
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from multiprocessing.connection import wait
from pathlib import Path
from typing import Any

import pytest

from tools.mutants.operators import Mutant
from tools.mutants.reached import ROOT, Reached

COPIED = ("solver", "templates", "problems", "tests", "tools", "docs", "pyproject.toml", "CHANGELOG.md")
LIBRARIES = ("sympy", "numpy", "scipy.linalg", "mpmath", "hypothesis", "pydantic", "jinja2", "control")
BUDGET, BUDGET_ELSEWHERE = 12.0, 6.0
"""So many seconds of tests of its room, and of others, are run for one slip: one case of each function first."""
HOMES = {"options": "tests/problem/", "systems": "tests/problem/"}
"""Where the tests of a room are that has no folder of its own among them."""
READING = tuple(f"tests/{name}.py" for name in ("project/test_tables", "problem/test_schema", "tasks/test_promised"))
"""Tests of what the files declare: they run none of their functions."""
PATIENCE, SLOWER = 20, 3
"""A test that takes longer than so many seconds and so many times what it took goes on for ever: the slip is seen."""
FEW = 4
"""A line that fewer tests run may be one whose result they remember."""
FORK = multiprocessing.get_context("fork")
NO_TESTS = int(pytest.ExitCode.NO_TESTS_COLLECTED)
KILLED, KILLED_ELSEWHERE = 1, 101
OUTCOMES = ("killed", "timed out", "elsewhere", "survived", "not reached")
"""Killed by a test of its room, by its time limit, or by the test of another room; or not."""


def own_tests(room: str) -> str:
    """Where the tests of a room are."""
    names = (HOMES.get(room, f"tests/{room}/"), f"tests/test_{room}.py", "tests/")
    return next(name for name in names if (ROOT / name).exists())


def chosen_for(mutant: Mutant, reached: Reached) -> list[str]:
    """The tests that run the line, where it runs on import the file: those of its room and then all others.

    Of a file that has nothing but what runs on import, all tests of its room.
    """
    own, name = own_tests(mutant.room), f"/test_{Path(mutant.file).stem}.py::"
    direct = reached.tests_of(mutant.file, mutant.line)
    if not direct:
        direct = reached.tests_of_file(mutant.file) or {test for test in reached.seconds if test.startswith(own)}
        direct |= {test for test in reached.seconds if test.startswith(READING)}
    if len(direct) < FEW:  # what is remembered is found by one test, for all others
        direct |= reached.tests_of_file(mutant.file)
    mine = {test for test in direct if test.startswith(own)}
    mine = mine or {test for test in reached.seconds if test.startswith(own)}  # some run it when they are collected
    return [*_within(BUDGET, mine, reached, name), *_within(BUDGET_ELSEWHERE, direct - mine, reached, name)]


def _within(budget: float, tests: Iterable[str], reached: Reached, name: str) -> list[str]:
    chosen, spent = [], 0.0
    for test in _one_of_each_first(tests, reached, name):
        spent += reached.seconds[test]
        if spent > budget and chosen:
            break
        chosen.append(test)
    return chosen


def _one_of_each_first(tests: Iterable[str], reached: Reached, name: str) -> list[str]:
    """The first case of every function before the second; of these the tests of the file itself, then the quickest."""
    seen: dict[str, int] = defaultdict(int)
    turns = []
    for test in sorted(tests, key=lambda test: (reached.seconds[test], test)):
        function = _function(test)
        turns.append((seen[function], name not in test, reached.seconds[test], test))
        seen[function] += 1
    return [test for *_, test in sorted(turns)]


def _function(test: str) -> str:
    """The name of a test without that of its case."""
    return test.partition("[")[0]


class Chosen:
    """A plugin for pytest: only these tests, in this order.

    A slip may change the names of cases: where one is not there, all cases of its function are run.
    """

    def __init__(self, tests: Mapping[str, float], own: str) -> None:
        self.order = {test: i for i, test in enumerate(tests)}
        self.seconds = tests
        self.own = own
        self.code = 0

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        """End the process where one test goes on for ever: the others need not share their time with it."""
        whole, hard = resource.getrlimit(resource.RLIMIT_CPU)
        end = time.process_time() + PATIENCE + SLOWER * self.seconds.get(item.nodeid, 0.0)
        limits = [each for each in (int(end) + 1, whole) if each != resource.RLIM_INFINITY]
        resource.setrlimit(resource.RLIMIT_CPU, (min(limits), hard))
        try:
            return (yield)
        finally:
            resource.setrlimit(resource.RLIMIT_CPU, (whole, hard))

    def pytest_collection_modifyitems(self, items: list[pytest.Item]) -> None:
        """Leave what was chosen."""
        there = {item.nodeid for item in items}
        lost = {_function(test): i for test, i in self.order.items() if test not in there}
        places = {test: self.order.get(test, lost.get(_function(test), -1)) for test in there}
        items[:] = sorted((item for item in items if places[item.nodeid] >= 0), key=lambda item: places[item.nodeid])

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Remember whose test it is that fails."""
        if report.failed:
            self.code = KILLED if report.nodeid.startswith(self.own) else KILLED_ELSEWHERE


def outcomes(mutants: Sequence[Mutant], reached: Reached, lanes: int) -> Iterator[tuple[Mutant, str]]:
    """Yield each slip with what became of it, in the words of OUTCOMES."""
    for library in LIBRARIES:
        importlib.import_module(library)
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
        free = [_copy(Path(folder) / str(i)) for i in range(lanes)]
        waiting = [(mutant, chosen_for(mutant, reached)) for mutant in reversed(mutants)]
        running: dict[int, tuple[Any, Mutant, Path, float]] = {}
        while waiting or running:
            while waiting and free:
                mutant, tests = waiting.pop()
                if not tests:
                    yield mutant, "not reached"
                    continue
                each = {test: reached.seconds[test] for test in tests}
                seconds = PATIENCE + SLOWER * sum(each.values())
                lane = free.pop()
                process = FORK.Process(target=_try, args=(mutant, each, lane, int(seconds)))
                process.start()
                running[process.sentinel] = (process, mutant, lane, time.monotonic() + 3 * seconds)
            wait(list(running), timeout=1)
            for sentinel, (process, mutant, lane, end) in list(running.items()):
                if process.exitcode is None and time.monotonic() < end:
                    continue
                outcome = _ended(process)
                shutil.copy2(ROOT / mutant.file, lane / mutant.file)
                del running[sentinel]
                free.append(lane)
                yield mutant, outcome


def _ended(process: Any) -> str:
    """What a finished process says; one that goes on is ended, with what it started."""
    code = process.exitcode
    if code is None:
        os.killpg(process.pid, signal.SIGKILL)
    process.join()
    if code is None or code == -signal.SIGXCPU:
        return "timed out"
    return {0: "survived", NO_TESTS: "not reached", KILLED_ELSEWHERE: "elsewhere"}.get(code, "killed")


def _copy(lane: Path) -> Path:
    """A tree of its own, whose compiled files stay true: a slip has a time stamp of its own."""
    lane.mkdir()
    for name in COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, lane / name)
        else:
            shutil.copy2(ROOT / name, lane / name)
    return lane


def _try(mutant: Mutant, tests: Mapping[str, float], lane: Path, seconds: int) -> None:
    """In the child: make the slip and run the tests (with the seconds each took); the exit code is pytest's."""
    os.setsid()
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    silence = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(silence, stream)
    os.chdir(lane)
    os.environ.update(PYTHONPATH=str(lane), CI="true")
    sys.path.insert(0, str(lane))
    sys.dont_write_bytecode = False  # the next slip of this lane finds all files compiled, and only its own to compile
    for name in [name for name in sys.modules if name.partition(".")[0] in {"solver", "tests"}]:
        del sys.modules[name]
    (lane / mutant.file).write_bytes(mutant.applied((ROOT / mutant.file).read_bytes()))
    os.utime(lane / mutant.file, (0, int(mutant.key[:7], 16)))
    files = sorted({test.partition("::")[0] for test in tests})
    options = ["-x", "-q", "--tb=no", "-p", "no:cacheprovider", "-p", "no:faulthandler", "--rootdir", str(lane)]
    options += ["--hypothesis-profile", "mutants"]
    chosen = Chosen(tests, own_tests(mutant.room))
    code = pytest.main([*options, *files], plugins=[chosen])
    os._exit(chosen.code or int(code))
