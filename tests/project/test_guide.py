"""The guide "add a task" works when followed word for word, in a copy of the project."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]
GUIDE = PROJECT / "docs" / "add-a-task.md"
FILE = re.compile(r"^`([\w/.-]+)`\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.fixture(scope="module")
def followed(tmp_path_factory):
    """A copy of the project with the guide's files in it."""
    copy = tmp_path_factory.mktemp("project")
    for folder in ("solver", "templates", "problems", "tests"):
        shutil.copytree(PROJECT / folder, copy / folder, ignore=shutil.ignore_patterns("__pycache__", "*.html"))
    files = FILE.findall(GUIDE.read_text(encoding="utf-8"))
    for name, text in files:
        path = copy / name
        assert not path.exists(), f"{name} exists already: the guide changes no file"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    assert len(files) == 5
    return copy


def run(copy: Path, *command: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(copy)}
    return subprocess.run(
        [sys.executable, "-m", *command], cwd=copy, env=environment, capture_output=True, text=True, check=False
    )


def test_its_test_passes(followed):
    result = run(followed, "pytest", "-q", "-p", "no:cacheprovider", "tests/tasks/test_matrix_inverse.py")
    assert result.returncode == 0, result.stdout + result.stderr
    assert "3 passed" in result.stdout


def test_its_problem_is_solved_and_worded(followed):
    result = run(followed, "solver", "problems/examples/matrix-inverse.yaml", "--detail", "tutor", "-o", "build/")
    assert result.returncode == 0, result.stdout + result.stderr
    page = (followed / "build" / "matrix-inverse.html").read_text(encoding="utf-8")
    assert "Verified" in page
    assert "adjugate is the transposed matrix of cofactors" in page


def test_the_catalogue_knows_it(followed):
    result = run(followed, "solver", "tasks", "matrix_inverse")
    assert result.returncode == 0, result.stderr
    assert "by adjugate over determinant" in result.stdout
