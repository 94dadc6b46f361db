"""The problems in problems/, each solved once in a process whichever tests want its solution."""

from collections.abc import Iterable
from functools import cache, lru_cache
from pathlib import Path

import pytest

from solver.document.model import Document, Presentation
from solver.document.works import document_of
from solver.engine import Solution, solve_problem
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.resources import root
from solver.tasks import catalogue
from tests.helpers.shares import turn

PROBLEMS = sorted(
    path
    for path in root("problems").rglob("*.yaml")
    if not path.name.endswith(".answers.yaml") and path.parent != root("problems") / "exams"
)
EXAMPLES = [path for path in PROBLEMS if path.parent.name == "examples"]


@cache
def solution_of(path: Path) -> Solution:
    """The solution of the problem in a file."""
    return solve_problem(read_problem(load(path), catalogue()))


@cache
def document_of_problem(path: Path) -> Document:
    """The solution of the problem in a file, told with all words and all data."""
    return document_of(solution_of(path), Presentation("tutor", data=True))


@lru_cache(maxsize=16)  # what is asked of one problem runs in a row
def told_of_problem(path: Path, presentation: Presentation) -> Document:
    """The solution of the problem in a file, told so."""
    return document_of(solution_of(path), presentation)


def by_problem(paths: Iterable[Path], quick: Iterable[Path] | None = None, of: int = 1) -> dict[str, list]:
    """`path` for parametrize: what is asked of one problem runs in one worker; only `quick` ones run in `make test`.

    Where `of` is 2, 4 or 8, of the others a half, a quarter or an eighth runs in its turn.
    """
    paths, quick = list(paths), set(paths if quick is None else quick)
    groups = {path: pytest.mark.xdist_group(path.stem) for path in paths}
    slow = {path: () if path in quick else turn(path.stem, of) for path in paths}
    values = [pytest.param(path, marks=(groups[path], *slow[path]), id=path.stem) for path in paths]
    return {"argnames": "path", "argvalues": values}
