"""A marking with an instructor's changes in it."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from solver.classroom.reading.change_file import Change, PartChanges, StudentChanges
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.problem.source import Report

ROUNDED = Fraction(1, 200)
"""By so much the marks that an answer carries are rounded where they are shown."""


def changed(marking: Marking, changes: StudentChanges) -> Marking:
    """Return the marking with the changes; raises Fault where an answer would earn more than it carries."""
    report = Report()
    parts = tuple(
        _part(part, changes.parts[part.id], report) if part.id in changes.parts else part for part in marking.parts
    )
    report.conclude()
    return replace(marking, parts=parts, comment=changes.comment)


def _part(part: PartVerdict, changes: PartChanges, report: Report) -> PartVerdict:
    answers, missing = dict(part.answers), dict(part.missing)
    for name, change in changes.answers.items():
        before = answers.get(name) or AnswerVerdict(name, Verdict.NOT_JUDGED, out_of=missing.pop(name, Fraction(0)))
        with report:
            answers[name] = _answer(before, change)
    marks = sum((answer.marks for answer in answers.values()), Fraction(0))
    note = part.note if any(answer.needs_review for answer in answers.values()) or not answers else ""
    return replace(part, answers=answers, missing=missing, marks=marks, note=note, comment=changes.comment)


def _answer(answer: AnswerVerdict, change: Change) -> AnswerVerdict:
    """Return the verdict of an answer as the instructor has it; what the program said of it goes with its verdict."""
    if change.marks is not None and change.marks > answer.out_of + ROUNDED:
        raise change.stated.fault(f"{answer.name} carries {float(answer.out_of):g} marks, no more")
    if change.verdict is None and change.marks is None:
        return replace(answer, comment=change.comment)
    verdict = answer.verdict if change.verdict is None else change.verdict
    kept = verdict is answer.verdict
    if change.marks is not None:
        marks = min(change.marks, answer.out_of)
    else:
        marks = answer.marks if kept else answer.out_of * (verdict is Verdict.CORRECT)
    return replace(
        answer,
        verdict=verdict,
        marks=marks,
        reason=answer.reason if kept else "",
        note=answer.note if kept else "",
        entries=answer.entries if kept else None,
        follows=kept and answer.follows,
        by_instructor=True,
        comment=change.comment,
    )
