"""Jury's and Raible's tables put to the test in many digits: each row must be the one that the coefficients lead to.

The row below r₀, …, rₘ is r₀ rₖ − rₘ r₍ₘ₋ₖ₎, k = 0, …, m − 1, in both tables, up to a factor; they differ in the order
of the first two rows. Rows in reverse order may stand between the others.
"""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.arithmetic import multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols, holds_decimals
from solver.numeric.judges.stability.discs import characteristic_coefficients
from solver.numeric.judges.stability.location import routh_fault, spread_points
from solver.words import Phrase

DIGITS = 120
Row = list[Any]


def table_fault(A: Any, array: Any, method: str) -> str:
    """Return what is wrong with a table of det(zI − A), or "": by the method asked for, by any where none is named."""
    faults = []
    if method != "bilinear":
        faults.append(jury_fault(A, array))
    if method != "jury":
        faults += [routh_fault(A, array, discrete=True, at_minus_one=each) for each in (True, False)]
    return "" if "" in faults else faults[0]


def jury_fault(A: Any, array: Any) -> str:
    """Return what is wrong with Jury's or Raible's table of det(zI − A), n ≥ 1, or "".

    Rows count up to a factor. The table may end at a row of three entries or fewer, or at one that begins with zero.
    """
    n = A.rows
    if array.cols != n + 1:
        return Phrase("the table must have {columns} columns", columns=n + 1)
    if free_symbols(array) - free_symbols(A):
        return Phrase("the table has a symbol in it that is no parameter")
    for point in spread_points([A, array], 3):
        mp, arithmetic = multiple(DIGITS).context, multiple(DIGITS)
        wanted = _rows(characteristic_coefficients(A, point, arithmetic)[::-1], mp)
        near = mp.mpf(10) ** (-9 if holds_decimals([A, array]) else -30)
        own = value_of(array, Environment.at([dict(point)], arithmetic)).value[0].tolist()
        faults = [_fault(own, each, least, mp, near, numbers=not point) for each, least in _layouts(wanted)]
        if None not in faults:
            return Phrase("row {row} does not follow from the rows above it", row=max(each for each in faults if each))
    return ""


def _rows(first: Row, mp: Any) -> list[Row]:
    """The rows that the coefficients a₀, …, aₙ lead to, each scaled to its largest entry; tiny entries are zeros."""
    rows = [first]
    while len(rows[-1]) > 1:
        r, m = rows[-1], len(rows[-1]) - 1
        products = [(r[0] * r[k], r[m] * r[m - k]) for k in range(m)]
        found = [x - y for x, y in products]
        found = [
            mp.mpf(0) if abs(d) <= mp.mpf(10) ** (-DIGITS // 2) * max(abs(x), abs(y)) else d
            for d, (x, y) in zip(found, products, strict=True)
        ]
        largest = max(map(abs, found))
        rows.append([x / largest for x in found] if largest else found)
    return rows


def _layouts(rows: list[Row]) -> list[tuple[list[Row], int]]:
    """The tables in which the rows may stand, and how many rows each must have."""
    n = len(rows) - 1
    plain = next((i for i, row in enumerate(rows) if i and not row[0]), n)
    least = min(max(n - 1, 1), plain + 1)
    doubled = [each for row in rows for each in (row, row[::-1])][: 2 * n + 1]
    swapped = [doubled[1], doubled[0], *doubled[2:]]
    return [
        (doubled, 2 * least - 1),
        (swapped, max(2 * least - 1, 2) if n > 1 else 1),
        (rows, least),
        ([rows[0][::-1], *rows[1:]], least),
    ]


def _fault(own: list[Row], wanted: list[Row], least: int, mp: Any, near: Any, *, numbers: bool) -> int | None:
    """The number of the first row that is wrong, or missing; None where there is none.

    Of `numbers` the coefficients keep their signs, as what rows must fulfil is said for a positive leading one.
    """
    for i, row in enumerate(own):
        if i >= len(wanted) or not _proportional(row, wanted[i], mp, near, positive=numbers and not i):
            return i + 1
        if len(wanted[i]) == 1 and not _single(row[0], own[:i], mp, near):
            return i + 1
    return len(own) + 1 if len(own) < least else None


def _proportional(row: Row, wanted: Row, mp: Any, near: Any, *, positive: bool) -> bool:
    """Whether row = c · wanted with zeros behind it, c real and not zero, or positive."""
    if not any(wanted):
        return not any(row)
    if any(row[len(wanted) :]):
        return False
    at = max(range(len(wanted)), key=lambda k: abs(wanted[k]))
    c = row[at] / wanted[at]
    if not c or mp.im(c) or (positive and mp.re(c) < 0):
        return False
    return all(abs(x - c * y) <= near * abs(c) * max(abs(y), near) for x, y in zip(row, wanted, strict=False))


def _single(entry: Any, above: list[Row], mp: Any, near: Any) -> bool:
    """Whether a row of one entry is ±(r₀² − r₁²) of the row above, divided or not by a first entry further up."""
    r = above[-1]
    square = r[0] ** 2 - r[1] ** 2
    divisors = [mp.mpf(1), r[1], *(row[0] for row in above)]
    return any(abs(abs(entry * d) - abs(square)) <= near * abs(square) for d in divisors if d)
