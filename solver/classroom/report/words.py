"""What is said of a marking wherever it is shown: marks, remarks, the places of what is wrong."""

from __future__ import annotations

from fractions import Fraction

from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.document.checks import Say
from solver.problem.hundredths import rounded
from solver.render.prose import inline_as_text
from solver.words import Phrase


def number(marks: Fraction) -> int | float:
    """Return marks as a number of JSON, to two decimals, a half of a hundredth up."""
    told = rounded(marks)
    return int(told) if told.denominator == 1 else float(told)


def earned(marked: Marking | PartVerdict | AnswerVerdict) -> Phrase:
    """Return how many marks are earned: "2 of 3"."""
    return Phrase("{marks} of {out_of}", marks=number(marked.marks), out_of=number(marked.out_of))


def verdict_of(answer: AnswerVerdict) -> str:
    """Return the verdict, and who gave it where that was not the program."""
    return (
        Phrase("{verdict}, by the instructor", verdict=str(answer.verdict)) if answer.by_instructor else answer.verdict
    )


def to_be_reviewed(marking: Marking, say: Say) -> str:
    """Return what a person should look at, and why: "needs review: b.K (not judged)"; "" for nothing."""
    answers = [(f"{part.id}.{name}", answer) for part in marking.parts for name, answer in part.answers.items()]
    because = [
        say(Phrase("{answer} ({why})", answer=name, why=_why_to_review(answer)))
        for name, answer in answers
        if answer.needs_review
    ]
    return say(Phrase("needs review: {answers}", answers=", ".join(because))) if because else ""


def _why_to_review(answer: AnswerVerdict) -> str:
    return str(answer.verdict) if answer.verdict is Verdict.NOT_JUDGED else "several readings"


def in_a_line(answer: AnswerVerdict, say: Say) -> str:
    """What is said of a verdict in a line of text."""
    said = "; ".join(inline_as_text(each) for each in remarks(answer, say))
    return f" – {said}" if said else ""


def remarks(answer: AnswerVerdict, say: Say) -> list[str]:
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
