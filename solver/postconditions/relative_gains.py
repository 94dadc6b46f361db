"""Relative gains: the array, the gains without poles, the pairing."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.limits import limit
from solver.stated.matrices import determinant, entrywise_product, inverse, transpose


def of_relative_gains(found: Any, K: Any) -> Iterator[Claim | Check]:
    """Determinant, inverse, and the products of the entries; without an inverse the determinant is zero."""
    yield Claim(K, found.gains)
    yield Claim(determinant(K), found.determinant)
    if found.inverse is not None:
        yield Claim(inverse(K), found.inverse)
        yield Claim(entrywise_product(K, transpose(inverse(K))), found.array)
    yield Check.that("an inverse where there is one", "compared", (found.inverse is None) == (found.determinant == 0))


def of_gains_at(found: Any, tops: Any, bottoms: Any, x: Any, point: Any) -> Iterator[Claim | Check]:
    """The limits of the rows times powers of x − p; no smaller power takes their poles out."""
    rows = [[p / q for p, q in zip(*row, strict=True)] for row in zip(tops, bottoms, strict=True)]
    scaled = [[sp.cancel(entry * (x - point) ** k) for entry in row] for row, k in zip(rows, found.powers, strict=True)]
    yield Claim(limit(sp.ImmutableMatrix(scaled), x, point), found.gains)
    least = all(k == 0 or any(found.gains.row(i)) for i, k in enumerate(found.powers))
    yield Check.that("no smaller power takes the poles out", "compared", least and min(found.powers) >= 0)


def of_values_at(found: Any, M: Any, x: Any, point: Any) -> Iterator[Claim]:
    """The limits of the entries, where they are finite."""
    if found is not None:
        yield Claim(limit(M, x, point), found)


def of_pairing(found: Any, array: Any) -> Iterator[Claim | Check]:
    """No other way has fewer negative entries, or as many and comes closer to ones."""
    if found is None:
        return
    n = array.rows
    for i, (j, entry) in enumerate(zip(found.inputs, found.entries, strict=True)):
        yield Claim(array[i, j], entry)
    values = [[complex(sp.N(array[i, j])) for j in range(n)] for i in range(n)]
    negative = {(i, j) for i in range(n) for j in range(n) if values[i][j].real < 0}
    yield Check.that("the negative entries", "compared", set(found.negative) == negative)

    def effort(inputs: tuple[int, ...]) -> tuple[int, float]:
        pairs = list(enumerate(inputs))
        return sum(pair in negative for pair in pairs), sum(abs(values[i][j] - 1) for i, j in pairs)

    count, away = min(effort(each) for each in permutations(range(n)))
    taken = effort(tuple(found.inputs))
    best = sorted(found.inputs) == list(range(n)) and taken[0] == count and taken[1] <= away + 1e-9
    yield Check.that("the pairing closest to ones", "compared", best)
    farthest = max(abs(values[i][j] - 1) for i, j in enumerate(found.inputs))
    largest = max(abs(value) for row in values for value in row)
    yield Check.within("the largest entry", "compared", abs(largest - complex(sp.N(found.largest)).real), 1e-9)
    yield Check.within("the distance from ones", "compared", abs(farthest - complex(sp.N(found.distance)).real), 1e-9)
