"""Matrices over a tower of square roots: a polynomial of a matrix, and linear equations by elimination."""

from __future__ import annotations

from functools import reduce

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.optimal.root_choices import Coefficients
from solver.exact.optimal.square_roots import Nested, RootTower


def polynomial_at(tower: RootTower, coefficients: Coefficients, H: DomainMatrix) -> list[list[Nested]]:
    """p(H) over the tower: for each product of roots the polynomial of its coefficients at H, over K."""
    K, size = tower.K, H.shape[0]
    width = max(map(len, coefficients))
    parts = []
    for index in range(width):
        value = DomainMatrix.zeros(H.shape, K).to_dense()
        for c in coefficients:
            value = value * H
            if index < len(c) and c[index]:
                value = value + DomainMatrix.eye(size, K).to_dense() * c[index]
        parts.append(value.to_list())
    return [[tuple(part[i][j] for part in parts) for j in range(size)] for i in range(size)]


def solved(tower: RootTower, E: list[list[Nested]]) -> list[list[Nested]]:
    """P with E₂ P = −E₁ for E = [E₁, E₂] (2n×2n), E₂ of rank n, by elimination over the tower."""
    n = len(E) // 2
    return quotient_of(tower, [row[n:] for row in E], [[tower.negative(x) for x in row[:n]] for row in E])


def quotient_of(tower: RootTower, left: list[list[Nested]], right: list[list[Nested]]) -> list[list[Nested]]:
    """X with L X = R for L (m×n) of rank n, where there is one, by elimination over the tower."""
    n = len(left[0])
    rows = [[*a, *b] for a, b in zip(left, right, strict=True)]
    for j in range(n):
        pivot = next(i for i in range(j, len(rows)) if any(rows[i][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        by = tower.inverse(rows[j][j])
        rows[j] = [tower.multiply(by, x) if any(x) else x for x in rows[j]]
        for i in range(len(rows)):
            if i != j and any(rows[i][j]):
                factor = tower.negative(rows[i][j])
                rows[i] = [
                    tower.add(x, tower.multiply(factor, y)) if any(y) else x
                    for x, y in zip(rows[i], rows[j], strict=True)
                ]
    return [row[n:] for row in rows[:n]]


def product_of(tower: RootTower, left: list[list[Nested]], right: list[list[Nested]]) -> list[list[Nested]]:
    """L R over the tower."""
    columns = list(zip(*right, strict=True))
    return [
        [reduce(tower.add, (tower.multiply(x, y) for x, y in zip(row, column, strict=True))) for column in columns]
        for row in left
    ]


def shown(tower: RootTower, element: Nested) -> sp.Expr:
    """The element as it is written."""
    found = tower.expression(element)
    return found if found.free_symbols else sp.expand(found)
