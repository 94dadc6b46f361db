"""What is wrong with a value of a certain form: a Routh array, a Jordan form, a function of A, a realization."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt
from solver.lazy import sympy as sp
from solver.tasks.meanings import NEAR, difference_at, not_in_the_spectrum
from solver.tasks.told import short
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix


ABOVE = 2
"""From so many rows of a Routh array on each follows from those above it."""


def routh_entry(coefficients: Sequence[Expr], array: ImmutableMatrix) -> Reason | None:
    """Return the first entry of a Routh array that does not follow from the coefficients, or from the rows above it."""
    n, rows = len(coefficients) - 1, array.tolist()
    if array.shape != (n + 1, n // 2 + 1):
        return None
    for i, row in enumerate(rows):
        wanted = _row(coefficients, rows, i)
        if wanted is None or wanted[0] == 0:
            return None  # a special case
        factor = sp.cancel(row[0] / wanted[0])
        if not factor.is_positive or (i >= ABOVE and not any(wanted[1:]) and factor != rows[i - 1][0]):
            factor = sp.Integer(1)  # one entry tells no factor from a mistake
        for j, (own, other) in enumerate(zip(row, wanted, strict=True)):
            if not _same(own, factor * other):
                return Reason("meanings/routh", {"i": i + 1, "j": j + 1, "value": _told(own), "above": i >= ABOVE})
    return None


def first_routh_entry(wrong: Attempt[Any, Any]) -> Reason | None:
    """Return the first wrong entry of the Routh array of det(sI − A)."""
    plant = wrong.given.system
    return None if plant.discrete else routh_entry(plant.A.charpoly().all_coeffs(), wrong.value)


def _row(coefficients: Sequence[Expr], rows: Sequence[Sequence[Expr]], i: int) -> list[Expr] | None:
    """What row i must be: from the coefficients, or from the two rows above; None where the pivot is zero."""
    width = len(rows[0])
    if i < ABOVE:
        row = list(coefficients[i::2])
        return [*row, *[sp.Integer(0)] * (width - len(row))]
    (above2, above), pivot = (rows[i - 2], rows[i - 1]), rows[i - 1][0]
    if pivot == 0:
        return None
    shifted = [[*each[1:], sp.Integer(0)] for each in (above2, above)]
    return [sp.cancel((pivot * a - above2[0] * b) / pivot) for a, b in zip(*shifted, strict=True)]


def _same(own: Any, other: Any) -> bool:
    """Whether two entries are the same, but for the rounding of a few digits."""
    gap = sp.cancel(own - other)
    if not gap.is_number or not other.is_number:
        return bool(gap == 0)
    return abs(complex(gap)) <= NEAR * abs(complex(other))


def _told(value: Any) -> Any:
    return sp.cancel(short(value)) if value.is_number else sp.cancel(value)


def jordan_fault(A: ImmutableMatrix, J: ImmutableMatrix) -> Reason | None:
    """Return what is wrong with a Jordan form: an entry off the two diagonals, its diagonal, or its blocks."""
    if J.shape != A.shape or A.free_symbols or J.free_symbols:
        return None
    n = A.rows
    for i, j in ((i, j) for i in range(n) for j in range(n) if j not in (i, i + 1) and J[i, j] != 0):
        return Reason("meanings/no_jordan_form", {"i": i + 1, "j": j + 1, "value": short(J[i, j])})
    if (strange := not_in_the_spectrum(A, [J[i, i] for i in range(n)])) is not None:
        return strange
    for value in dict.fromkeys(J[i, i] for i in range(n)):
        if not value.is_rational:
            continue
        own, wanted = ((M - value * sp.eye(n)).rank() for M in (J, A))
        if own != wanted:
            return Reason("meanings/blocks", {"value": value, "own": own, "wanted": wanted})
    return None


def commutes(A: ImmutableMatrix, F: ImmutableMatrix) -> Reason | None:
    """Return an entry in which AF and FA differ, where F is said to be a function of A."""
    if F.shape != A.shape or A.free_symbols or not all(entry.is_number for entry in F.flat()):
        return None
    left, right = A * F, F * A
    for i, j in ((i, j) for i in range(A.rows) for j in range(A.cols)):
        a, b = (complex(each[i, j]) for each in (left, right))
        if abs(a - b) > NEAR * max(1, abs(a), abs(b)):
            sides = {"left": short(left[i, j]), "right": short(right[i, j])}
            return Reason("meanings/commutes", {"i": i + 1, "j": j + 1, **sides})
    return None


def other_transfer(own: Mapping[str, Any], D: Any, wanted: Any, x: Any) -> Reason | None:
    """Return where C (xI − A)⁻¹ B + D of a realization differs from the transfer function; A, B, C must be known.

    D is that of the transfer function: a slip in one's own is told of D, and would be taken for one of A, B or C.
    """
    if not {"A", "B", "C"} <= own.keys():
        return None
    A, B, C = (sp.Matrix(own[name]) for name in "ABC")
    through = not D.is_zero_matrix or own.get("D", D) != D
    for point in (1, 2, 3):
        M = point * sp.eye(A.rows) - A
        if M.free_symbols or M.det() == 0:
            continue
        value = sp.ImmutableMatrix(C * M.inv() * B + sp.Matrix(D))
        found = difference_at(value, wanted.xreplace({x: sp.Integer(point)}), x, point)
        if found is not None:
            at = {"x": x, "point": sp.Integer(point)}
            return Reason("meanings/other_transfer", {**found.values, **at, "through": through})
    return None
