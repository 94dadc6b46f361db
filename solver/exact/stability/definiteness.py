"""Definiteness of a real symmetric matrix of numbers, whatever roots and decimals they are made of."""

from __future__ import annotations

from typing import Any

import mpmath
import sympy as sp

DIGITS = 60

BESIDE = sp.Rational(1, 1000)
"""What an eigenvalue may be of the largest one, to be put down to rounding."""


def definiteness_of_numbers(M: sp.MatrixBase) -> str:
    """Return "positive definite", "positive semidefinite", the same with "negative", or "indefinite".

    By the eigenvalues to 60 digits; what vanishes to all but three of the digits that the entries carry is zero. The
    zero matrix is called positive semidefinite.
    """
    carried = min((int(x._prec / 3.33) for x in M.atoms(sp.Float)), default=DIGITS)
    with mpmath.workdps(DIGITS + 20):
        value = mpmath.matrix([[mpmath.mpmathify(sp.N(x, DIGITS)) for x in row] for row in M.tolist()])
        eigenvalues = [mpmath.re(z) for z in mpmath.eigsy(value, eigvals_only=True)]
        zero = max(abs(z) for z in eigenvalues) * mpmath.mpf(10) ** -(carried - 3)
        positive = sum(1 for z in eigenvalues if z > zero)
        negative = sum(1 for z in eigenvalues if z < -zero)
    if positive and negative:
        return "indefinite"
    word = "negative" if negative else "positive"
    return f"{word} definite" if positive + negative == M.rows else f"{word} semidefinite"


def negative_by_rounding(M: sp.MatrixBase) -> sp.Float | None:
    """The smallest eigenvalue of a symmetric matrix of decimals, where it is negative by no more than their rounding.

    Entries rounded to d digits behind the point are off by half a unit of the last one at most, and eigenvalues of an
    n×n matrix by n such halves. None for other matrices, also for those without negative eigenvalues.
    """
    digits = [_digits_behind_the_point(entry) for entry in M.flat()]
    if None in digits or not any(digits):
        return None
    with mpmath.workdps(DIGITS):
        eigenvalues = mpmath.eigsy(
            mpmath.matrix([[mpmath.mpmathify(x) for x in row] for row in M.evalf(DIGITS).tolist()])
        )
        smallest, largest = min(eigenvalues[0]), max(eigenvalues[0])
    known = sp.Rational(M.rows, 2 * 10 ** max(filter(None, digits)))
    if not -min(known, BESIDE * sp.Float(largest)) <= smallest < 0:
        return None
    return sp.Float(smallest, 15)


def _digits_behind_the_point(entry: Any) -> int | None:
    """How many digits a decimal has behind its point; None where it is none."""
    if not entry.is_Rational:
        return None
    twos, fives = (sp.multiplicity(prime, entry.q) for prime in (2, 5))
    return max(twos, fives) if entry.q == 2**twos * 5**fives else None
