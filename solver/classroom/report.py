"""A marking as data, as text for a terminal, as a sheet to hand back, and as a line of a table of marks."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.document.checks import Say
from solver.document.model import Document
from solver.engine import Solution
from solver.messages import Messages
from solver.problem.model import Part
from solver.render.page import rendered
from solver.render.plain import sympy_text
from solver.render.prose import inline_as_text
from solver.render.wording import Wording
from solver.tasks import catalogue
from solver.words import Phrase

if TYPE_CHECKING:
    from rich.console import Console

SIGNS = {Verdict.CORRECT: "✓", Verdict.WRONG: "✗", Verdict.NOT_JUDGED: "?"}
COLOURS = {Verdict.CORRECT: "green", Verdict.WRONG: "bold red", Verdict.NOT_JUDGED: "yellow"}


def as_json(marking: Marking) -> str:
    """Return the marking as JSON text."""
    return json.dumps(as_data(marking), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def as_data(marking: Marking) -> dict[str, Any]:
    """Return the marking as dictionaries, lists, texts and numbers."""
    head = {"student": marking.student} if marking.student else {}
    totals = {"marks": number(marking.marks), "out_of": number(marking.out_of)}
    remarks = {"remarks": list(marking.remarks)} if marking.remarks else {}
    return {"version": 1, **head, **totals, "parts": [_part_data(part) for part in marking.parts], **remarks}


def _part_data(part: PartVerdict) -> dict[str, Any]:
    data: dict[str, Any] = {
        "id": part.id,
        "task": part.task,
        "answers": {name: _answer_data(verdict) for name, verdict in part.answers.items()},
        "marks": number(part.marks),
        "out_of": number(part.out_of),
    }
    return data | ({"note": part.note} if part.note else {})


def _answer_data(answer: AnswerVerdict) -> dict[str, Any]:
    data: dict[str, Any] = {"verdict": str(answer.verdict)}
    for key, text in (("reason", answer.reason), ("note", answer.note)):
        data |= {key: str(text)} if text else {}
    data |= {"follows": True} if answer.follows else {}
    data |= {"value": _shown(answer.value)} if answer.value is not None else {}
    return data | ({"entries": answer.entries} if isinstance(answer.entries, list) else {})


def _shown(value: Any) -> str:
    return str(value) if isinstance(value, bool | str) else sympy_text(value)


def number(marks: Fraction) -> int | float:
    """Return marks as a number of JSON, to two decimals."""
    return int(marks) if marks.denominator == 1 else round(float(marks), 2)


def print_marking(marking: Marking, name: str, console: Console, messages: Messages) -> None:
    """Print the verdicts of one answer file."""
    from rich.text import Text  # noqa: PLC0415 - rich is needed only to print

    who = f"{name} ({marking.student})" if marking.student else name
    say = messages.say
    console.rule(Text(f"{who}: {say(earned(marking))}"), align="left", style="dim")
    for remark in marking.remarks:
        console.print(Text(f"    {inline_as_text(remark)}", style="yellow"))
    for part in marking.parts:
        head = Text(f"{part.id}  ", style="bold")
        note = f" ({part.note})" if part.note else ""
        head.append(f"{say(catalogue()[part.task].title)}: {say(earned(part))}{note}")
        console.print(head)
        for answer in part.answers.values():
            line = Text(f"    {SIGNS[answer.verdict]} ", style=COLOURS[answer.verdict])
            line.append(f"{answer.name}: {say(answer.verdict)}{_words(answer, say)}", style="default")
            console.print(line)


def earned(marked: Marking | PartVerdict) -> Phrase:
    """Return how many marks are earned: "2 of 3"."""
    return Phrase("{marks} of {out_of}", marks=number(marked.marks), out_of=number(marked.out_of))


def _words(answer: AnswerVerdict, say: Say) -> str:
    """What is said of a verdict in a line of text."""
    said = "; ".join(inline_as_text(each) for each in _remarks(answer, say))
    return f" – {said}" if said else ""


def _remarks(answer: AnswerVerdict, say: Say) -> list[str]:
    """Return what is said of a verdict (Markdown): the reason, the note, the places of what is wrong."""
    places = "; ".join(say(place) for place in wrong_places(answer))
    wrong = say(Phrase("wrong at {places}", places=places)) if places else ""
    return [said for said in (str(answer.reason), str(answer.note), wrong) if said]


def wrong_places(answer: AnswerVerdict) -> list[Phrase]:
    """The places of wrong entries, counted from 1, where some entries are right: "row 1, column 2", or "column 2"."""
    entries = answer.entries
    if answer.verdict is not Verdict.WRONG or not isinstance(entries, list) or answer.share == 0:
        return []
    if not entries or not isinstance(entries[0], list):
        return [Phrase("item {i}", i=i) for i, each in enumerate(entries, 1) if each == Verdict.WRONG]
    wrong = [(i, j) for i, row in enumerate(entries, 1) for j, each in enumerate(row, 1) if each == Verdict.WRONG]
    rows, columns = ([place[of] for place in wrong] for of in (0, 1))
    if all(columns.count(j) == len(entries) > 1 for j in columns):
        return [Phrase("column {j}", j=j) for j in dict.fromkeys(columns)]
    if all(rows.count(i) == len(entries[0]) > 1 for i in rows):
        return [Phrase("row {i}", i=i) for i in dict.fromkeys(rows)]
    return [Phrase("row {i}, column {j}", i=i, j=j) for i, j in wrong]


@dataclass(frozen=True, slots=True)
class Line:
    """One submitted value on the sheet: LaTeX of symbol and value ("" where it was not read), and the words."""

    name: str
    tex: str
    verdict: str
    words: tuple[str, ...]


def render_sheet(
    solution: Solution, marking: Marking, document: Document | None = None, templates: Path | None = None
) -> str:
    """Return the page to hand back: values, verdicts and marks; with a document the worked solution below."""
    exact, typed = (replace(solution.problem.display, decimals_typed=decimals) for decimals in (False, True))
    wording = Wording.of(exact, templates=templates)
    decimals = Wording.of(typed, templates=templates)
    parts = {part.id: part for part in solution.problem.parts}
    return rendered(
        "sheet.html.jinja",
        templates,
        wording.messages,
        title=solution.problem.title,
        marking=marking,
        number=number,
        parts=[
            (part, wording.say(catalogue()[part.task].title), _lines(part, parts[part.id], wording, decimals))
            for part in marking.parts
        ],
        document=document,
    )


def _lines(part: PartVerdict, asked: Part, exact: Wording, decimals: Wording) -> list[Line]:
    """What was submitted for a part: a student's decimals are shown as decimals, what is exact as it is."""
    declared = catalogue()[asked.task].answers
    lines = []
    for answer in part.answers.values():
        wording = decimals if answer.in_decimals else exact
        tex = "" if answer.value is None else wording.equation(wording.symbol(declared[answer.name]), answer.value)
        words = tuple(map(_sentence, _remarks(answer, wording.say)))
        lines.append(Line(answer.name, tex, str(answer.verdict), words))
    return lines


def _sentence(words: str) -> str:
    """Begin with a capital letter where it begins with a letter."""
    return words[:1].upper() + words[1:]


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


__all__ = ["as_csv", "as_data", "as_json", "print_marking", "render_sheet"]
