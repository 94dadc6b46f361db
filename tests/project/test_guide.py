"""The guide "add a task" works when followed word for word, in a copy of the project."""

import re

import pytest

from tests.helpers.copies import (
    COPIES,
    PROJECT,
    complaints_of_lint,
    complaints_of_the_meta_tests,
    copy_of_the_project,
    make_task,
    run,
)
from tests.helpers.shares import one_of

GUIDE = PROJECT / "docs" / "add-a-task.md"
FILE = re.compile(r"^`([\w/.-]+)`\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COMMAND = re.compile(r"^make task NAME=(\w+) TOPIC=(\w+)$", re.MULTILINE)

pytestmark = [
    *one_of(COPIES.index("guide"), len(COPIES)),
    pytest.mark.xdist_group("guide"),
]  # one copy of the project serves all


@pytest.fixture(scope="module")
def followed(tmp_path_factory):
    """A copy of the project with the guide's task in it, and the names of its files."""
    copy = copy_of_the_project(tmp_path_factory.mktemp("guide"))
    text = GUIDE.read_text(encoding="utf-8")
    name, topic = COMMAND.search(text).groups()
    written = make_task(copy, name, topic)
    for file, content in FILE.findall(text):
        path = copy / file
        assert file in written or not path.exists(), f"{file} exists already: the guide changes no file"
        path.write_text(content, encoding="utf-8")
        written.append(file)
    assert run(copy, "tools.tables").returncode == 0
    return copy, written


def test_its_problem_is_solved_and_worded(followed):
    copy, _ = followed
    result = run(copy, "solver", "problems/examples/matrix-inverse.yaml", "--detail", "tutor", "-o", "build/")
    assert result.returncode == 0, result.stdout + result.stderr
    page = (copy / "build" / "matrix-inverse.html").read_text(encoding="utf-8")
    assert "Verified" in page
    assert "adjugate is the transposed matrix of cofactors" in page


def test_the_catalogue_knows_it(followed):
    result = run(followed[0], "solver", "tasks", "matrix_inverse")
    assert result.returncode == 0, result.stderr
    assert "by adjugate over determinant" in result.stdout


def test_lint_finds_nothing(followed):
    assert not complaints_of_lint(*followed)


def test_all_tests_about_it_pass(followed):
    assert not complaints_of_the_meta_tests(followed[0], "matrix_inverse")
