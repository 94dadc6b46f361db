"""A bank of questions, one for each part and variant, with the fields that a learning system can mark by itself.

Writers of formats (Moodle, QTI, Canvas) lay out a `Quiz`; nothing of sympy is in it, and it can be sent from one
process to another. Texts are Markdown with `$math$` where it says so (`content.html_of` makes HTML of it), else plain;
all of it is a user's, to be escaped by who writes it. Numbers are decimal.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction

from solver.problem.images import Image


@dataclass(frozen=True, slots=True)
class Text:
    """Paragraphs, lists, tables, displayed formulas: Markdown."""

    markdown: str


@dataclass(frozen=True, slots=True)
class Heading:
    """A heading, Markdown of one line; `level` counts from 1 within its content."""

    markdown: str
    level: int = 1


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure: a drawing, what is seen in it (plain), and its caption (Markdown of one line)."""

    image: Image
    alt: str
    caption: str = ""


Block = Text | Heading | Picture


@dataclass(frozen=True, slots=True)
class Content:
    """What is read from top to bottom. `images` are those that the Markdown of the blocks names, by their address."""

    blocks: tuple[Block, ...] = ()
    images: Mapping[str, Image] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Wrong:
    """A value that a usual mistake leads to, with its tolerance: the share of the marks (0 to 1), a hint (Markdown)."""

    value: Decimal
    tolerance: Decimal
    share: Fraction
    hint: str


@dataclass(frozen=True, slots=True)
class Number:
    """A field for a number; right is what differs from `value` by `tolerance` at most (0 for whole numbers).

    `key` is unique in its item, `[a-z][a-z0-9-]*`; `label` says in plain words which entry it is. `marks` are what it
    carries, exactly; `typed` is the right value to the digits asked. No number is within the tolerance of two values.
    """

    key: str
    label: str
    value: Decimal
    tolerance: Decimal
    marks: Fraction
    typed: str
    wrong: tuple[Wrong, ...] = ()


@dataclass(frozen=True, slots=True)
class Choice:
    """A field where one of some words is right, that with the index `right`; they are plain, in their usual order."""

    key: str
    label: str
    words: tuple[str, ...]
    right: int
    marks: Fraction


Field = Number | Choice


@dataclass(frozen=True, slots=True)
class Fixed:
    """What stands between fields on a line: LaTeX without dollar signs."""

    latex: str


@dataclass(frozen=True, slots=True)
class Asked:
    """An answer that is asked for by fields.

    `name` is that of the catalogue, `symbol` its LaTeX, `meaning` says what it is, `form` how it is typed (both
    Markdown of one line). It is laid out in `lines`: where it is a `grid`, a matrix, each is a row of
    fields only, and `symbol =` stands before all of them; else each line is read from left to right, and its first cell
    says what it is (`K =`). All fields carry its `marks` together, in equal shares; they are in hundredths where
    those of the part are. With `whole` its marks are earned only where all fields are right, if the system can say so.
    """

    name: str
    symbol: str
    meaning: str
    form: str
    marks: Fraction
    lines: tuple[tuple[Field | Fixed, ...], ...]
    grid: bool = False
    whole: bool = False

    @property
    def fields(self) -> Iterator[Field]:
        """Its fields in the order of reading."""
        for line in self.lines:
            yield from (cell for cell in line if not isinstance(cell, Fixed))


@dataclass(frozen=True, slots=True)
class Essay:
    """What a person marks: the answers that are asked for, each with its LaTeX and its meaning (Markdown), and the key.

    `reasons` say of each answer (by its name) why no field can ask for it, plain.
    """

    asked: tuple[tuple[str, str], ...]
    key: Content
    reasons: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Item:
    """A question: either `answers` with fields, or an `essay`, never both.

    A part of which only some answers have fields is two items. `identifier` is unique among all items and the same in
    each export, `[a-z][a-z0-9-]*`; `name` (plain) tells the exam's question, part and variant. `question` is what is
    asked but the fields; `feedback` the worked solution. `tags` are plain, `marks` those of all its answers. `variant`
    is the label of whom it is for, "" where it is the same for all: a student gets all parts in one variant.
    """

    identifier: str
    name: str
    question: Content
    feedback: Content
    marks: Fraction
    answers: tuple[Asked, ...] = ()
    essay: Essay | None = None
    tags: tuple[str, ...] = ()
    variant: str = ""

    @property
    def fields(self) -> tuple[Field, ...]:
        """All fields in the order of reading."""
        return tuple(each for asked in self.answers for each in asked.fields)


@dataclass(frozen=True, slots=True)
class Group:
    """The variants of one question, of which a student is to get one: `path` (plain) is exam, question, part."""

    path: tuple[str, ...]
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Quiz:
    """The questions of an exam. All texts are plain."""

    title: str
    course: str
    language: str
    groups: tuple[Group, ...]

    @property
    def items(self) -> Iterator[Item]:
        """All questions in order."""
        for group in self.groups:
            yield from group.items
