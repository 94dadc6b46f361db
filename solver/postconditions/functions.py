"""Resolvents: whether factors cancel in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import numpy as np
import sympy as sp
from sympy import ZZ
from sympy.polys.galoistools import gf_gcd, gf_mul, gf_rem, gf_strip

from solver.derivation import Check
from solver.matrices import entries

NEAR = 1e-7
PRIME = 2**61 - 1
APART = 1e-3
"""Distance of eigenvalues at which doubles know them well; those that fall together they know to a few digits."""


def of_resolvent_cancels(found: bool, A: Any) -> Iterator[Check]:
    """An entry of adj(λI − A) is zero at an eigenvalue, but not everywhere, parameters at some values."""
    symbols = sorted(A.free_symbols, key=str)
    values = {symbol: sp.Rational(17 + 10 * i, 13) for i, symbol in enumerate(symbols)}
    matrix = A.xreplace(values) if values else A
    if all(entry.is_Rational for entry in matrix):
        cancels, oracle = _has_common_factor(matrix), "greatest common divisors"
    else:
        numbers = np.array(matrix.evalf(30).tolist(), dtype=complex)
        roots = np.linalg.eigvals(numbers)
        if any(abs(p - q) < APART for p, q in combinations(roots, 2)):
            return
        cancels, oracle = _vanishes(numbers, roots), "numpy.linalg.det"
    yield Check.that("factors that cancel in the resolvent", oracle, cancels == bool(found))


def _has_common_factor(A: Any) -> bool:
    """Whether an entry of the adjugate, which is not zero, and the characteristic polynomial have a common factor.

    Modulo a prime, where a common factor stays one, and where two polynomials that have none hardly ever get one. The
    product of the entries has one if an entry has.
    """
    n = A.rows
    flat = [entry.p * pow(entry.q, -1, PRIME) % PRIME for entry in entries(A)]
    rows = [flat[i * n : (i + 1) * n] for i in range(n)]
    N = [[int(i == j) for j in range(n)] for i in range(n)]
    chi, coefficients = [1], []
    for k in range(1, n + 1):  # Leverrier: adj(xI − A) = N₁xⁿ⁻¹ + … + Nₙ
        coefficients.append(N)
        N = [[sum(a * N[m][j] for m, a in enumerate(row) if a) % PRIME for j in range(n)] for row in rows]
        chi.append(-sum(N[i][i] for i in range(n)) * pow(k, -1, PRIME) % PRIME)
        N = [[(entry + chi[-1] * (i == j)) % PRIME for j, entry in enumerate(row)] for i, row in enumerate(N)]
    adjugate = (gf_strip([M[i][j] for M in coefficients]) for i in range(n) for j in range(n))
    product = [1]
    for entry in adjugate:
        if len(entry) > 1:
            product = gf_rem(gf_mul(product, entry, PRIME, ZZ), chi, PRIME, ZZ)
    return len(gf_gcd(product, chi, PRIME, ZZ)) > 1


def _vanishes(A: Any, roots: Any) -> bool:
    elsewhere = abs(_adjugate(1.7320508 * np.eye(len(A)) - A)) > NEAR
    at = [abs(_adjugate(root * np.eye(len(A)) - A)) for root in roots]
    size = 1 + max(map(np.max, at))
    return any(bool(np.any((entries < NEAR * size) & elsewhere)) for entries in at)


def _adjugate(M: Any) -> Any:
    """The adjugate by minors; of a 1×1 matrix it is 1."""
    n = len(M)
    minors = [[np.delete(np.delete(M, i, 0), j, 1) for i in range(n)] for j in range(n)]
    return np.array([[(-1) ** (i + j) * np.linalg.det(minors[j][i]) for i in range(n)] for j in range(n)])


def of_interpolation(found: Sequence[Any], spectrum: Any, *_: Any, **__: Any) -> Iterator[Check]:
    """As many conditions as eigenvalues; that each is satisfied is said where the coefficients are."""
    n = len(spectrum.eigenvalues)
    yield Check.that("conditions", "counted", len(found) == n and all(len(each.row) == n for each in found))
