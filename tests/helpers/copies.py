"""A copy of the project with a new task in it, and the tests that tie a task to the rest of the project."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).parents[2]
LEFT_OUT = shutil.ignore_patterns(".*", "*.html", "build", "dist", "*.pyc.*", "*.tmp")
"""Compiled files go along, but not those that another process is writing."""

COPIES = ("task", "guide", "kind")
"""What is added to a copy, of which one is in turn: what `make task` writes, the guide's task, a kind of system."""

WHOLE = [
    *(f"tests/project/test_{name}.py" for name in ("house", "imports", "reasons", "tables")),
    *(f"tests/tasks/test_{name}.py" for name in ("catalogue", "declarations", "mistaken_methods", "promised")),
]
"""Meta-tests: they tie all tasks to wording, documentation, problems, stubs and each other."""

OF_THE_TASK = [
    "tests/tasks",
    "tests/cli/test_listing.py",
    "tests/test_problems.py",
    "tests/classroom",
    "tests/crosscheck",
]
"""Tests that try every task; here those of the new one."""


def copy_of_the_project(folder: Path) -> Path:
    """Copy the project's files, and the cache of the type checker."""
    copy = shutil.copytree(PROJECT, folder / "project", ignore=LEFT_OUT)
    if (PROJECT / ".mypy_cache").is_dir():
        shutil.copytree(PROJECT / ".mypy_cache", copy / ".mypy_cache")
    return copy


def run(copy: Path, *command: str) -> subprocess.CompletedProcess[str]:
    """Run a module of Python in the copy."""
    environment = {**os.environ, "PYTHONPATH": str(copy)}
    return subprocess.run(
        [sys.executable, "-m", *command], cwd=copy, env=environment, capture_output=True, text=True, check=False
    )


def make_task(copy: Path, name: str, topic: str) -> list[str]:
    """Do what `make task` does; return the files written."""
    made = run(copy, "tools.new_task", name, topic)
    assert made.returncode == 0, made.stderr
    assert run(copy, "tools.tables").returncode == 0
    return [line.removeprefix("wrote ") for line in made.stdout.splitlines()]


def complaints_of_the_meta_tests(copy: Path, name: str) -> str:
    """What the meta-tests, and the tests of every task that try this one, say in the copy; "" if all pass."""
    words = f"{name} or {name.replace('_', '-')}"
    quiet = ("pytest", "-q", "-p", "no:cacheprovider", "-n", "0")
    for which in (WHOLE, ["-k", words, "-m", "not slow", *OF_THE_TASK]):
        done = run(copy, *quiet, *which)
        if done.returncode:
            return done.stdout[-4000:] + done.stderr
    return ""


def complaints_of_lint(copy: Path, files: list[str]) -> str:
    """What the tools of `make lint` say of the files; "" if nothing. Who imports whom is a meta-test."""
    python = sorted({file for file in files if file.endswith(".py")})
    tasks = [file for file in python if file.startswith("solver/")]
    for command in (
        ("ruff", "check", "--no-cache", *python),
        ("ruff", "format", "--no-cache", "--check", *python),
        ("mypy", *tasks),
    ):
        done = run(copy, *command)
        if done.returncode:
            return f"{command[0]}: {done.stdout}{done.stderr}"
    return ""
