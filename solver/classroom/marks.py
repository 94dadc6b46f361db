"""The marks of a part: how they are split over its answers, and what is earned of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from solver.classroom.verdicts import AnswerVerdict, Verdict
from solver.problem.asked import asked_of
from solver.problem.hundredths import told_in_hundredths
from solver.problem.model import Part, Partial
from solver.tasks import catalogue

USUAL_COST = Fraction(1, 2)
"""The part of an answer's marks that a named mistake costs where the problem does not say how much."""


def carried(part: Part, ours: Mapping[str, Any], out_of: Fraction) -> dict[str, Fraction]:
    """Return the marks that each answer carries: its own where the problem gives them, else equal ones for those asked.

    Those asked for are what the part names, else the principal answers of its task, as far as this question has them.
    Where the part tells its marks they are those that a key prints: in hundredths that add up.
    """
    if part.answer_marks:
        each = {name: fraction(marks) for name, marks in part.answer_marks.items()}
    else:
        named = part.asked or asked_of(part, catalogue()[part.task])
        asked = [name for name in named if name in ours] or part.asked
        each = {name: out_of / len(asked) for name in asked}
    return each if part.marks is None else dict(zip(each, told_in_hundredths(list(each.values())), strict=True))


def marked(
    verdicts: Mapping[str, AnswerVerdict], each: Mapping[str, Fraction], partial: Mapping[str, Partial]
) -> dict[str, AnswerVerdict]:
    """Return the verdicts with their marks, none for what was not asked for; `partial` says what wrong answers earn."""
    found: dict[str, AnswerVerdict] = {}
    for name, verdict in verdicts.items():
        out_of = each.get(name, Fraction(0))
        found[name] = replace(verdict, marks=earned(verdict, out_of, partial.get(name, Partial())), out_of=out_of)
    return found


def earned(verdict: AnswerVerdict, out_of: Fraction, partial: Partial) -> Fraction:
    """Return the marks of an answer: of a wrong one in proportion to what is right, unless `partial` says otherwise."""
    if verdict.verdict is Verdict.WRONG:
        if partial.rule == "none":
            return Fraction(0)
        if (cost := _cost(verdict, out_of, partial)) is not None:
            return max(Fraction(0), out_of - cost)
    return out_of * verdict.share


def _cost(verdict: AnswerVerdict, out_of: Fraction, partial: Partial) -> Fraction | None:
    """What the mistake that was found costs; None where none was, or where it costs nothing by its name."""
    if partial.rule != "named" or not verdict.mistake:
        return None
    if partial.costs is None:
        return out_of * USUAL_COST
    cost = partial.costs.get(verdict.mistake)
    return None if cost is None else fraction(cost)


def left_out(each: Mapping[str, Fraction], submitted: Collection[str]) -> dict[str, Fraction]:
    """Return the answers that carry marks and were not submitted."""
    return {name: marks for name, marks in each.items() if name not in submitted}


def fraction(number: Any) -> Fraction:
    """Return a rational number of sympy as Python's."""
    return Fraction(int(number.p), int(number.q))
