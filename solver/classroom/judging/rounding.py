"""Whether rounding explains what is left of a defining property that has many right answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp
from sympy.core.relational import Relational

from solver.classroom.judging.question import Question, checks_of
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import Check, CheckStatus
from solver.lazy import numeric

FINE = 10**12
"""Decimals are moved by so small parts of half a unit."""


def within_rounding(
    question: Question, name: str, each: Submitted, fitting: Mapping[str, Submitted], failed: list[Check]
) -> bool:
    """Whether one choice of all decimals within half units of their last digits satisfies all checks of a value."""
    if not failed or not all(_is_number(check.residual) for check in failed):
        return False
    judged = [check for check in checks_of(question, {**fitting, name: each}) or () if name in check.judges]
    measured = [_is_number(check.residual) for check in judged]

    def sizes(moved: Any) -> Any:
        """The residuals where each decimal is moved by a share of its half unit."""
        value = replaced(each.form, _moved(each, moved))
        found = checks_of(question, {**fitting, name: Submitted(value, each.form, each.decimals)}) or ()
        checks = [check for check in found if name in check.judges]
        if [_is_number(check.residual) for check in checks] != measured:
            raise numeric.NotEvaluable("another check")
        return np.array([check.residual for check in checks if _is_number(check.residual)])

    try:
        return bool(numeric.can_vanish(sizes, len(each.decimals)))
    except numeric.NotEvaluable:
        return False


def bounds_are_rounded(question: Question, name: str, each: Submitted) -> bool:
    """Whether a condition is right with bounds of ours in place of decimals that are these bounds rounded."""
    ours = question.ours.get(name)
    if not each.decimals or not isinstance(each.form, sp.And | Relational) or not isinstance(ours, sp.And | Relational):
        return False
    sides = [side for relation in ours.atoms(Relational) for side in relation.args if side.is_number and side.is_finite]
    exact = {}
    for symbol, decimal in each.decimals.items():
        near = [side for side in sides if abs(side - decimal.number) <= decimal.half_unit]
        exact[symbol] = min(near, key=lambda side: abs(side - decimal.number), default=decimal.number)
    value = replaced(each.form, exact)
    checks = [check for check in checks_of(question, {name: Submitted(value, value)}) or () if name in check.judges]
    return bool(checks) and all(check.status is CheckStatus.PASSED for check in checks)


def _is_number(residual: float | None) -> bool:
    return residual is not None and residual < float("inf")


def _moved(each: Submitted, shares: Any) -> dict[Any, Any]:
    """The decimals moved by shares of their half units."""
    exact = [sp.Rational(round(share * FINE), FINE) for share in shares]
    pairs = zip(each.decimals.items(), exact, strict=True)
    return {symbol: decimal.number + decimal.half_unit * share for (symbol, decimal), share in pairs}
