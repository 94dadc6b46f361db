"""The Python interface: `solver.solve(path_or_text)` and `solver.check(problem, answers)`.

>>> import solver
>>> solution = solver.solve("problems/course/ch1/ch1-ex02.yaml")
>>> solution.status, solution.answers["a"]["Phi"]
>>> Path("page.html").write_text(solution.html(detail="tutor"), encoding="utf-8")
>>> solver.solve({"system": {"A": [[0, 1], [-2, -3]]}, "find": {"a": "state_transition_matrix"}})
>>> marked = solver.check("problem.yaml", {"b": {"K": [13, 8]}})
>>> marked.marks, marked.parts["b"].answers["K"].verdict

In a notebook the solution shows itself as a page, the marked answers as a sheet; while parts are being solved it shows
how far that is (see `solver.progress`).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from solver.document.model import Document, Presentation
from solver.document.works import document_of
from solver.engine import Solution, solve_parts, solve_problem
from solver.problem.data import source_of_data
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.progress import Tell, Watch, shown
from solver.tasks import catalogue

if TYPE_CHECKING:
    from solver.classroom.marked import Marked
    from solver.derivation import PartResult
    from solver.limits import Progress, Supervision
    from solver.problem.model import Problem


def solve(
    problem: str | Path | Mapping[str, Any],
    *,
    detail: str = "full",
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    progress: Watch = None,
    **limits: Any,
) -> Document:
    """Solve a problem given as the path of a YAML file, as YAML text (any text of more than one line) or as a mapping.

    A mapping has the keys of a problem file; its numbers and matrices may be those of Python, numpy or sympy.
    `language` and `notation` win over what the problem says. With `seconds` or `megabytes` (see
    `solver.limits.Limits`) every part is solved in a child process that is ended at the limit. A notebook shows how
    far it is; `progress=True` shows it on a terminal too, False nowhere, and a function is told: `progress(done, total,
    doing)`.
    Raises `solver.problem.source.InputError`, all errors with their places, if the input is at fault.
    """
    read = read_problem(source_of(problem), catalogue())
    folder = Path(templates) if templates else None
    presentation = Presentation(detail, folder, data=bool(limits), language=language, notation=notation)
    with shown(progress) as tell:
        if not limits:
            solved = _solved(read, presentation, tell)
            return document_of(solved, presentation, read.name)
        from solver.limits import Limits, solve_within  # noqa: PLC0415 - most uses need no child process

        return solve_within(read, Limits(**limits), presentation, _supervision(tell)).document(read.name)


def check(
    problem: str | Path | Mapping[str, Any],
    answers: str | Path | Mapping[str, Any],
    *,
    templates: str | Path | None = None,
    language: str | None = None,
    notation: str | None = None,
    progress: Watch = None,
    **limits: Any,
) -> Marked:
    """Mark a student's answers to a problem, both given as `solve` takes a problem.

    The answers may also be a mapping, `{"b": {"K": [13, 8]}}`, of numbers, texts, lists and truth values, or one with
    the keys of an answer file. Answers to an
    exam are marked by `solver.check_exam`.
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
    with shown(progress) as tell:
        if not limits:
            solution = _solved(read, told, tell)
            marking = mark(solution, submission, folder)
            return Marked(marking, solution, lambda: document_of(solution, told, read.name), folder)
        solved = solve_within(read, Limits(**limits), told, _supervision(tell))
        solution = solved.solution()
        marking = mark_within(solution, submission, Limits(**limits), folder)
        return Marked(marking, solution, lambda: solved.document(read.name), folder)


def _solved(problem: Problem, told: Presentation, tell: Tell) -> Solution:
    """Solve a problem in this process, and tell of each part."""
    return solve_problem(problem, partial(_telling, told, tell), arithmetic=told.arithmetic)


def _telling(told: Presentation, tell: Tell, problem: Problem) -> Iterator[list[PartResult]]:
    results = solve_parts(problem, told.messages(problem.display), arithmetic=told.arithmetic)
    total = len(problem.parts)
    for number, part in enumerate(problem.parts):
        tell(number, total, f"part {part.id}")
        yield next(results)
    tell(total, total, "writing")


def _supervision(tell: Tell) -> Supervision:
    """Return how a child process is watched: what it does is told."""
    from solver.limits import Supervision  # noqa: PLC0415 - as above

    def notify(progress: Progress) -> None:
        tell(progress.index, progress.total, f"part {progress.part} by {progress.method}")

    return Supervision(notify)


def source_of(given: str | Path | Mapping[str, Any]) -> Source:
    """Return the text that is given, of more than one line or as a mapping, or that of the file of this name."""
    if isinstance(given, Mapping):
        return source_of_data(given)
    is_text = isinstance(given, str) and "\n" in given
    return Source("<text>", str(given)) if is_text else load(given)


def _answers(given: Mapping[str, Any]) -> Source:
    """Return answers as the text of a file, of which they may have the keys."""
    whole = isinstance(given.get("answers"), Mapping)
    return source_of_data(given if whole else {"answers": given}, "<answers>")


__all__ = ["Document", "check", "solve"]
