"""Mistakes seen in the value beside ours: signs of entries, the order of a list, digits cut off."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from solver.classroom.judging.entries import all_right, entrywise
from solver.classroom.mistakes.values import Case
from solver.classroom.submitted import Decimal, Submitted
from solver.classroom.verdicts import Verdict
from solver.derivation import Slip
from solver.derivation import usual_mistakes as usual

ALMOST = sp.Rational(999, 1000)
"""The part of a unit up to which digits are cut off; a whole unit farther is another digit."""


def _signs(submitted: Submitted, case: Case) -> int:
    """In how many entries a matrix has the wrong sign; 0 if anything else is wrong."""
    right = entrywise(submitted, case.ours)
    if not isinstance(case.ours, sp.MatrixBase) or right is None:
        return 0
    minus = entrywise(submitted, sp.ImmutableMatrix(-case.ours))
    pairs = [pair for rows in zip(right, minus, strict=True) for pair in zip(*rows, strict=True)]
    return sum(pair[0] != Verdict.CORRECT for pair in pairs) if all(Verdict.CORRECT in pair for pair in pairs) else 0


def _one_sign(submitted: Submitted, case: Case) -> bool:
    return _signs(submitted, case) == 1


def _some_signs(submitted: Submitted, case: Case) -> bool:
    return _signs(submitted, case) > 1


def _other_order(submitted: Submitted, case: Case) -> bool:
    """Whether each item of a list is right, but not at its place."""
    if not isinstance(case.ours, list) or not case.question.task.answers[case.name].ordered:
        return False
    return _right(submitted, case) and not all_right(entrywise(submitted, case.ours, ordered=True))


def _cut_off(submitted: Submitted, case: Case) -> bool:
    """Whether decimals stand for numbers whose further digits are cut off, not rounded: up to a unit farther from 0."""
    beyond = {symbol: _beyond(each) for symbol, each in submitted.decimals.items()}
    return bool(beyond) and _right(replace(submitted, decimals=beyond), case)


def _beyond(decimal: Decimal) -> Decimal:
    half = decimal.half_unit * ALMOST
    return decimal._replace(number=decimal.number + half * (1 if decimal.number >= 0 else -1), half_unit=half)


def _right(submitted: Submitted, case: Case) -> bool:
    entries = entrywise(submitted, case.ours)
    return entries not in (None, []) and all_right(entries)


ALIKE: tuple[tuple[Slip, Callable[[Submitted, Case], bool]], ...] = (
    (usual.SIGN_OF_ENTRY, _one_sign),
    (usual.SIGNS_OF_ENTRIES, _some_signs),
    (usual.ITEMS_IN_ORDER, _other_order),
    (usual.CUT_OFF, _cut_off),
)
