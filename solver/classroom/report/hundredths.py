"""Marks in hundredths that add up: those of the answers to those of their part, those of the parts to the total."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from solver.classroom.verdicts import Marking, PartVerdict
from solver.problem.hundredths import dealt, rounded


def in_hundredths(marking: Marking) -> Marking:
    """Return a marking as it is told, on sheets as in tables: its total rounded, and what is earned adding up to it.

    What is left over of rounding down goes to those that lost most by it. What is in hundredths stays as it is.
    """
    of_parts = dealt(rounded(marking.marks), [part.marks for part in marking.parts])
    parts = tuple(_part(part, marks) for part, marks in zip(marking.parts, of_parts, strict=True))
    return replace(marking, parts=parts)


def _part(part: PartVerdict, marks: Fraction) -> PartVerdict:
    of_answers = dealt(marks, [answer.marks for answer in part.answers.values()])
    answers = {
        name: replace(answer, marks=each) for (name, answer), each in zip(part.answers.items(), of_answers, strict=True)
    }
    return replace(part, answers=answers, marks=marks)
