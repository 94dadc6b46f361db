"""An equality that a wrong value breaks, told by the numbers on its two sides."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from solver.derivation import Check
from solver.stated import Stated
from solver.tasks.meanings import difference_of
from solver.words import Reason


def broken(checks: Iterable[Check], value: Any) -> Reason | None:
    """Return where the sides of an equality differ, None where none can be told.

    The value stands within a formula of one side: where it stands alone, the other side is the right value itself.
    """
    for check in checks:
        if check.sides is not None and any(_holds(side, value) for side in check.sides):
            told = difference_of(*check.sides)
            if told is not None:
                return Reason("meanings/equality", {"claim": check.claim, **told})
    return None


def _holds(side: Any, value: Any) -> bool:
    """Whether a side is a formula of the value, not the value alone."""
    return isinstance(side, Stated) and any(
        each is value or (not isinstance(each, Stated) and type(each) is type(value) and each == value)
        for each in _operands(side)
    )


def _operands(formula: Stated) -> Iterable[Any]:
    for operand in formula.operands:
        yield operand
        if isinstance(operand, Stated):
            yield from _operands(operand)
