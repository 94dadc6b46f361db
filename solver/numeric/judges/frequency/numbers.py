"""Loops of formulas as loops of numbers: on the imaginary axis, or with a sampling period on the unit circle."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.numeric.judges.frequency.loops import WORKING, NumericLoop, number_of, roots_outside, unstable_poles
from solver.numeric.judges.frequency.sampled import sampled_loop


def numeric_loop(numerator: Any, denominator: Any, s: Any, delay: Any, sample_time: Any = None) -> NumericLoop:
    """Return a loop of numbers, what N and D have in common cancelled by its roots being met in both."""
    above, below = sp.fraction(sp.cancel(numerator / denominator))
    return _loop(above, below, s, delay, sample_time)


@lru_cache(maxsize=64)
def closed_loop_poles(numerator: Any, denominator: Any, s: Any, delay: Any, sample_time: Any = None) -> tuple[int, int]:
    """How many poles of a closed loop lie to the right and on the axis (beside the circle), nothing cancelled in L."""
    with mpmath.workdps(WORKING):
        if delay == 0:
            return unstable_poles(_loop(numerator, denominator, s, delay, sample_time))
        hidden = sp.gcd(sp.Poly(numerator, s), sp.Poly(denominator, s))
        seen = unstable_poles(numeric_loop(numerator, denominator, s, delay))
        unseen = roots_outside(hidden.all_coeffs())
        return seen[0] + unseen[0], seen[1] + unseen[1]


def _loop(numerator: Any, denominator: Any, s: Any, delay: Any, sample_time: Any) -> NumericLoop:
    with mpmath.workdps(WORKING):
        N, D = (tuple(number_of(c) for c in sp.Poly(p, s).all_coeffs()) for p in (numerator, denominator))
        if sample_time is not None:
            return sampled_loop(N, D, sample_time)
        return NumericLoop(N, D, number_of(sp.S.Zero + delay))


__all__ = ["closed_loop_poles", "numeric_loop"]
