"""Resolvents: whether factors cancel in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Check

NEAR = 1e-7


def of_resolvent_cancels(found: bool, A: Any) -> Iterator[Check]:
    """An entry of adj(λI − A) is zero at an eigenvalue, but not everywhere, parameters at some values."""
    symbols = sorted(A.free_symbols, key=str)
    values = {symbol: sp.Rational(17 + 10 * i, 13) for i, symbol in enumerate(symbols)}
    matrix = np.array(A.xreplace(values).evalf(30).tolist(), dtype=complex)
    elsewhere = abs(_adjugate(1.7320508 * np.eye(A.rows) - matrix)) > NEAR
    at = [abs(_adjugate(root * np.eye(A.rows) - matrix)) for root in np.linalg.eigvals(matrix)]
    size = 1 + max(map(np.max, at))
    vanishing = any(bool(np.any((entries < NEAR * size) & elsewhere)) for entries in at)
    yield Check.that("factors that cancel in the resolvent", "numpy.linalg.det", vanishing == bool(found))


def _adjugate(M: Any) -> Any:
    """The adjugate by minors; of a 1×1 matrix it is 1."""
    n = len(M)
    minors = [[np.delete(np.delete(M, i, 0), j, 1) for i in range(n)] for j in range(n)]
    return np.array([[(-1) ** (i + j) * np.linalg.det(minors[j][i]) for i in range(n)] for j in range(n)])


def of_interpolation(found: Sequence[Any], spectrum: Any, *_: Any, **__: Any) -> Iterator[Check]:
    """As many conditions as eigenvalues; that each is satisfied is said where the coefficients are."""
    n = len(spectrum.eigenvalues)
    yield Check.that("conditions", "counted", len(found) == n and all(len(each.row) == n for each in found))
