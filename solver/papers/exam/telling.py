"""A question solved, verified and told: as it stands on a paper, in a key, and in a file to fill in."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from solver.classroom.blank import blank_parts
from solver.derivation import Status
from solver.document.exam import as_question
from solver.document.model import Document
from solver.document.works import document_of, solve_as_told
from solver.papers.exam.scaling import scaled
from solver.papers.families import Made, Wanted
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

if TYPE_CHECKING:
    import sympy as sp


@dataclass(frozen=True, slots=True)
class Asked(Wanted):
    """What is wanted of a question: `presentation` tells its key."""

    number: int = 1
    marks: sp.Rational | None = None


@dataclass(frozen=True, slots=True)
class QuestionMade(Made):
    """A question as it stands on a paper and in a key, and the lines of the file to fill in; none where it failed."""

    paper: Document | None = None
    key: Document | None = None
    sheet: tuple[str, ...] = ()


def question_made(text: str, source: str, asked: Asked) -> QuestionMade:
    """Solve, verify and tell a question, in this process."""
    told = asked.presentation
    problem = told.of(scaled(read_problem(Source(source, text), catalogue()), asked.marks))
    solution = solve_as_told(problem, told)
    name = PurePath(source).name
    key = document_of(solution, told, name)
    judged = key if told.detail in {"full", "tutor"} else document_of(solution, replace(told, detail="full"), name)
    if judged.status is not Status.VERIFIED:
        part = next(part for part in judged.parts if part.status is not Status.VERIFIED)
        return QuestionMade(judged.status, f"part {part.letter}: {part.reason}", {})
    paper = document_of(solution, replace(told, detail="question", checks=""), name)
    sheet = tuple(blank_parts(solution, told.templates))
    return QuestionMade(
        Status.VERIFIED, "", {}, None, as_question(paper, asked.number), as_question(key, asked.number), sheet
    )
