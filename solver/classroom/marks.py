"""The marks of a part: how they are split over its answers, and what is earned of them."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from solver.classroom.verdicts import AnswerVerdict
from solver.problem.asked import asked_of
from solver.problem.model import Part
from solver.tasks import catalogue


def earned(part: Part, ours: Mapping[str, Any], verdicts: Mapping[str, AnswerVerdict], out_of: Fraction) -> Fraction:
    """Return the marks of a part: each answer's own where the problem gives them, else equal ones for those asked for.

    Those asked for are what the part names, else the principal answers of its task that this question has. Each earns
    in proportion to what is right in it; what is not submitted earns nothing, and so does what was not asked for.
    """
    if part.answer_marks:
        each = {name: fraction(marks) for name, marks in part.answer_marks.items()}
    else:
        asked = part.asked or [name for name in asked_of(part, catalogue()[part.task]) if name in ours]
        each = {name: out_of / len(asked) for name in asked}
    return sum((each[name] * verdict.share for name, verdict in verdicts.items() if name in each), Fraction(0))


def fraction(number: Any) -> Fraction:
    """Return a rational number of sympy as Python's."""
    return Fraction(int(number.p), int(number.q))
