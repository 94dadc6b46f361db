"""The marks of a part: how they are split over its answers, and what is earned of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from solver.classroom.verdicts import AnswerVerdict
from solver.problem.asked import asked_of
from solver.problem.model import Part
from solver.tasks import catalogue


def carried(part: Part, ours: Mapping[str, Any], out_of: Fraction) -> dict[str, Fraction]:
    """Return the marks that each answer carries: its own where the problem gives them, else equal ones for those asked.

    Those asked for are what the part names, else the principal answers of its task that this question has.
    """
    if part.answer_marks:
        return {name: fraction(marks) for name, marks in part.answer_marks.items()}
    asked = part.asked or [name for name in asked_of(part, catalogue()[part.task]) if name in ours]
    return {name: out_of / len(asked) for name in asked}


def marked(verdicts: Mapping[str, AnswerVerdict], each: Mapping[str, Fraction]) -> dict[str, AnswerVerdict]:
    """Return the verdicts with their marks: in proportion to what is right, none for what was not asked for."""
    nothing = Fraction(0)
    return {
        name: replace(verdict, marks=each.get(name, nothing) * verdict.share, out_of=each.get(name, nothing))
        for name, verdict in verdicts.items()
    }


def left_out(each: Mapping[str, Fraction], submitted: Collection[str]) -> dict[str, Fraction]:
    """Return the answers that carry marks and were not submitted."""
    return {name: marks for name, marks in each.items() if name not in submitted}


def fraction(number: Any) -> Fraction:
    """Return a rational number of sympy as Python's."""
    return Fraction(int(number.p), int(number.q))
