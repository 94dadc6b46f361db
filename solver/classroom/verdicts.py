"""What marking finds: a verdict for each value, marks for each part, and the words that go with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum
from fractions import Fraction
from typing import Any

from solver.messages import Messages
from solver.words import Reason


class Verdict(StrEnum):
    """How a submitted value was judged."""

    CORRECT = "correct"
    WRONG = "wrong"
    NOT_JUDGED = "not judged"


@dataclass(frozen=True, slots=True)
class AnswerVerdict:
    """The verdict of one submitted value.

    `typed` is what was written, `value` how it was read (None if it could not be read); `respelt` tells that the one
    does not literally say the other. `reason` says what is wrong or why it is not
    judged; `note` is any other remark. Of a marking they are in words (Markdown with $math$). `entries` has the shape
    of a matrix or list and holds "correct" or "wrong". `follows` is true where it is right with the student's own
    earlier answer; `in_decimals` where it was written with decimals. It earned `marks` of the `out_of` that the answer
    carries, which are none where nobody asked for it. `ambiguous` is true where it could be read in several ways, and
    `by_instructor` where an instructor decided about it, perhaps with a `comment`. `mistake` is the name of the one
    that leads to a wrong value.
    """

    name: str
    verdict: Verdict
    value: Any = None
    reason: Reason | str = ""
    note: Reason | str = ""
    entries: Any = None
    follows: bool = False
    in_decimals: bool = False
    typed: str = ""
    respelt: bool = False
    marks: Fraction = Fraction(0)
    out_of: Fraction = Fraction(0)
    ambiguous: bool = False
    by_instructor: bool = False
    comment: str = ""
    mistake: str = ""

    def worded(self, messages: Messages) -> AnswerVerdict:
        """Return the verdict with its reason and note in words."""
        return replace(self, reason=messages.told(self.reason), note=messages.told(self.note))

    @property
    def needs_review(self) -> bool:
        """Whether a person should look at it: it is not judged, or has several readings, and nobody has yet."""
        return not self.by_instructor and (self.verdict is Verdict.NOT_JUDGED or self.ambiguous)

    @property
    def share(self) -> Fraction:
        """What part of it is right: all, none, or the share of right entries of a wrong matrix or list."""
        if self.verdict is Verdict.CORRECT:
            return Fraction(1)
        flat = _flat(self.entries)
        if self.verdict is Verdict.NOT_JUDGED or not flat:
            return Fraction(0)
        return Fraction(sum(entry == Verdict.CORRECT for entry in flat), len(flat))


def _flat(entries: Any) -> list[Any]:
    if entries is None:
        return []
    if isinstance(entries, list):
        return [leaf for each in entries for leaf in _flat(each)]
    return [entries]


@dataclass(frozen=True, slots=True)
class PartVerdict:
    """The verdicts of one part, in words, with the marks earned `out_of` those it carries.

    `missing` are the answers that were asked for and not submitted, with the marks that they carry;
    `comment` is the instructor's.
    """

    id: str
    task: str
    answers: dict[str, AnswerVerdict] = field(default_factory=dict)
    marks: Fraction = Fraction(0)
    out_of: Fraction = Fraction(0)
    note: str = ""
    missing: Mapping[str, Fraction] = field(default_factory=dict)
    comment: str = ""


@dataclass(frozen=True, slots=True)
class Marking:
    """A marked answer file: who, how each part of the problem was answered, and remarks on what else stands in it.

    `comment` is the instructor's, on the whole.
    """

    student: str
    parts: tuple[PartVerdict, ...]
    remarks: tuple[str, ...] = ()
    comment: str = ""

    @property
    def marks(self) -> Fraction:
        """All marks earned."""
        return sum((part.marks for part in self.parts), Fraction(0))

    @property
    def out_of(self) -> Fraction:
        """All marks there are."""
        return sum((part.out_of for part in self.parts), Fraction(0))

    def of(self, student: str) -> Marking:
        """Return the marking of a student who submitted the same."""
        return replace(self, student=student)

    @property
    def all_right(self) -> bool:
        """Whether nothing that was submitted is wrong."""
        verdicts = [answer.verdict for part in self.parts for answer in part.answers.values()]
        return Verdict.WRONG not in verdicts

    @property
    def to_review(self) -> tuple[str, ...]:
        """The answers that a person should look at: "b.K"."""
        answers = ((part.id, answer) for part in self.parts for answer in part.answers.values())
        return tuple(f"{id_}.{answer.name}" for id_, answer in answers if answer.needs_review)

    @property
    def needs_review(self) -> bool:
        """Whether a person should look at it: at an answer, or at what stands in the file that nobody asked for."""
        return bool(self.to_review or self.remarks)
