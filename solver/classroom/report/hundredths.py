"""Marks in hundredths that add up: those of the answers to those of their part, those of the parts to the total."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from solver.classroom.verdicts import Marking
from solver.problem.hundredths import HUNDRED, dealt


def marks_that_add_up(marking: Marking) -> tuple[Fraction, Mapping[str, Fraction], Mapping[tuple[str, str], Fraction]]:
    """Return the total, the marks of the parts by id, and those of the answers by id and name, rounded to hundredths.

    The total is rounded; what is left over of rounding down goes to those that lost most by it.
    """
    total = _rounded(marking.marks)
    of_parts = dealt(total, [part.marks for part in marking.parts])
    answers: dict[tuple[str, str], Fraction] = {}
    for part, marks in zip(marking.parts, of_parts, strict=True):
        of_answers = dealt(marks, [answer.marks for answer in part.answers.values()])
        answers |= {(part.id, name): each for name, each in zip(part.answers, of_answers, strict=True)}
    return total, {part.id: each for part, each in zip(marking.parts, of_parts, strict=True)}, answers


def _rounded(marks: Fraction) -> Fraction:
    """Return marks to the nearest hundredth, a half of one up."""
    return Fraction((marks * HUNDRED + Fraction(1, 2)) // 1, HUNDRED)
