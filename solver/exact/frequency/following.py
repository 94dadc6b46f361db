"""The phase followed along the axis, with a dead time or without: where it takes a value.

Between the frequencies at which its slope, a quotient of polynomials, changes sign, and those of poles and zeros on the
axis, it is monotone and continuous and passes a value at most once.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.surds import WORKING, decimal
from solver.exact.linear_algebra.spectrum import DIGITS

STEPS = 400
"""So often is an interval halved at most."""

BESIDE = mpmath.mpf(10) ** (10 - DIGITS)
"""So near, relatively, to a pole or zero on the axis the phase has its limit."""

HALF_TURN = 180


def turning_points(L: OnAxis) -> list[Any]:
    """Frequencies between which the phase is monotone and continuous, rising: those of a pole or zero on the axis too.

    ∠L' = (R I + 2w (R I' − I R'))/(|N|² |D|²) − T.
    """
    R, I, w = L.parts.real, L.parts.imaginary, L.parts.w
    g = R.gcd(I)
    R, I = R.quo(g), I.quo(g)
    twice = sp.Poly(2 * w, w, domain=R.domain)
    above = R * I + twice * (R * I.diff() - I * R.diff())
    below = R * R + sp.Poly(w, w, domain=R.domain) * I * I
    size = max(above.degree(), below.degree(), 0)
    with mpmath.workdps(2 * DIGITS):
        T = decimal(L.delay)
        listed = [decimal(above.nth(i)) - T * decimal(below.nth(i)) for i in range(size, -1, -1)]
        while listed and listed[0] == 0:
            listed.pop(0)
        zeros = mpmath.polyroots(listed, maxsteps=1000, extraprec=600) if len(listed) > 1 else []
        found = [mpmath.sqrt(mpmath.re(z)) for z in zeros if mpmath.re(z) > 0]
        found += [r.imag for r, _ in L.roots if r.real == 0]
    return sorted(found)


def _pieces(L: OnAxis, stop: Any) -> Iterator[tuple[Any, Any]]:
    """Intervals of monotone phase from 0 to a frequency."""
    inner = [each for each in turning_points(L) if each < stop]
    for a, b in pairwise([mpmath.mpf(0), *inner, stop]):
        low, high = a * (1 + BESIDE), b * (1 - BESIDE)
        if high > low:
            yield low, high


def levels(L: OnAxis, beyond: Any) -> Iterator[tuple[Any, int, int]]:
    """Frequencies where L is real, the continuous phase there, and 1 where it falls, −1 where it rises.

    Up to the first beyond all turning points and `beyond` where L is negative.
    """
    last = max([beyond, *turning_points(L)])
    stop = last + mpmath.mpf(3) * mpmath.pi / decimal(L.delay) + 1
    while L.turned(stop) > L.turned(last) - 361:
        stop *= 2
    for low, high in _pieces(L, stop):
        for omega, level, turn in _between(L, low, high):
            yield omega, level, turn
            if omega > last and level % 360 == HALF_TURN:
                return


def _between(L: OnAxis, low: Any, high: Any) -> list[tuple[Any, int, int]]:
    """The multiples of 180° that a monotone phase passes inside an interval."""
    first, final = L.turned(low), L.turned(high)
    bottom, top = min(first, final), max(first, final)
    first_whole, last_whole = int(mpmath.floor(bottom / HALF_TURN)) + 1, int(mpmath.ceil(top / HALF_TURN)) - 1
    levels = range(first_whole, last_whole + 1)
    found = [(_bisected(L, low, high, HALF_TURN * k), HALF_TURN * k, 1 if final < first else -1) for k in levels]
    return sorted(found)


def _bisected(L: OnAxis, low: Any, high: Any, level: Any) -> Any:
    """The frequency between two where a monotone phase has a value."""
    falls = L.turned(high) < L.turned(low)
    for _ in range(STEPS):
        middle = (low + high) / 2
        if high - low <= abs(high) * mpmath.mpf(10) ** (-DIGITS - 8):
            break
        if (L.turned(middle) > level) == falls:
            low = middle
        else:
            high = middle
    return (low + high) / 2


@lru_cache(maxsize=64)
def phase_crossings(L: OnAxis, degrees: sp.Expr) -> tuple[sp.Expr, ...]:
    """All ω > 0 where the continuous phase has a value in degrees, rising: in decimals of 30 digits."""
    with mpmath.workdps(WORKING):
        level = decimal(sp.S.Zero + degrees)
        turning = turning_points(L)
        stop = 2 * max([mpmath.mpf(1), *turning, *(abs(r) for r, _ in L.roots)])
        final = _final_phase(L)
        while final is None and L.turned(stop) > level:
            stop *= 2
        if final is not None and L.turned(stop) != final:
            while (L.turned(stop) - level) * (final - level) < 0:
                stop *= 2
        found = []
        for low, high in _pieces(L, stop):
            if (L.turned(low) - level) * (L.turned(high) - level) < 0:
                found.append(sp.Float(_bisected(L, low, high, level), DIGITS))
        return tuple(found)


def _final_phase(L: OnAxis) -> Any:
    """The continuous phase for ω → ∞; None where it falls for ever."""
    if L.late:
        return None
    c, power = L.start
    total = mpmath.mpf(90) * power - (180 if decimal(c) < 0 else 0)
    for r, m in L.roots:
        total += m * (90 if r.real <= 0 else -90) * (2 if r.imag else 1)
    return total


__all__ = ["HALF_TURN", "levels", "phase_crossings", "turning_points"]
