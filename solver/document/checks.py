"""The table of checks of a part: one line for the equalities of each step, then one for each other check."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import lru_cache

from solver.derivation import Check, CheckStatus
from solver.document.model import CheckRow, WorkStep
from solver.render.numbers import NumberFormat
from solver.words import Phrase

Say = Callable[[str], str]
"""Words a phrase in the language of the document."""


def check_rows(checks: Sequence[Check], steps: Sequence[WorkStep], say: Say) -> list[CheckRow]:
    """Return the table of checks: one line for the equalities of each step, then one for each other check.

    Steps are numbered as they are shown; the equalities of those that are not shown are one line.
    """
    rows = []
    for number, step in enumerate(steps, start=1):
        rows.extend(_of_step([check for check in checks if check.step in step.covers], number, say))
    shown = {number for step in steps for number in step.covers}
    rows.extend(_of_step([check for check in checks if check.step and check.step not in shown], 0, say))
    return rows + [_row(check, say) for check in checks if not check.step]


def _of_step(checks: Sequence[Check], number: int, say: Say) -> list[CheckRow]:
    """Return one line for the equalities of a step that passed, then one for each that did not; 0: of none shown."""
    passed = [check for check in checks if check.status is CheckStatus.PASSED]
    others = [_row(check, say) for check in checks if check.status is not CheckStatus.PASSED]
    if not passed:
        return others
    worst = max(passed, key=_nearness)
    claim: str = Phrase("the equality of step {step}", step=number)
    if not number:
        claim = Phrase("equalities of steps that are not shown at this level: {count}", count=len(passed))
    elif len(passed) > 1:
        claim = Phrase("{count} equalities of step {step}", count=len(passed), step=number)
    elif worst.claim:
        claim = Phrase("{claim} (step {step})", claim=worst.claim, step=number)
    oracle = ", ".join(dict.fromkeys(say(check.oracle) for check in passed))
    return [CheckRow(say(claim), oracle, _short(worst.residual), _short(worst.tolerance), CheckStatus.PASSED), *others]


def _nearness(check: Check) -> float:
    """Residual as a part of the tolerance."""
    if check.residual is None or not check.tolerance:
        return 0.0
    return check.residual / check.tolerance


def _row(check: Check, say: Say) -> CheckRow:
    errors = _short(check.residual), _short(check.tolerance)
    return CheckRow(say(check.claim), say(check.oracle), *errors, check.status, say(check.reason))


def unchecked(checks: Iterable[Check], say: Say) -> str:
    """Return how many checks could not be made, and why (Markdown); empty where all were made."""
    reasons = [say(check.reason) for check in checks if check.status is CheckStatus.SKIPPED]
    listed = "; ".join(dict.fromkeys(reasons))
    return say(Phrase("{count} could not be checked: {reasons}", count=len(reasons), reasons=listed)) if reasons else ""


@lru_cache(maxsize=512)  # tolerances are few, and pages number the rows again
def _short(number: float | None) -> str:
    """Two significant digits are enough for an error."""
    return "" if number is None else NumberFormat("decimal", 2).decimal(number)


def plain_check(check: Check, say: Say = str) -> Check:
    """Return a check as a document has it, in the words of its language; its numbers and texts are Python's own."""
    residual, tolerance = (None if each is None else float(each) for each in (check.residual, check.tolerance))
    claim, oracle, reason = map(say, (check.claim, check.oracle, check.reason))
    return replace(check, claim=claim, oracle=oracle, residual=residual, tolerance=tolerance, reason=reason, sides=None)
