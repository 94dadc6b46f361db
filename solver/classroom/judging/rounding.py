"""Whether rounding explains what is left of a defining property that has many right answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

from solver.classroom.judging.question import Question, checks_of
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import Check
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


def _is_number(residual: float | None) -> bool:
    return residual is not None and residual < float("inf")


def _moved(each: Submitted, shares: Any) -> dict[Any, Any]:
    """The decimals moved by shares of their half units."""
    exact = [sp.Rational(round(share * FINE), FINE) for share in shares]
    pairs = zip(each.decimals.items(), exact, strict=True)
    return {symbol: decimal.number + decimal.half_unit * share for (symbol, decimal), share in pairs}
