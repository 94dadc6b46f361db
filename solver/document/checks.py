"""The table of checks of a part: one line for the equalities of each step, then one for each other check."""

from __future__ import annotations

from dataclasses import replace

from solver.derivation import Check, CheckStatus, PartResult
from solver.document.model import CheckRow
from solver.render.numbers import NumberFormat


def check_rows(result: PartResult) -> list[CheckRow]:
    """Return the table of checks: one line for the equalities of each step, then one for each other check."""
    rows = []
    for number in range(1, len(result.steps) + 1):
        rows.extend(_of_step([check for check in result.checks if check.step == number], number))
    return rows + [_row(check) for check in result.checks if not check.step]


def _of_step(checks: list[Check], number: int) -> list[CheckRow]:
    """Return one line for the equalities of a step that passed, then one for each that did not."""
    passed = [check for check in checks if check.status is CheckStatus.PASSED]
    others = [_row(check) for check in checks if check.status is not CheckStatus.PASSED]
    if not passed:
        return others
    worst = max(passed, key=_nearness)
    claim = f"{len(passed)} equalities of step {number}" if len(passed) > 1 else f"the equality of step {number}"
    if len(passed) == 1 and worst.claim:
        claim = f"{worst.claim} (step {number})"
    oracle = ", ".join(dict.fromkeys(check.oracle for check in passed))
    return [CheckRow(claim, oracle, _short(worst.residual), _short(worst.tolerance), CheckStatus.PASSED), *others]


def _nearness(check: Check) -> float:
    """Residual as a part of the tolerance."""
    if check.residual is None or not check.tolerance:
        return 0.0
    return check.residual / check.tolerance


def _row(check: Check) -> CheckRow:
    return CheckRow(
        check.claim, check.oracle, _short(check.residual), _short(check.tolerance), check.status, check.reason
    )


def _short(number: float | None) -> str:
    """Two significant digits are enough for an error."""
    return "" if number is None else NumberFormat("decimal", 2).decimal(number)


def plain_check(check: Check) -> Check:
    """Return a check whose numbers are Python's own."""
    residual, tolerance = (None if each is None else float(each) for each in (check.residual, check.tolerance))
    return replace(check, residual=residual, tolerance=tolerance)
