"""The sheet to hand back: the question, what was typed and how it was read, verdicts, marks, comments."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from pathlib import Path

from solver.classroom.alike import SOLUTIONS
from solver.classroom.marking import Marker
from solver.classroom.reading.answer_file import Submission
from solver.classroom.report.highlight import highlighted
from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.words import number, remarks, to_be_reviewed, verdict_of
from solver.classroom.same import Same
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.derivation import AnswerName
from solver.document.model import Document, Presentation, Work
from solver.document.works import document_of
from solver.engine import Solution
from solver.problem.source import Source
from solver.render.page import rendered
from solver.render.wording import Wording
from solver.tasks import catalogue

NOTHING = Fraction(0)


@dataclass(frozen=True, slots=True)
class Line:
    """One answer on the sheet: LaTeX of symbol and value ("" where none was read), and the words.

    `marks` are earned `out_of` those that it carries; `key` is the LaTeX of a right value where it is to be shown.
    """

    name: str
    verdict: str
    said: str
    marks: Fraction = NOTHING
    out_of: Fraction = NOTHING
    typed: str = ""
    tex: str = ""
    respelt: bool = False
    words: tuple[str, ...] = ()
    comment: str = ""
    key: str = ""
    unique: bool = True


@dataclass(frozen=True, slots=True)
class Section:
    """One part on the sheet: its verdict, its question, a line for each answer."""

    part: PartVerdict
    title: str
    work: Work
    lines: tuple[Line, ...]


def render_sheet(
    solution: Solution,
    marking: Marking,
    document: Document | None = None,
    templates: Path | None = None,
    *,
    key: bool = False,
) -> str:
    """Return the page to hand back; with `key` the right values too, with a document the worked solution below."""
    marking = in_hundredths(marking)
    sections, paper = marked_sections(solution, marking, templates, key=key)
    return rendered(
        "sheet.html.jinja",
        templates,
        paper.messages,
        title=solution.problem.title,
        marking=marking,
        number=number,
        review=to_be_reviewed(marking, paper.messages.say),
        sections=sections,
        paper=paper,
        worked=document is not None,
        document=replace(document, statement="", given="") if document else paper,  # the sheet has the problem already
    )


def marked_sections(
    solution: Solution, marking: Marking, templates: Path | None = None, *, key: bool = False
) -> tuple[list[Section], Document]:
    """Return the parts of a sheet, and the document of the question, which it shows above them."""
    sections, paper = _sections_of(Same(solution), templates, key)
    works = {work.id: work for work in reversed(paper.parts)}
    return [sections.section(part, works[part.id]) for part in marking.parts], paper


@lru_cache(SOLUTIONS)
def _sections_of(solution: Same[Solution], templates: Path | None, key: bool) -> tuple[_Sections, Document]:
    """Return what words the parts of a sheet, and the question as a document: the same for every student."""
    return _Sections(solution.it, templates, key), document_of(solution.it, Presentation("question", templates))


class _Sections:
    """Words the parts of a sheet: a student's decimals are shown as decimals, what is exact as it is."""

    def __init__(self, solution: Solution, templates: Path | None, key: bool) -> None:
        exact, typed = (replace(solution.problem.display, decimals_typed=decimals) for decimals in (False, True))
        self.exact = Wording.of(exact, templates=templates)
        self.decimals = Wording.of(typed, templates=templates)
        self.own = Wording.of(solution.problem.display, templates=templates)
        self.parts = {part.id: part for part in solution.problem.parts}
        self.marker = Marker(solution, Submission(Source("", ""), "", {}), templates) if key else None

    def section(self, part: PartVerdict, work: Work) -> Section:
        """Return a part with its lines, in the order of the catalogue."""
        declared = catalogue()[part.task].answers
        lines = tuple(self._with_key(part.id, line, declared[line.name]) for line in self._lines(part, declared))
        return Section(part, work.title, work, lines)

    def _lines(self, part: PartVerdict, declared: Mapping[str, AnswerName]) -> Iterator[Line]:
        for name in declared:
            if name in part.answers:
                yield self._line(part.answers[name], declared[name])
            elif name in part.missing:
                yield Line(name, "", self.exact.say("not submitted"), out_of=part.missing[name])

    def _line(self, answer: AnswerVerdict, declared: AnswerName) -> Line:
        wording = self.decimals if answer.in_decimals else self.exact
        tex = "" if answer.value is None else wording.equation(wording.symbol(declared), highlighted(answer))
        said = self.exact.say(verdict_of(answer))
        words = tuple(map(_sentence, remarks(answer, wording.say)))
        verdict, respelt, comment = str(answer.verdict), answer.respelt, answer.comment
        return Line(answer.name, verdict, said, answer.marks, answer.out_of, answer.typed, tex, respelt, words, comment)

    def _with_key(self, id_: str, line: Line, declared: AnswerName) -> Line:
        """The line with our own value, where it is to be shown and the one submitted is not right."""
        ours = self.marker.ours(id_) if self.marker is not None else {}
        if self.marker is None or line.name not in ours or line.verdict == Verdict.CORRECT:
            return line
        key = self.own.equation(self.own.symbol(declared), ours[line.name])
        return replace(line, key=key, unique=self.marker.is_determined(self.parts[id_], line.name))


def _sentence(words: str) -> str:
    """Begin with a capital letter where it begins with a letter."""
    return words[:1].upper() + words[1:]
