"""Matrices with integer eigenvalues by construction, for families in which hardly any draw has them.

A = T Λ T⁻¹ with integers in Λ and a unimodular T, a product of triangular matrices with ones on the diagonal, has
integer entries. Such a draw is made where each entry of the matrix is a number or a name of its own; what does not fit
the values that the file gives is drawn again.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from solver.papers.generator import below, stream
from solver.problem.family import Family

Pattern = tuple[tuple[str | int, ...], ...]
"""A square matrix of names, each once, and of integers."""

Rows = list[list[int]]

TRIES = 400
"""So often is a matrix made for one draw."""

LARGEST = 6
"""Of eigenvalues, in absolute value."""

CONSTRUCTED = 1
"""Tells the numbers that are used here from those that order the draws of a seed."""


class FromEigenvalues:
    """Draws of a family whose matrix has integer eigenvalues; `at` gives the places of the values of one."""

    def __init__(self, family: Family, pattern: Pattern, seed: int) -> None:
        self.family = family
        self.pattern = pattern
        self.seed = seed
        self.places = {
            each.name: {int(value): place for place, value in enumerate(each.values) if value.is_Integer}
            for each in family.varied
        }

    def at(self, number: int) -> list[int] | None:
        """Return the places of the values of a draw by its number, None where none was found."""
        bits = stream(self.seed, CONSTRUCTED, number)
        for _ in range(TRIES):
            found = self._fitting(matrix_with_integer_eigenvalues(len(self.pattern), bits))
            if found is not None:
                return [found.get(each.name, below(len(each.values), bits)) for each in self.family.varied]
        return None

    def _fitting(self, matrix: Rows) -> dict[str, int] | None:
        """Return the places of the entries among the values of their names, None where one is not among them."""
        found: dict[str, int] = {}
        for entry, value in zip(_entries(self.pattern), _entries(matrix), strict=True):
            if isinstance(entry, str):
                place = self.places[entry].get(int(value))
                if place is None:
                    return None
                found[entry] = place
            elif entry != value:
                return None
        return found


def _entries(rows: Sequence[Sequence[str | int]]) -> list[str | int]:
    return [entry for row in rows for entry in row]


def matrix_with_integer_eigenvalues(order: int, bits: Iterator[int]) -> Rows:
    """Return T Λ T⁻¹, n×n; Λ has integers, and the triangular factors of T have −1, 0 and 1 beside their ones."""
    eigenvalues = [below(2 * LARGEST + 1, bits) - LARGEST for _ in range(order)]
    matrix = [[eigenvalues[i] if i == j else 0 for j in range(order)] for i in range(order)]
    for lower in (False, True):
        for i in range(order):
            for j in range(i) if lower else range(i + 1, order):
                if factor := below(3, bits) - 1:
                    _add_row(matrix, i, j, factor)
    return matrix


def _add_row(matrix: Rows, i: int, j: int, factor: int) -> None:
    """Replace A by E A E⁻¹ where E adds a multiple of row j to row i."""
    matrix[i] = [a + factor * b for a, b in zip(matrix[i], matrix[j], strict=True)]
    for row in matrix:
        row[j] -= factor * row[i]
