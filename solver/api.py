"""The Python interface: `solver.solve(path_or_text)` and `solver.check(problem, answers)`.

>>> import solver
>>> solution = solver.solve("problems/course/ch1/ch1-ex02.yaml")
>>> solution.status, solution.answers["a"]["Phi"]
>>> Path("page.html").write_text(solution.html(detail="tutor"), encoding="utf-8")
>>> solver.solve({"system": {"A": [[0, 1], [-2, -3]]}, "find": {"a": "state_transition_matrix"}})
>>> marked = solver.check("problem.yaml", {"b": {"K": [13, 8]}})
>>> marked.marks, marked.parts["b"].answers["K"].verdict

In a notebook the solution shows itself as a page, the marked answers as a sheet.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from solver.document.model import Document, Presentation
from solver.document.works import document_of, solve_as_told
from solver.problem.data import source_of_data
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

if TYPE_CHECKING:
    from solver.classroom.marked import Marked


def solve(
    problem: str | Path | Mapping[str, Any],
    *,
    detail: str = "full",
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    **limits: Any,
) -> Document:
    """Solve a problem given as the path of a YAML file, as YAML text (any text of more than one line) or as a mapping.

    A mapping has the keys of a problem file; its numbers and matrices may be those of Python, numpy or sympy.
    `language` and `notation` win over what the problem says. With `seconds` or `megabytes` (see
    `solver.limits.Limits`) every part is solved in a child process that is ended at the limit.
    Raises `solver.problem.source.InputError`, all errors with their places, if the input is at fault.
    """
    read = read_problem(source_of(problem), catalogue())
    folder = Path(templates) if templates else None
    presentation = Presentation(detail, folder, data=bool(limits), language=language, notation=notation)
    if not limits:
        return document_of(solve_as_told(read, presentation), presentation, read.name)
    from solver.limits import Limits, solve_within  # noqa: PLC0415 - most uses need no child process

    return solve_within(read, Limits(**limits), presentation).document(read.name)


def check(
    problem: str | Path | Mapping[str, Any],
    answers: str | Path | Mapping[str, Any],
    *,
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    **limits: Any,
) -> Marked:
    """Mark a student's answers to a problem, both given as `solve` takes a problem.

    The answers may also be a mapping, `{"b": {"K": [13, 8]}}`, of numbers, texts, lists and truth values.
    Raises `solver.problem.source.InputError` if the problem or the answer file is at fault; a value that cannot be read
    is not judged.
    """
    from solver.classroom import mark, mark_within, read_submission  # noqa: PLC0415 - who solves needs no marking
    from solver.classroom.marked import Marked  # noqa: PLC0415 - as above
    from solver.limits import Limits, solve_within  # noqa: PLC0415 - as above

    folder = Path(templates) if templates else None
    told = Presentation("full", folder, language=language, notation=notation)
    read = told.of(read_problem(source_of(problem), catalogue()))
    source = _answers(answers) if isinstance(answers, Mapping) else source_of(answers)
    submission = read_submission(source, read)
    if not limits:
        solution = solve_as_told(read, told)
        marking = mark(solution, submission, folder)
        return Marked(marking, solution, lambda: document_of(solution, told, read.name), folder)
    solved = solve_within(read, Limits(**limits), told)
    solution = solved.solution()
    marking = mark_within(solution, submission, Limits(**limits), folder)
    return Marked(marking, solution, lambda: solved.document(read.name), folder)


def source_of(given: str | Path | Mapping[str, Any]) -> Source:
    """Return the text that is given, of more than one line or as a mapping, or that of the file of this name."""
    if isinstance(given, Mapping):
        return source_of_data(given)
    is_text = isinstance(given, str) and "\n" in given
    return Source("<text>", str(given)) if is_text else load(given)


def _answers(given: Mapping[str, Any]) -> Source:
    """Return answers as the text of a file."""
    return source_of_data({"answers": given}, "<answers>")


__all__ = ["Document", "check", "solve"]
