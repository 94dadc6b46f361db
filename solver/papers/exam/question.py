"""A question of an exam: what is wanted of it, and what was made of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.document.model import ENGLISH_WORDS, Document
from solver.messages import Messages
from solver.papers.making import Made, Wanted

if TYPE_CHECKING:
    import sympy as sp


@dataclass(frozen=True, slots=True)
class Asked(Wanted):
    """What is wanted of a question: `presentation` tells its key."""

    number: int = 1
    marks: sp.Rational | None = None


@dataclass(frozen=True, slots=True)
class QuestionMade(Made):
    """A question as it stands on a paper and in a key, packed (see `packed`); nothing where it failed.

    `sheet` are the lines of the file to fill in, in the words of `messages`.
    """

    told: bytes | tuple[Document, Document] = b""
    sheet: str = ""
    messages: Messages = ENGLISH_WORDS
