"""Eigenvectors that are told with their eigenvalues, in the order of the eigenvalues that were submitted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from solver.classroom.submitted import Submitted


def arranged(submitted: Mapping[str, Submitted], *, rows: Mapping[str, bool]) -> dict[str, Submitted]:
    """Return what was submitted with such vectors in the order of the eigenvalues, or of the Jordan form's diagonal.

    `rows` tells of each answer whether its vectors are rows. Where neither was submitted the vectors stay as they are.
    """
    order = _order(submitted)
    return {
        name: _in_order(each, order, in_rows=rows.get(name, False)) if each.eigenvalues and order else each
        for name, each in submitted.items()
    }


def _order(submitted: Mapping[str, Submitted]) -> Sequence[Any]:
    for name in ("eigenvalues", "jordan_form"):
        value: Any = submitted[name].value if name in submitted else None
        if isinstance(value, list):
            return value
        if isinstance(value, sp.MatrixBase) and value.is_square:
            return [value[i, i] for i in range(value.rows)]
    return ()


def _in_order(each: Submitted, order: Sequence[Any], *, in_rows: bool) -> Submitted:
    """The vectors with their eigenvalues, the one that is nearest to the first of the order first."""
    told = each.eigenvalues
    value: Any = each.value
    count = value.rows if in_rows else value.cols
    if told is None or not len(order) == len(told.value) == count:
        return each
    left, places = list(range(count)), list[int]()
    for wanted in order:
        places.append(min(left, key=lambda i: _distance(told.value[i], wanted)))
        left.remove(places[-1])
    value, form = (
        sp.ImmutableMatrix(side[places, :] if in_rows else side[:, places]) for side in (each.value, each.form)
    )
    listed = replace(told, value=[told.value[i] for i in places], form=[told.form[i] for i in places])
    return replace(each, value=value, form=form, eigenvalues=listed)


def _distance(told: Any, wanted: Any) -> float:
    """How far two numbers are apart; of formulas whether they are the same."""
    difference = told - wanted
    return float(abs(sp.N(difference))) if difference.is_number else float(sp.expand(difference) != 0)
