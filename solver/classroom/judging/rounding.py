"""Whether rounding explains what is left of a defining property that has many right answers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from solver.classroom.judging.question import Question, checks_of
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import Check


def within_rounding(
    question: Question, name: str, each: Submitted, fitting: Mapping[str, Submitted], failed: list[Check]
) -> bool:
    """Whether rounding explains what is left of a defining property that has many right answers.

    To first order: the residual is at most the sum of what moving each decimal by half a unit changes in it.
    """
    if not failed or not _numbers(failed):
        return False
    allowed = 0.0
    for symbol, decimal in each.decimals.items():
        changes = [
            abs(moved - start)
            for half in (decimal.half_unit, -decimal.half_unit)
            for start, moved in _residuals(question, name, each, fitting, symbol, decimal.number + half)
        ]
        allowed += max(changes, default=0.0)
    return all(check.residual <= 1.05 * allowed + 1e-9 for check in failed if check.residual is not None)


def _numbers(checks: Iterable[Check]) -> bool:
    return all(check.residual is not None and check.residual < float("inf") for check in checks)


def _residuals(
    question: Question, name: str, each: Submitted, fitting: Mapping[str, Submitted], symbol: Any, value: Any
) -> list[tuple[float, float]]:
    """Pairs of residuals of the same checks, before and after one decimal is moved."""
    at = {other: decimal.number for other, decimal in each.decimals.items()} | {symbol: value}
    moved = Submitted(replaced(each.form, at), each.form)
    before, after = (checks_of(question, {**fitting, name: which}) or [] for which in (each, moved))
    return [
        (a.residual, b.residual)
        for a, b in zip(before, after, strict=False)
        if name in a.judges and a.residual is not None and b.residual is not None
    ]
