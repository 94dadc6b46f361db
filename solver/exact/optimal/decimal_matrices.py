"""Matrices of mpmath numbers as lists of rows: powers, polynomials and linear equations, in the digits set outside."""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import Any

import mpmath
import sympy as sp

Rows = list[list[Any]]


def rows_of(M: sp.MatrixBase, digits: int) -> Rows:
    """A matrix of numbers in decimals."""
    return [[mpmath.mpmathify(sp.N(entry, digits)) for entry in row] for row in M.tolist()]


def powers_of(M: Rows, highest: int) -> list[Rows]:
    """I, M, …, Mᵏ."""
    n = range(len(M))
    powers = [[[mpmath.mpf(int(i == j)) for j in n] for i in n]]
    columns = list(zip(*M, strict=True))
    for _ in range(highest):
        powers.append([[sum(map(mul, row, column)) for column in columns] for row in powers[-1]])
    return powers


def combined(powers: Sequence[Rows], coefficients: Sequence[Any]) -> Rows:
    """Σ cₖ Mᵏ, the coefficients with the highest power first."""
    low_first = list(reversed(coefficients))
    return [
        [sum(map(mul, low_first, entries)) for entries in zip(*rows, strict=True)] for rows in zip(*powers, strict=True)
    ]


def solution_of(left: Rows, right: Rows) -> Rows:
    """X with L X = R for L (m×n) of full column rank, where there is one: by elimination with the largest pivots."""
    table = [[*a, *b] for a, b in zip(left, right, strict=True)]
    n = len(left[0])
    for j in range(n):
        pivot = max(range(j, len(table)), key=lambda i: abs(table[i][j]))
        table[j], table[pivot] = table[pivot], table[j]
        lead = table[j]
        for i in range(len(table)):
            if i != j and table[i][j]:
                factor = table[i][j] / lead[j]
                table[i] = [a - factor * b for a, b in zip(table[i], lead, strict=True)]
    return [[value / table[j][j] for value in table[j][n:]] for j in range(n)]
