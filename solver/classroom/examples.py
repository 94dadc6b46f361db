"""Examples of the notation that an answer is written in, none of which is the answer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.classroom.kinds import kind_of

s, z, t, k = sp.symbols("s z t k")

EXPRESSIONS = {
    "s": (("(2s + 7)/(s^2 + 5s)", (2 * s + 7) / (s**2 + 5 * s)), ("3/(s + 8)", 3 / (s + 8))),
    "z": (("(2z + 1)/(z^2 - z/5)", (2 * z + 1) / (z**2 - z / 5)), ("3/(z - 7)", 3 / (z - 7))),
    "t": (("7 - 5exp(-9t)", 7 - 5 * sp.exp(-9 * t)), ("4 sin(7t)", 4 * sp.sin(7 * t))),
    "k": (("7 - 5 (1/9)^k", 7 - 5 * sp.Rational(1, 9) ** k), ("4 (1/7)^k", 4 * sp.Rational(1, 7) ** k)),
    "": (("3/7", sp.Rational(3, 7)), ("11/4", sp.Rational(11, 4))),
}
"""Two of each variable, as text and as value: at most one is the answer."""

COUNTS = (("11", sp.Integer(11)), ("13", sp.Integer(13)))
CONDITIONS = {"a condition": ("0 < a < 17", "a > 23"), "a list of conditions": ("[a > 23]",)}
FREE_MATRIX = "[[1, 2], [3, 4]]"
DERIVATIVES = {"_dddot": "'''", "_ddot": "''", "_dot": "'"}


def example_of(
    ours: Any, *, sized: bool = False, intervals: bool = False, zero: bool = False, count: bool = False
) -> str:
    """Return an example of the notation for an answer of the kind of ours, "" where there is none; never ours itself.

    It has the size of a matrix only where that is `sized`; a list of numbers is one of `intervals`, of expressions that
    are `zero` one of equations, and a number one that is counted, where that is said.
    """
    kind = kind_of(ours)
    if kind == "a matrix":
        return _matrix(ours) if sized else FREE_MATRIX
    if intervals:
        return next(text for text, value in INTERVALS if list(ours) != value)
    if isinstance(ours, list | tuple) and ours and isinstance(ours[0], Mapping):
        return _points(ours)
    if kind == "a list":
        items = list(ours) if isinstance(ours, list | tuple) else []
        return (_equations(items) if zero else "") or next(text for text, value in LISTS if items != value)
    if kind == "an expression":
        among = COUNTS if count else EXPRESSIONS[_variable(ours)]
        return next((text for text, value in among if not _same(ours, value)), "")
    return next(iter(CONDITIONS.get(kind, ())), "")


LISTS: tuple[tuple[str, list[Any]], ...] = (
    ("[-9, 7 ± 5j]", [sp.Integer(-9), 7 + 5 * sp.I, 7 - 5 * sp.I]),
    ("[-11, 13/2]", []),
)

INTERVALS: tuple[tuple[str, list[Any]], ...] = (
    ("(-inf, -19], [-17, -13]", [sp.Interval(-sp.oo, -19), sp.Interval(-17, -13)]),
    ("[-17, -13]", []),
)


def _equations(ours: Sequence[Any]) -> str:
    """Return a list of an equation in a name of ours, in its highest derivative if there is one; "" without names."""
    names = sorted({symbol.name for each in ours for symbol in getattr(each, "free_symbols", ())})
    for ending, sign in DERIVATIVES.items():
        if found := next((name.removesuffix(ending) for name in names if name.endswith(ending)), ""):
            return f"[17 {found}{sign} + 23 {found} = 0]"
    return f"[17 {names[0]} = 23]" if names else ""


def _points(ours: Sequence[Mapping[Any, Any]]) -> str:
    """Return a list of one point with the names of ours, all of whose values are none of ours."""
    taken = {value for point in ours for value in point.values()}
    number = next(n for n in range(7, 8 + len(taken)) if sp.Integer(n) not in taken)
    return "[{" + ", ".join(f"{name}: {number}" for name in ours[0]) + "}]"


def _variable(ours: Any) -> str:
    names = {symbol.name for symbol in getattr(ours, "free_symbols", ())}
    return next((name for name in EXPRESSIONS if name in names), "")


def _same(ours: Any, value: Any) -> bool:
    """Whether two expressions agree at a point, or may do so."""
    at = {symbol: sp.Rational(7, 3) for symbol in value.free_symbols}
    named = {symbol: sp.Rational(7, 3) for symbol in getattr(ours, "free_symbols", ()) if symbol.name in EXPRESSIONS}
    difference = (sp.Add(ours, 0).subs(named)) - value.subs(at)
    return difference.is_zero is not False


def _matrix(ours: sp.MatrixBase) -> str:
    """Return a matrix of that size with the numbers from 1 on, or from the next on that are not ours."""
    rows = next(rows for rows in _counted(*ours.shape) if sp.Matrix(rows) != sp.Matrix(ours))
    if ours.rows == 1:
        return str(rows[0])
    return str(rows)


def _counted(rows: int, columns: int) -> Iterator[list[list[int]]]:
    for first in (1, 2):
        yield [[first + i * columns + j for j in range(columns)] for i in range(rows)]
