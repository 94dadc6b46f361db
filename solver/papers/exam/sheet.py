"""The sheet of an exam to hand back: each question with what was typed, how it was judged, and the marks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from solver.classroom import Marking
from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.sheet import Section, marked_sections
from solver.classroom.report.words import number, to_be_reviewed
from solver.document.exam import ExamQuestion
from solver.document.model import Document
from solver.engine import Solution
from solver.papers.exam.grades import Graded
from solver.papers.exam.marking import Worked, apart
from solver.papers.exam.model import Exam
from solver.render.page import rendered


@dataclass(frozen=True, slots=True)
class _Marked:
    """A question on the sheet: its heading, what names for links begin with, its parts, its documents."""

    heading: str
    within: str
    marking: Marking
    sections: Sequence[Section]
    paper: Document
    worked: Document | None


def exam_sheet(
    exam: Exam,
    graded: Graded,
    solutions: Sequence[Solution],
    templates: Path | None = None,
    *,
    key: bool = False,
    worked: Worked = MappingProxyType({}),
) -> str:
    """Return the page to hand back for a file that was marked.

    With `key` it shows the right values too, and the worked solutions that there are below the questions.
    """
    if graded.marking is None:
        raise ValueError("a file that cannot be read has no sheet")
    questions: list[_Marked] = []
    whole = in_hundredths(graded.marking)
    for question, marking, solution in zip(exam.questions, apart(whole, graded.of_questions), solutions, strict=True):
        sections, paper = marked_sections(solution, marking, templates, key=key)
        told = ExamQuestion(question.number, question.title, "", paper)
        own = worked.get((graded.variant, question.number))
        questions.append(_Marked(told.heading, told.within, marking, sections, paper, own))
    messages = questions[0].paper.messages
    return rendered(
        "exam-sheet.html.jinja",
        templates,
        messages,
        exam=exam,
        variant=graded.variant,
        marking=whole,
        questions=questions,
        number=number,
        review=to_be_reviewed(whole, messages.say),
    )
