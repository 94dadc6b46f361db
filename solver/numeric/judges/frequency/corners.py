"""Bode's form judged by roots in numbers: gain, corner frequencies, slopes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import mpmath
import numpy as np

from solver.numeric.judges.frequency.crossings import decimal
from solver.numeric.judges.frequency.loops import WORKING, NumericLoop
from solver.numeric.judges.frequency.roots import roots_of

PER_POWER = 20
SAME = 1e-12
REAL = 1e-9
MANY = 120
"""Digits for roots: multiple ones keep a part of them only."""


def _roots(loop: NumericLoop) -> tuple[list[tuple[Any, int, bool]], int]:
    """The sizes of the roots but zero with 1 (zeros) or −1 (poles), whether real; and the power of s at s = 0."""
    found, power = [], 0
    for p, sign in ((loop.N, 1), (loop.D, -1)):
        listed = list(p)
        while listed[-1] == 0:
            listed.pop()
            power += sign
        with mpmath.workdps(MANY):
            roots = roots_of(listed)
            found += [(abs(z), sign, bool(abs(mpmath.im(z)) < REAL * abs(z))) for z in roots]
    return sorted(found), power


def bode_gain_residual(loop: NumericLoop, value: Any) -> float:
    """How far a gain is, relatively, from the limit of L/s^N."""
    with mpmath.workdps(WORKING):
        parts = [next(c for c in reversed(p) if c != 0) for p in (loop.N, loop.D)]
        wanted = parts[0] / parts[1]
        return float(abs(decimal(value) - wanted) / abs(wanted))


def corner_residual(loop: NumericLoop, found: Sequence[Any]) -> float:
    """How far corners are from the sizes of the roots; those of a pair may be listed once or twice."""
    roots, _ = _roots(loop)
    sizes = [size for size, _, _ in roots]
    reals = [size for size, _, real in roots if real]
    halves = [size for size, _, real in roots if not real][::2]
    own = [decimal(each) for each in found]
    best = float("inf")
    for wanted in (sorted([*reals, *halves]), sizes):
        if len(wanted) == len(own):
            best = min(best, max((float(abs(a - b) / b) for a, b in zip(own, wanted, strict=True)), default=0.0))
    return best


def are_slopes(loop: NumericLoop, found: Sequence[Any]) -> bool:
    """Whether slopes are 20 dB a decade for each power: one for each different corner, or one for each root."""
    roots, power = _roots(loop)
    each, merged = [PER_POWER * power], [PER_POWER * power]
    level, last = PER_POWER * power, None
    for size, sign, _ in roots:
        level += PER_POWER * sign
        each.append(level)
        if last is not None and abs(size - last) < 1e-3 * size:
            merged[-1] = level
        else:
            merged.append(level)
        last = size
    own = [float(decimal(slope) / PER_POWER) for slope in found]
    return any(
        len(own) == len(wanted) and np.allclose(own, [level / PER_POWER for level in wanted], rtol=0, atol=SAME)
        for wanted in (merged, each)
    )


__all__ = ["are_slopes", "bode_gain_residual", "corner_residual"]
