"""How near the sides of an equality must be: by what they are made of.

What is exact on both sides agrees to all digits there are; doubles tell that it does not, and many digits that it does.
Decimals are known to their own digits, and so is what is found by samples: integrals, transforms, limits.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from solver.numeric.evaluation.points import holds_decimals
from solver.numeric.evaluation.stated import about
from solver.stated import Stated

TOLERANCE = 1e-9
"""The largest relative difference of values that are known in doubles."""


class Precision(NamedTuple):
    """Relative differences: up to which doubles settle that values agree, and up to which they do with many digits."""

    settled: float
    tolerance: float


DECIMALS = Precision(TOLERANCE, TOLERANCE)
SAMPLES = Precision(1e-10, 1e-10)
SHOWN = Precision(1e-10, 1e-10)
EXACT = Precision(1e-10, 1e-20)


def precision_of(*formulas: Any, shown: bool = False) -> Precision:
    """Return how near formulas must be to each other; `shown`: what a step displays, which doubles may settle."""
    if holds_decimals(formulas):
        return DECIMALS
    if is_sampled(formulas):
        return SAMPLES
    return SHOWN if shown else EXACT


def is_sampled(formula: Any) -> bool:
    """Whether the formula holds an operation that is evaluated by samples."""
    if isinstance(formula, Stated):
        return bool(about(formula.operation, "SAMPLED")) or any(map(is_sampled, formula.operands))
    return isinstance(formula, list | tuple) and any(map(is_sampled, formula))
