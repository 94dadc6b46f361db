"""What every format shows of a solved problem: texts as Markdown with `$math$`, formulas as LaTeX, numbers.

A document holds no layout and no algebra. The page, LaTeX, Markdown, JSON and the terminal each lay out the same one,
so that no format can say more, or something else, than another; and it can be sent from one process to another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from html import escape
from pathlib import Path
from typing import Any

from solver.derivation import Answers, Check, CheckStatus, Status
from solver.derivation.figures import Drawing
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
    A language or notation wins over the one that the problem asks for.
    """

    detail: str = "full"
    templates: Path | None = None
    data: bool = False
    checks: str = ""
    sources: bool = True
    language: str | None = None
    notation: str | None = None

    def messages(self, display: Display) -> Messages:
        """Return how reasons and phrases are worded for a problem with this display."""
        return Messages(self.templates, self.language or display.language, self.notation or display.notation)

    def of(self, problem: Problem) -> Problem:
        """Return the problem in the language and the notation that are asked for."""
        messages = self.messages(problem.display)
        display = replace(problem.display, language=messages.language, notation=messages.notation)
        return replace(problem, display=display)

    @property
    def is_paper(self) -> bool:
        """Whether only the question is told."""
        return self.detail == "question"

    @property
    def shown_checks(self) -> str:
        """How checks are told: "none", "summary" or "table"."""
        return self.checks or ("none" if self.detail in {"question", "key"} else "summary")


@dataclass(frozen=True, slots=True)
class WorkStep:
    """A step in words: title and text are Markdown; its values by name, as sympy reads them back."""

    kind: str
    title: str
    markdown: str
    steps: tuple[WorkStep, ...] = ()
    figures: tuple[Drawing, ...] = ()
    values: Mapping[str, str] = field(default_factory=dict)

    def walk(self) -> Iterator[WorkStep]:
        """This step and all its substeps, in the order of reading."""
        yield self
        for step in self.steps:
            yield from step.walk()


@dataclass(frozen=True, slots=True)
class WorkAnswer:
    """One answer: its name, LaTeX of its symbol and value (no dollar signs), its meaning; `value` as sympy reads it.

    `equation` is LaTeX of symbol = value laid out for a page: broken over lines, or entry by entry, where it is wide.
    `narrow` is the same entry by entry in any case. `marks` is what it earns, as text, or "" where that is not said.
    `numeric` are its numbers in nested lists, a complex one as [re, im], where it has no symbols. `given` tells that it
    is what the question gives, such as the weights of a regulator, and is no news.
    """

    name: str
    symbol: str
    tex: str
    doc: str
    value: str
    equation: str
    narrow: str = ""
    marks: str = ""
    numeric: Any = None
    given: bool = False


@dataclass(frozen=True, slots=True)
class CheckRow:
    """One line of the table of checks: `claim`, `oracle`, `reason` are Markdown, numbers LaTeX or "" for none.

    The equalities of one step are one line: `residual` and `tolerance` are then those nearest to failing.
    """

    claim: str
    oracle: str
    residual: str
    tolerance: str
    status: CheckStatus
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Work:
    """One part by one method.

    `question` and `given` are Markdown; `again` tells that they stand above, with another method. `marks` is a number
    as text, or "" where the file gives none; `out_of` what the part counts for. `reason` (Markdown) says why a part is
    not verified, `unchecked` how many checks could not be made, and why. `rows` is the table of checks, `checks` each
    of them. `symbols` are the free names of answers and steps, `system` what is asked about, as sympy reads it. `fault`
    is what is wrong with the templates, where the part could not be worded.
    """

    id: str
    task: str
    method: str
    title: str
    method_title: str
    source: str
    marks: str
    question: str
    given: str
    again: bool
    steps: tuple[WorkStep, ...]
    answers: tuple[WorkAnswer, ...]
    rows: tuple[CheckRow, ...]
    status: Status
    reason: str
    unchecked: str = ""
    out_of: float = 1
    checks: tuple[Check, ...] = ()
    symbols: tuple[str, ...] = ()
    system: Mapping[str, str] = field(default_factory=dict)
    fault: str = ""

    @property
    def found(self) -> tuple[WorkAnswer, ...]:
        """The answers that the question does not give: those a page shows."""
        return tuple(answer for answer in self.answers if not answer.given)

    @property
    def named_method(self) -> str:
        """The title of the method where it says more than the task's, and may be said."""
        return "" if self.method_title == self.title else self.method_title

    @property
    def anchor(self) -> str:
        """A name for links to the part, unique on the page: letters, digits and hyphens."""
        words = f"part-{self.id}-{self.method}".replace("_", "-").lower()
        return "".join(letter for letter in words if letter.isascii() and (letter.isalnum() or letter == "-"))


@dataclass(frozen=True, slots=True, repr=False)
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

    @property
    def status(self) -> Status:
        """The worst status of the parts."""
        return Status.worst([part.status for part in self.parts])

    def checks_of(self, part: Work) -> str:
        """Return how the checks of a part are told: "none", "summary" or "table"; of a failed one as a table."""
        shown = self.presentation.shown_checks if part.rows else "none"
        return "table" if shown == "summary" and part.status is Status.FAILED else shown

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
        return "\n".join(f"$$\n{answer.symbol} = {answer.tex}\n$$" for answer in shown)

    def __repr__(self) -> str:
        return f"<worked solution of {self.title!r}: {self.status}>"


def in_a_frame(page: str, title: str) -> str:
    """Return a page as an element of another one."""
    frame = 'style="width: 100%; height: 40rem; border: 0" sandbox=""'
    return f'<iframe {frame} title="{escape(title)}" srcdoc="{escape(page)}"></iframe>'
