"""The largest minors of a matrix of rational functions of parameters: one by one, or their greatest common divisor.

Rows and columns with a constant pivot are eliminated first, which leaves the ideal of the minors as it is and the
matrix small. With one parameter the divisor comes from Euclid's algorithm on rows and columns, without minors.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from itertools import combinations
from math import comb
from typing import Any

from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import NotExact

MOST_MINORS = 3000
"""A matrix with more minors than this is given up."""

PolyRows = list[list[Any]]


def polynomials_of(D: DomainMatrix) -> PolyRows:
    """The rows with denominators cleared, over the ring of polynomials in the parameters; none without parameters."""
    K: Any = D.domain
    if not K.is_FractionField:
        return []
    R = K.field.ring.clone(domain=K.field.ring.domain.get_field())
    found = []
    for row in D.to_list():
        pairs = [(a.numer.set_ring(R), a.denom.set_ring(R)) for a in row]
        denominator = reduce(lambda f, g: f.lcm(g), (below for _, below in pairs), R.one)
        found.append([above * denominator.exquo(below) for above, below in pairs])
    return found


def without_constants(rows: PolyRows, r: int) -> tuple[int, PolyRows]:
    """Eliminate with constant pivots: the (r − 1)-minors of what is left have the ideal that the r-minors had."""
    while True:
        place = next(((i, j) for i, row in enumerate(rows) for j, a in enumerate(row) if a and a.is_ground), None)
        if place is None or r == 0:
            return r, _distinct(rows)
        i, j = place
        top = rows[i]
        K = top[j].ring.domain
        unit = K.one / top[j].LC
        rows = [
            [a - row[j] * b * unit for c, (a, b) in enumerate(zip(row, top, strict=True)) if c != j]
            for k, row in enumerate(rows)
            if k != i
        ]
        r -= 1


def _distinct(rows: PolyRows) -> PolyRows:
    """Without zero rows and columns, and equal ones once."""
    rows = [list(row) for row in dict.fromkeys(map(tuple, rows)) if any(row)]
    columns = [column for column in dict.fromkeys(zip(*rows, strict=True)) if any(column)]
    return [list(row) for row in zip(*columns, strict=True)]


def diagonal_product(rows: PolyRows) -> Any:
    """Product of the diagonal that Euclid's algorithm on rows and columns leaves: the gcd of the largest minors."""
    R = rows[0][0].ring
    product = R.one
    while rows and any(any(row) for row in rows):
        rows, pivot = _cleared_corner(rows)
        product = product * pivot
    return product.monic()


def _cleared_corner(rows: PolyRows) -> tuple[PolyRows, Any]:
    """Bring an entry of least degree to a row and column otherwise zero; what is left, and the entry."""
    while True:
        entries = ((a.degree(), i, j) for i, row in enumerate(rows) for j, a in enumerate(row) if a)
        _, i, j = min(entries)
        top, pivot = rows[i], rows[i][j]
        for k, row in enumerate(rows):
            if k != i and row[j]:
                quotient = row[j].div(pivot)[0]
                rows[k] = [a - quotient * b for a, b in zip(row, top, strict=True)]
        if any(row[j] for k, row in enumerate(rows) if k != i):
            continue
        rest = [a.rem(pivot) for a in top]  # column operations; below and above the pivot there are zeros
        rest[j] = pivot
        rows[i] = rest
        if not any(a for c, a in enumerate(rest) if c != j):
            return [[a for c, a in enumerate(row) if c != j] for k, row in enumerate(rows) if k != i], pivot


def minors_of(rows: PolyRows, r: int) -> Iterator[Any]:
    """All r×r minors; raises NotExact if they are too many."""
    height, width = len(rows), len(rows[0])
    if comb(height, r) * comb(width, r) > MOST_MINORS:
        raise NotExact("structure/too_many_minors")
    R = rows[0][0].ring
    for chosen in combinations(range(height), r):
        for columns in combinations(range(width), r):
            square = [[rows[i][j] for j in columns] for i in chosen]
            last = DomainMatrix(square, (r, r), R.to_domain()).charpoly()[-1]
            yield -last if r % 2 else last
