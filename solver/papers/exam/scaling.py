"""The marks of the parts of a question, scaled to those of the question."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from solver.problem.hundredths import HUNDRED, dealt
from solver.problem.model import Part, Partial, Problem


def marks_told(problem: Problem) -> list[sp.Rational]:
    """Return the marks of the parts: those of the file; where it tells none at all each part carries one."""
    told = [part.marks for part in problem.parts]
    return [sp.Integer(1) if not any(each is not None for each in told) else each or sp.Integer(0) for each in told]


def scaled(problem: Problem, marks: sp.Rational | None) -> Problem:
    """Return the problem with parts that carry `marks` together, as they told them where that is None.

    Marks are printed and counted in hundredths: 20 over three equal parts are 6.67, 6.67 and 6.66. What is smaller in
    the file stays exact.
    """
    told = marks_told(problem)
    total = sum(told, sp.Integer(0))
    wanted = told if marks is None else [each * marks / total for each in told]
    if any((each * HUNDRED).q != 1 for each in wanted) and marks is not None and (marks * HUNDRED).q == 1:
        shares = dealt(Fraction(marks.p, marks.q), [Fraction(each.p, each.q) for each in wanted])
        wanted = [sp.Rational(each.numerator, each.denominator) for each in shares]
    parts = [_part(*each) for each in zip(problem.parts, told, wanted, strict=True)]
    return replace(problem, parts=tuple(parts))


def _part(part: Part, old: sp.Rational, new: sp.Rational) -> Part:
    """Return a part with other marks; those of its answers, and what mistakes cost, change with them."""
    factor = new / old if old else sp.Integer(1)
    partial = {name: _costs(each, factor) for name, each in part.partial.items()}
    return replace(part, marks=new, answer_marks=_times(part.answer_marks, factor), partial=partial)


def _costs(partial: Partial, factor: sp.Rational) -> Partial:
    return partial if partial.costs is None else replace(partial, costs=_times(partial.costs, factor))


def _times(marks: Mapping[str, Any], factor: sp.Rational) -> dict[str, Any]:
    return {name: value * factor for name, value in marks.items()}
