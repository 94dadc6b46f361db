"""What the tests of the command line share: running it here or in a process of its own."""

import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from solver.cli import main
from solver.executors import Processes
from solver.tasks import catalogue
from tests.helpers.difficult_task import difficult, problem_text
from tests.helpers.small_problems import GOOD


class Outcome(NamedTuple):
    """How a command ended and what it printed."""

    code: int
    out: str
    err: str


@pytest.fixture
def solve(capsys, monkeypatch, tmp_path):
    """Run the command line in this process, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("NO_COLOR", "1")

    def run(*words):
        code = main([str(word) for word in words])
        captured = capsys.readouterr()
        return Outcome(code, captured.out, captured.err)

    return run


@pytest.fixture
def process(tmp_path):
    """Run Python in a process of its own: with words, the command line; or some code."""

    def run(*words, code=None, stdin=None, **environment):
        command = [sys.executable, *(("-c", code) if code else ("-m", "solver")), *map(str, words)]
        env = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2]), **environment}
        done = subprocess.run(
            command, cwd=tmp_path, env=env, input=stdin, capture_output=True, check=False, timeout=120
        )
        return Outcome(done.returncode, done.stdout.decode(), done.stderr.decode())

    return run


@pytest.fixture
def called(monkeypatch):
    """Note which functions are called in processes, with the first argument, or of papers written the label."""
    noted = []
    calls = Processes.calls

    def noting(self, limits, function, these):
        def each_noted():
            for each in these:
                noted.append((function.__name__, each[2] if function.__name__ == "_written" else each[0]))
                yield each

        return calls(self, limits, function, each_noted())

    monkeypatch.setattr(Processes, "calls", noting)
    return noted


@pytest.fixture
def good(tmp_path):
    """A problem that can be solved, in a file."""
    path = tmp_path / "good.yaml"
    path.write_text(GOOD, encoding="utf-8")
    return path


@pytest.fixture
def difficult_file(monkeypatch, tmp_path):
    """Write a problem that asks for methods of the difficult task, which is registered for the test."""
    monkeypatch.setitem(catalogue(), "difficult", difficult)

    def write(*methods, name="difficult.yaml"):
        path = tmp_path / name
        path.write_text(problem_text(*methods), encoding="utf-8")
        return path

    return write
