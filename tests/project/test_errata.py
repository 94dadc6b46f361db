"""docs/errata.md is what marking the printed answers gives now."""

import re

import pytest

from solver.classroom import read_submission
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.tasks import catalogue
from tests.helpers.solved import solution_of
from tools.errata import PAGE, PRINTED, marked, problem_of, title

FILES = sorted(PRINTED.glob("*.answers.yaml"))
ON_PAGE = PAGE.read_text(encoding="utf-8").splitlines()


def entry_of(path):
    return path.name.removesuffix(".answers.yaml")


@pytest.mark.slow
@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=pytest.mark.xdist_group(problem_of(path).stem), id=entry_of(path)) for path in FILES],
)
def test_the_errata_of_an_entry_are_up_to_date(path):
    """`make errata` writes what is missing."""
    _, wrong, undecided = marked(path, solution_of)
    entry = entry_of(path)
    assert [line.row() for line in wrong] == [line for line in ON_PAGE if line.startswith(f"| {entry} |")]
    assert [f"- {each}" for each in undecided] == [line for line in ON_PAGE if line.startswith(f"- {entry} ")]
    if wrong:
        (under,) = {heading for row in wrong for heading in [heading_above(row.row())]}
        assert under == f"## {title(wrong[0].chapter)}"


def heading_above(row):
    return next(line for line in reversed(ON_PAGE[: ON_PAGE.index(row)]) if line.startswith("## "))


def test_the_errata_are_counted():
    values = 0
    for path in FILES:
        submission = read_submission(load(path), read_problem(load(problem_of(path)), catalogue()))
        values += sum(map(len, submission.answers.values()))
    rows = [line for line in ON_PAGE if re.match(r"\| (?!entry)[a-z]", line)]
    open_ = [line for line in ON_PAGE if line.startswith("- ")]
    assert f"Of {values} printed values {len(rows)} are wrong." in ON_PAGE
    assert f"{len(open_)} could not be judged:" in ON_PAGE
    assert {line.split()[1] for line in (*rows, *open_)} <= set(map(entry_of, FILES))
