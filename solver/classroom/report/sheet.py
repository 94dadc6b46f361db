"""The sheet to hand back: values, verdicts and marks."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from solver.classroom.report.words import number, remarks
from solver.classroom.verdicts import Marking, PartVerdict
from solver.document.model import Document
from solver.engine import Solution
from solver.problem.model import Part
from solver.render.page import rendered
from solver.render.wording import Wording
from solver.tasks import catalogue


@dataclass(frozen=True, slots=True)
class Line:
    """One submitted value on the sheet: LaTeX of symbol and value ("" where it was not read), and the words."""

    name: str
    tex: str
    verdict: str
    words: tuple[str, ...]


def render_sheet(
    solution: Solution, marking: Marking, document: Document | None = None, templates: Path | None = None
) -> str:
    """Return the page to hand back: values, verdicts and marks; with a document the worked solution below."""
    exact, typed = (replace(solution.problem.display, decimals_typed=decimals) for decimals in (False, True))
    wording = Wording.of(exact, templates=templates)
    decimals = Wording.of(typed, templates=templates)
    parts = {part.id: part for part in solution.problem.parts}
    return rendered(
        "sheet.html.jinja",
        templates,
        wording.messages,
        title=solution.problem.title,
        marking=marking,
        number=number,
        parts=[
            (part, wording.say(catalogue()[part.task].title), _lines(part, parts[part.id], wording, decimals))
            for part in marking.parts
        ],
        document=document,
    )


def _lines(part: PartVerdict, asked: Part, exact: Wording, decimals: Wording) -> list[Line]:
    """What was submitted for a part: a student's decimals are shown as decimals, what is exact as it is."""
    declared = catalogue()[asked.task].answers
    lines = []
    for answer in part.answers.values():
        wording = decimals if answer.in_decimals else exact
        tex = "" if answer.value is None else wording.equation(wording.symbol(declared[answer.name]), answer.value)
        words = tuple(map(_sentence, remarks(answer, wording.say)))
        lines.append(Line(answer.name, tex, str(answer.verdict), words))
    return lines


def _sentence(words: str) -> str:
    """Begin with a capital letter where it begins with a letter."""
    return words[:1].upper() + words[1:]
