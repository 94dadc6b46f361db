"""What every format shows of a solved problem: texts as Markdown with `$math$`, formulas as LaTeX, numbers.

A document holds no layout and no algebra. The page, LaTeX, Markdown, JSON and the terminal each lay out the same one,
so that no format can say more, or something else, than another; and it can be sent from one process to another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from html import escape
from pathlib import Path
from typing import Any

from solver.derivation import Answers, CheckStatus, Status
from solver.document.work import CheckRow, Reference, Work, WorkAnswer, WorkStep, step_anchor
from solver.messages import Messages
from solver.problem.images import Image
from solver.problem.model import Display, Problem
from solver.words import Phrase

ENGLISH_WORDS = Messages()


@dataclass(frozen=True, slots=True)
class Presentation:
    """How a solution is told: the level of detail, and a folder of templates that come before the installed ones.

    The levels are "question" (a paper), "key" (what earns the marks), "brief", "full" and "tutor". `checks` is "none",
    "summary" or "table"; empty is what the level of detail means. `sources` says whether the literature is named.
    `data` asks for the values of answers and steps as texts and numbers, which only JSON shows.
    A language or notation wins over the one that the problem asks for. `pdf_engine` is "tex" or "typst"; None is the
    one that is installed.
    """

    detail: str = "full"
    templates: Path | None = None
    data: bool = False
    checks: str = ""
    sources: bool = True
    language: str | None = None
    notation: str | None = None
    pdf_engine: str | None = None

    def messages(self, display: Display) -> Messages:
        """Return how reasons and phrases are worded for a problem with this display."""
        return Messages(self.templates, self.language or display.language, self.notation or display.notation)

    def of(self, problem: Problem) -> Problem:
        """Return the problem in the language and the notation that are asked for."""
        messages = self.messages(problem.display)
        display = replace(problem.display, language=messages.language, notation=messages.notation)
        return replace(problem, display=display)

    @property
    def arithmetic(self) -> bool:
        """Whether the arithmetic of a derivation is told."""
        return self.detail == "tutor"

    @property
    def is_paper(self) -> bool:
        """Whether only the question is told."""
        return self.detail == "question"

    @property
    def shown_checks(self) -> str:
        """How checks are told: "none", "summary" or "table"."""
        return self.checks or ("none" if self.detail in {"question", "key"} else "summary")


@dataclass(frozen=True, slots=True, weakref_slot=True, repr=False)
class Document:
    """A whole solution. `title` and `source` are plain text; `statement` and `given` are Markdown, maybe empty.

    `name` is the problem's file; `messages` words what stands around: headings, statuses. In a notebook it shows
    itself as a page.
    """

    title: str
    source: str
    statement: str
    given: str
    parts: tuple[Work, ...]
    presentation: Presentation = Presentation()
    name: str = ""
    messages: Messages = ENGLISH_WORDS
    images: Mapping[str, Image] = field(default_factory=dict)
    exact: Callable[[], Mapping[str, Answers]] = field(default=dict, compare=False)
    retell: Callable[[Presentation], Document] | None = field(default=None, compare=False)
    _shown: list[tuple[Work, ...]] = field(default_factory=list, init=False, compare=False)
    """The parts as pages show them, once they are known."""

    @property
    def status(self) -> Status:
        """The worst status of the parts; a special case without an answer is one of their answers."""
        counted = [part.status for part in self.parts if not part.case or part.status is Status.FAILED]
        return Status.worst(counted)

    @property
    def shown(self) -> tuple[Work, ...]:
        """The parts as pages show them: what stands above is referred to. A key has lines that earn marks, and all."""
        from solver.document.once import told_once  # noqa: PLC0415 - it builds on this file

        if self.presentation.detail in {"question", "key"}:
            return self.parts
        if not self._shown:
            self._shown.append(told_once(self.parts, self.messages.say, self.given))
        return self._shown[0]

    def checks_of(self, part: Work) -> str:
        """Return how the checks of a part are told: "none", "summary" or "table"; of a failed one as a table."""
        shown = self.presentation.shown_checks if part.rows else "none"
        return "table" if shown == "summary" and part.status is Status.FAILED else shown

    def heading_of(self, part: Work) -> str:
        """Return what a table of checks is headed by: the part, and its method where it has several."""
        named = f": {part.named_method}" if part.named_method else ""
        return f"({part.letter}) {part.title}{named}"

    def tally_of(self, part: Work) -> str:
        """Return how the checks of a part ended, in words: "Checks: 5 passed, 1 skipped"."""
        say, statuses = self.messages.say, [row.status for row in part.rows]
        counts = [(statuses.count(status), say(status)) for status in CheckStatus]
        return say(Phrase("Checks: {tally}", tally=", ".join(f"{count} {status}" for count, status in counts if count)))

    @property
    def illustrated(self) -> bool:
        """Whether any step that is shown has a figure."""
        return any(each.figures for part in self.parts for step in part.steps for each in step.walk())

    @property
    def answers(self) -> Mapping[str, Answers]:
        """The exact answers of each part, by the part's first method."""
        return self.exact()

    def told(self, **presentation: Any) -> Document:
        """Return the same solution told in another way, such as `detail="tutor"`.

        Raises ValueError where it was solved within limits and so told once, as it was asked for.
        """
        if presentation.get("templates"):
            presentation["templates"] = Path(presentation["templates"])
        wanted = replace(self.presentation, **presentation)
        if wanted == self.presentation:
            return self
        if replace(wanted, pdf_engine=self.presentation.pdf_engine) == self.presentation:  # the same words
            return replace(self, presentation=wanted)
        if self.retell is None:
            raise ValueError("what is solved within limits is told once: give detail and templates to `solve`")
        return self.retell(wanted)

    def rendered(self, format: str) -> bytes:  # noqa: A002 - the word of the command line
        """Return the solution in one of the formats of `solver.document.formats`."""
        from solver.document.formats import FORMATS  # noqa: PLC0415 - each format imports its own libraries

        return FORMATS[format].write(self)

    def html(self, **presentation: Any) -> str:
        """Return a whole page that needs nothing from outside."""
        return self.told(**presentation).rendered("html").decode()

    def latex(self, **presentation: Any) -> str:
        """Return a whole LaTeX document."""
        return self.told(**presentation).rendered("latex").decode()

    def pdf(self, **presentation: Any) -> bytes:
        """Return a PDF; raises `solver.render.pdf.PdfUnavailable` where nothing is installed that makes one."""
        return self.told(**presentation).rendered("pdf")

    def markdown(self, **presentation: Any) -> str:
        """Return Markdown with `$math$`."""
        return self.told(**presentation).rendered("md").decode()

    def text(self, **presentation: Any) -> str:
        """Return plain text."""
        return self.told(**presentation).rendered("text").decode()

    def json(self, **presentation: Any) -> str:
        """Return the result as JSON."""
        return self.told(data=True, **presentation).rendered("json").decode()

    def _repr_html_(self) -> str:
        """The page in a frame of its own, so that its style and the notebook's do not mix."""
        return in_a_frame(self.html(), self.messages.say("Worked solution"))

    def _repr_markdown_(self) -> str:
        return self.markdown()

    def _repr_latex_(self) -> str:
        """The answers as displayed formulas."""
        shown = [answer for part in self.parts for answer in part.found]
        return "\n".join(f"$$\n{answer.shown}\n$$" for answer in shown)

    def __repr__(self) -> str:
        return f"<worked solution of {self.title!r}: {self.status}>"


def in_a_frame(page: str, title: str) -> str:
    """Return a page as an element of another one."""
    frame = 'style="width: 100%; height: 40rem; border: 0" sandbox=""'
    return f'<iframe {frame} title="{escape(title)}" srcdoc="{escape(page)}"></iframe>'


__all__ = [
    "CheckRow",
    "Document",
    "Presentation",
    "Reference",
    "Work",
    "WorkAnswer",
    "WorkStep",
    "in_a_frame",
    "step_anchor",
]
