"""`make task` writes files that run and pass all tests as they are, and touches no others."""

import filecmp

import pytest

from tests.helpers.copies import (
    COPIES,
    PROJECT,
    complaints_of_lint,
    complaints_of_the_meta_tests,
    copy_of_the_project,
    make_task,
)
from tests.helpers.copies import run as run_in
from tests.helpers.shares import one_of

MADE_ANEW = {"docs/user-guide.md", "docs/tasks.md", "docs/methods.md"}
"""What is made from the declarations."""

pytestmark = [
    *one_of(COPIES.index("task"), len(COPIES)),
    pytest.mark.xdist_group("new_task"),
]  # one copy of the project serves all


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """A copy of the project with a new task of a new topic, and the names of the files written."""
    copy = copy_of_the_project(tmp_path_factory.mktemp("new"))
    return copy, make_task(copy, "trial_task", "trial_topic")


def changed(left, right):
    """Names of the files that differ, or are in the right folder only."""
    compared = filecmp.dircmp(left, right, ignore=["__pycache__", ".mypy_cache"], hide=[])
    yield from (str(right / name) for name in [*compared.diff_files, *compared.right_only])
    for name in compared.common_dirs:
        yield from changed(left / name, right / name)


def test_only_its_own_files_are_written(made):
    copy, written = made
    ours = {name.removeprefix(f"{copy}/") for name in changed(PROJECT, copy)}
    folders = {"solver/tasks/trial_topic", "templates/wording/trial_task"}
    others = {name for name in ours if not name.startswith(tuple(folders))}
    assert others == {name for name in written if not name.startswith(tuple(folders))} | MADE_ANEW
    assert len(written) == 6


def test_lint_finds_nothing(made):
    assert not complaints_of_lint(*made)


def test_all_tests_about_it_pass(made):
    assert not complaints_of_the_meta_tests(made[0], "trial_task")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("lqr", "design"), "there is a task lqr already"),
        (("Root-Locus", "classical"), "small letters with underscores"),
        (("frames", "design"), "is there already"),
        (("root_locus",), "Name the task and its topic"),
    ],
)
def test_a_name_that_does_not_do_is_told(made, arguments, says):
    done = run_in(made[0], "tools.new_task", *arguments)
    assert done.returncode == 2
    assert says in done.stderr
