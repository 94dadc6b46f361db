"""A table of marks: a line for each answer file, a column for each part and for each of its answers."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from solver.classroom.report.hundredths import in_hundredths
from solver.classroom.report.words import number
from solver.classroom.verdicts import Marking, PartVerdict
from solver.messages import Messages

FORMULA = re.compile(r"(^|[;\t\r\n])(?=\s*[=+@＝＋＠－-]|[\t\r\n])")
"""Where a cell may begin that is a formula; signs of full width are the same to some spreadsheets."""

Columns = Sequence[tuple[str, Sequence[str]]]
"""The parts by id, each with the answers that carry its marks."""


def columns_of(blank: Marking) -> Columns:
    """Return the columns of a problem, from the marking of an empty submission."""
    return [(part.id, tuple(part.missing)) for part in blank.parts]


def as_csv(rows: Iterable[tuple[str, Marking | None]], columns: Columns, messages: Messages | None = None) -> str:
    """Return a table of marks for files; one that cannot be read (None) has its name only.

    Marks are in hundredths: those of the answers `a.K` add up to those of their part, those of the parts to the total.
    """
    say = (messages or Messages()).say
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    parts = [name for id_, answers in columns for name in (*(f"{id_}.{answer}" for answer in answers), id_)]
    writer.writerow([say("file"), say("student"), *parts, say("total"), say("out of"), say("needs review")])
    for name, marking in rows:
        cells = ["", *("" for _ in parts), say("not readable"), ""] if marking is None else _cells(marking, columns)
        review = marking is None or marking.needs_review
        writer.writerow([harmless(name), *cells, say("yes" if review else "no")])
    return content.getvalue()


def _cells(marking: Marking, columns: Columns) -> Iterator[Any]:
    marking = in_hundredths(marking)
    parts = {part.id: part for part in marking.parts}
    yield harmless(marking.student)
    for id_, names in columns:
        part = parts.get(id_)
        yield from ("" if part is None else _earned(part, name) for name in names)
        yield "" if part is None else number(part.marks)
    yield from (number(marking.marks), number(marking.out_of))


def _earned(part: PartVerdict, answer: str) -> int | float:
    return number(part.answers[answer].marks) if answer in part.answers else 0


def harmless(text: str) -> str:
    """Return a text of which no spreadsheet takes anything for a formula.

    Where it parts cells at semicolons, or at tabs, what follows one in a text is a cell, too.
    """
    return FORMULA.sub(r"\1'", text)
