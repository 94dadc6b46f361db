"""An exam as one document: what stands on the cover, and the document of each question, for a paper or for a key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from solver.document.model import ENGLISH_WORDS, Document, Presentation
from solver.document.work import Work
from solver.messages import Messages
from solver.problem.images import Image
from solver.words import Phrase

LEAST_ROOM = Fraction(20)
"""Millimetres of space for the answer of a part that carries hardly any marks."""


@dataclass(frozen=True, slots=True)
class ExamQuestion:
    """A question by its number from 1, its title, "" where it has none, and its marks as text.

    `document` tells it, and maybe its solution.
    """

    number: int
    title: str
    marks: str
    document: Document
    page_break: bool = False

    @property
    def heading(self) -> str:
        """The number and the title: "2. Regulator", or "Question 2"."""
        say = self.document.messages.say
        return (
            say(Phrase("Question {number}", number=self.number)) if not self.title else f"{self.number}. {self.title}"
        )

    @property
    def within(self) -> str:
        """What the names for links of this question begin with."""
        return f"question-{self.number}-"


@dataclass(frozen=True, slots=True)
class ExamDocument:
    """A paper or a key. All is plain text but the instructions, which are Markdown. `total` are the marks of all.

    `variant` names the paper, "" where there is only one; `student` is whose it is, "" where a name is to be filled in.
    `space` are the millimetres that a paper leaves blank for each mark of a part; where it is None there is no space.
    """

    title: str
    course: str
    date: str
    duration: str
    instructions: str
    total: str
    questions: tuple[ExamQuestion, ...]
    variant: str = ""
    student: str = ""
    presentation: Presentation = field(default_factory=Presentation)
    messages: Messages = ENGLISH_WORDS
    space: Fraction | None = None

    @property
    def is_paper(self) -> bool:
        """Whether only the questions are told."""
        return self.presentation.is_paper

    def room(self, document: Document, part: Work) -> int:
        """Return how many millimetres are left blank below a part; several methods of a part share them."""
        if self.space is None or not self.is_paper:
            return 0
        shared = sum(each.letter == part.letter for each in document.parts)
        return round(max(LEAST_ROOM, self.space * Fraction(part.marks or 0) / shared))

    @property
    def illustrated(self) -> bool:
        """Whether a step that is shown has a figure."""
        return any(each.document.illustrated for each in self.questions)

    @property
    def images(self) -> Mapping[str, Image]:
        """The images of all questions, by question and address: the same address may mean another one elsewhere."""
        found = ((each.number, each.document) for each in self.questions)
        return {f"{n}/{address}": image for n, told in found for address, image in told.images.items()}


def as_question(document: Document, number: int) -> Document:
    """Return a document that can stand among others: names for links of its own, and nothing but words and numbers."""
    parts = tuple(replace(part, id=f"{number}-{part.id}", label=part.letter) for part in document.parts)
    return replace(document, parts=parts, exact=dict, retell=None)
