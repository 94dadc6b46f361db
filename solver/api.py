"""The Python interface: `solver.solve(path_or_text)`.

>>> import solver
>>> solution = solver.solve("problems/course/ch1/ch1-ex02.yaml")
>>> solution.status, solution.answers["a"]["Phi"]
>>> Path("page.html").write_text(solution.html(detail="tutor"), encoding="utf-8")

In a notebook the solution shows itself as a page.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from solver.document.model import Document, Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue


def solve(
    problem: str | Path,
    *,
    detail: str = "full",
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    **limits: Any,
) -> Document:
    """Solve a problem given as the path of a YAML file, or as YAML text (any text of more than one line).

    `language` and `notation` win over what the problem says. With `seconds` or `megabytes` (see
    `solver.limits.Limits`) every part is solved in a child process that is ended at the limit.
    Raises `solver.problem.source.InputError`, all errors with their places, if the input is at fault.
    """
    is_text = isinstance(problem, str) and "\n" in problem
    source = Source("<text>", str(problem)) if is_text else load(problem)
    read = read_problem(source, catalogue())
    folder = Path(templates) if templates else None
    presentation = Presentation(detail, folder, data=bool(limits), language=language, notation=notation)
    if not limits:
        solved = solve_problem(read, messages=presentation.messages(read.display))
        return document_of(solved, presentation, read.name)
    from solver.limits import Limits, solve_within  # noqa: PLC0415 - most uses need no child process

    return solve_within(read, Limits(**limits), presentation).document(read.name)


__all__ = ["Document", "solve"]
