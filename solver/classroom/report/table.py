"""A line of a table of marks for each answer file."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from solver.classroom.report.words import number
from solver.classroom.verdicts import Marking


def as_csv(rows: Iterable[tuple[str, Marking | None]], parts: Sequence[str]) -> str:
    """Return a table of marks: a line for each file, a column for each part; a file at fault has none."""
    content = io.StringIO()
    writer = csv.writer(content, lineterminator="\n")
    writer.writerow(["file", "student", *parts, "total", "out of"])
    for name, marking in rows:
        writer.writerow([_harmless(name), *_cells(marking, parts)])
    return content.getvalue()


def _cells(marking: Marking | None, parts: Sequence[str]) -> Iterator[Any]:
    if marking is None:
        yield from ["", *("" for _ in parts), "not readable", ""]
        return
    earned = {part.id: number(part.marks) for part in marking.parts}
    yield _harmless(marking.student)
    yield from (earned.get(part, "") for part in parts)
    yield from (number(marking.marks), number(marking.out_of))


def _harmless(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t") else text
