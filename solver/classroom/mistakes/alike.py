"""Mistakes seen in the value beside ours: signs of entries, the order of a list, digits cut off."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import product

import sympy as sp

from solver.classroom.judging.entries import all_right, entrywise, same, same_entry
from solver.classroom.mistakes.values import Case
from solver.classroom.submitted import Decimal, Submitted
from solver.derivation import Slip
from solver.derivation import usual_mistakes as usual

ALMOST = sp.Rational(999, 1000)
"""The part of a unit up to which digits are cut off; a whole unit farther is another digit."""


def _signs(submitted: Submitted, case: Case) -> int:
    """In how many entries a matrix has the wrong sign; 0 if anything else is wrong."""
    M, count = case.ours, 0
    if not isinstance(M, sp.MatrixBase) or submitted.value.shape != M.shape:
        return 0
    for i, j in product(range(M.rows), range(M.cols)):
        if not same_entry(submitted, i, j, M[i, j]):
            if not same_entry(submitted, i, j, -M[i, j]):
                return 0
            count += 1
    return count


def _one_sign(submitted: Submitted, case: Case) -> bool:
    return _signs(submitted, case) == 1


def _some_signs(submitted: Submitted, case: Case) -> bool:
    return _signs(submitted, case) > 1


def _other_order(submitted: Submitted, case: Case) -> bool:
    """Whether each item of a list is right, but not at its place."""
    if not isinstance(case.ours, list) or not case.question.task.answers[case.name].ordered:
        return False
    return same(submitted, case.ours) and not all_right(entrywise(submitted, case.ours, ordered=True))


def _cut_off(submitted: Submitted, case: Case) -> bool:
    """Whether decimals stand for numbers whose further digits are cut off, not rounded: up to a unit farther from 0."""
    beyond = {symbol: _beyond(each) for symbol, each in submitted.decimals.items()}
    return bool(beyond) and same(replace(submitted, decimals=beyond), case.ours)


def _beyond(decimal: Decimal) -> Decimal:
    half = decimal.half_unit * ALMOST
    return decimal._replace(number=decimal.number + half * (1 if decimal.number >= 0 else -1), half_unit=half)


ALIKE: tuple[tuple[Slip, Callable[[Submitted, Case], bool]], ...] = (
    (usual.SIGN_OF_ENTRY, _one_sign),
    (usual.SIGNS_OF_ENTRIES, _some_signs),
    (usual.ITEMS_IN_ORDER, _other_order),
    (usual.CUT_OFF, _cut_off),
)
