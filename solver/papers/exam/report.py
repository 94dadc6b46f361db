"""The report of a class as a page; `html/report.html.jinja` is its layout."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

from solver.classroom.report.words import number
from solver.messages import Messages
from solver.papers.exam.grades import Graded, counted, missing, several_of, unmarked
from solver.papers.exam.marking import Solutions
from solver.papers.exam.model import Exam
from solver.papers.exam.statistics import statistics_of
from solver.render.page import rendered


def report_page(
    exam: Exam,
    graded: Sequence[Graded],
    solutions: Solutions,
    templates: Path | None = None,
    messages: Messages | None = None,
) -> str:
    """Return the page: marks, questions, mistakes, equal answers, grades, and what must be looked at first."""
    return rendered(
        "report.html.jinja",
        templates,
        messages,
        exam=exam,
        graded=graded,
        statistics=statistics_of(exam, graded, solutions),
        marked=len(counted(graded)),
        unmarked=unmarked(graded),
        several=several_of(graded),
        blank=[each.file for each in graded if each.is_blank],
        missing=missing(exam, graded),
        number=lambda marks: number(Fraction(marks)),
        shown=_shown,
    )


def _shown(value: float, digits: int) -> str:
    """Return a number with so many decimals, no sign before zero, and a sign that is no hyphen."""
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "−")
