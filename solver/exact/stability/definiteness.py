"""Definiteness of a real symmetric matrix of numbers, whatever roots and decimals they are made of."""

from __future__ import annotations

import mpmath
import sympy as sp

DIGITS = 60


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
