"""Roots and tops: zeros of polynomials in many digits, multiple ones too, and where a magnitude is largest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import mpmath
import sympy as sp


def roots_of(listed: Sequence[Any]) -> list[Any]:
    """The zeros of a polynomial, the highest power first, as often as they count, in the digits that are set.

    Each factor without multiple zeros by itself: at a multiple zero the iteration does not converge.
    """
    exact = sp.Poly([_exactly(c) for c in listed], sp.Dummy("x"))
    found = []
    for factor, times in exact.sqf_list()[1] if exact.degree() > 0 else ():
        coefficients = [mpmath.mpmathify(c) for c in factor.all_coeffs()]
        zeros = mpmath.polyroots(coefficients, maxsteps=2000, extraprec=4 * mpmath.mp.prec, error=False)
        found += [z for z in zeros for _ in range(times)]
    return found


def _exactly(c: Any) -> sp.Rational:
    """The number that a binary one is, without rounding."""
    x = mpmath.mpf(mpmath.re(c))
    size, power = x.man_exp
    return sp.Rational(int(size)) * sp.Integer(2) ** power * (-1 if x < 0 else 1)


def top_between(omega: Any, i: int, value: Callable[[Any], Any]) -> Any:
    """Where a magnitude is largest near the i-th of some frequencies that rise, by the sign of its slope."""
    step = mpmath.mpf(10) ** -12

    def rises(w: Any) -> bool:
        return bool(abs(value(w * (1 + step))) > abs(value(w * (1 - step))))

    low, high = i - 1, i + 1
    while low > 0 and not rises(mpmath.mpf(omega[low])):  # doubles close to each other do not tell the largest
        low -= 1
    while high < len(omega) - 1 and rises(mpmath.mpf(omega[high])):
        high += 1
    a, b = mpmath.mpf(omega[low]), mpmath.mpf(omega[high])
    for _ in range(90):
        middle = (a + b) / 2
        a, b = (middle, b) if rises(middle) else (a, middle)
    return a


__all__ = ["roots_of", "top_between"]
