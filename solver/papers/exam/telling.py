"""A question solved, verified and told: as it stands on a paper, in a key, and in a file to fill in."""

from __future__ import annotations

from dataclasses import replace
from pathlib import PurePath

from solver.classroom.blank import blank_parts
from solver.derivation import Status
from solver.document.exam import as_question
from solver.document.works import document_of, solve_as_told
from solver.papers.exam.packed import packed
from solver.papers.exam.question import Asked, QuestionMade
from solver.papers.exam.scaling import scaled
from solver.papers.judging import Judged
from solver.render.prose import inline_as_text


def question_made(draw: Judged, source: str, asked: Asked) -> QuestionMade:
    """Solve, verify and tell a question, in this process."""
    told = asked.presentation
    solution = solve_as_told(told.of(scaled(draw.problem, asked.marks)), told, draw.found)
    name = PurePath(source).name
    key = document_of(solution, told, name)
    judged = key if told.detail in {"full", "tutor"} else document_of(solution, replace(told, detail="full"), name)
    if judged.status is not Status.VERIFIED:
        part = next(part for part in judged.parts if part.status is not Status.VERIFIED)
        return QuestionMade(judged.status, f"part {part.letter}: {inline_as_text(part.reason)}", {})
    paper = document_of(solution, replace(told, detail="question", checks=""), name)
    sheet = "\n".join(blank_parts(solution, told.templates))
    together = packed(as_question(paper, asked.number), as_question(key, asked.number))
    return QuestionMade(Status.VERIFIED, "", {}, None, together, sheet, paper.messages)
