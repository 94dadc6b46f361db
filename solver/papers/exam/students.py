"""The table of a class: CSV whose first column is the student. Excel writes it with commas, semicolons or tabs."""

from __future__ import annotations

import csv
import io
from unicodedata import name as character
from unicodedata import normalize

from solver.problem.source import Diagnostic, Fault, InputError, Report, Source

HEADINGS = ("student", "students", "name", "names", "id", "student id", "student number", "student name", "full name")
"""What a first cell says that is the heading of its column, in any capitals."""

DELIMITERS = ",;\t"
JOINERS = "\N{ZERO WIDTH NON-JOINER}\N{ZERO WIDTH JOINER}"
"""They are seen in how letters beside them are written, in Persian and in Indian scripts."""

LONGEST = 200
MOST = 10_000


def read_students(source: Source) -> tuple[str, ...]:
    """Return the students of a class in the order of the file; raises InputError.

    Lines without a student are passed over. A student who is there twice is an error: who would get which paper?
    """
    rows = csv.reader(io.StringIO(source.text, newline=""), delimiter=_delimiter(source.text), strict=True)
    report, found, line = Report(), dict[str, int](), 1
    try:
        for row in rows:
            first, line = line, rows.line_num + 1
            name = " ".join(normalize("NFC", row[0]).split()) if row else ""
            if name and not (first == 1 and name.casefold() in HEADINGS):
                with report:
                    _add(name, first, found)
    except csv.Error as error:
        note = "a quote that is opened is closed; within quotes it is written twice"
        raise InputError(source, [Diagnostic(f"it cannot be read as CSV: {error}", line, 1, note=note)]) from None
    if not report.diagnostics and not found:
        raise InputError(source, [Diagnostic("there is no student in the first column")])
    if not report.diagnostics and len(found) > MOST:
        raise InputError(source, [Diagnostic(f"there are more than {MOST} students")])
    if report.diagnostics:
        raise InputError(source, report.diagnostics)
    return tuple(found)


def _add(name: str, line: int, found: dict[str, int]) -> None:
    """Add a student; raises Fault."""
    if len(name) > LONGEST:
        raise Fault(Diagnostic(f"the name of a student is longer than {LONGEST} characters", line, 1))
    if unseen := next((each for each in name if not each.isprintable() and each not in JOINERS), ""):
        said = f"U+{ord(unseen):04X} {character(unseen, '')}".strip()
        shown = "".join(each if each.isprintable() else "\N{REPLACEMENT CHARACTER}" for each in name)[:60]
        message = f"the name '{shown}' has a character that cannot be seen, {said}"
        raise Fault(Diagnostic(message, line, 1, note="take it out; it may have come with a copy from elsewhere"))
    if name in found:
        message = f"'{name[:60]}' stands in line {found[name]} already"
        raise Fault(
            Diagnostic(message, line, 1, len(name), note="each student has one paper; tell them apart by an id")
        )
    found[name] = line


def _delimiter(text: str) -> str:
    """Return the sign that parts the first line most often outside of quotes, a comma where there is none."""
    first = "".join(text.lstrip("\r\n").split("\n", 1)[0].split('"')[::2])
    return max(DELIMITERS, key=lambda sign: (first.count(sign), -DELIMITERS.index(sign)))
