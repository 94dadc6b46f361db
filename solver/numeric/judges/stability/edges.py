"""Where a condition on several parameters ends, met from points inside of it along each parameter."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any

import sympy as sp

MOST_INSIDE = 5
"""Points inside from which the edges are looked for."""
DOUBLINGS, HALVINGS = 16, 26
NEAR = sp.Rational(1, 10**5)
FIRST = sp.Rational(1, 64)
BEYOND = sp.Rational(11, 10)
Point = Mapping[Any, Any]


def beside_edges(
    claimed: Callable[[Any], bool | None], inside: Sequence[Point], vague: Iterable[tuple[Any, Any, Any]]
) -> Iterable[dict[Any, Any]]:
    """Yield points on both sides of each edge that is met from the points inside along one parameter.

    Where the edge is a `vague` bound (of a symbol, where, half a unit of its last digit) they are just beyond that.
    """
    bounds = list(vague)
    for point in _spread(claimed, inside):
        for symbol in point:
            for sign in () if symbol.is_integer else (1, -1):
                if (ends := _edge(claimed, point, symbol, sign)) is not None:
                    inner, outer = ends
                    halves = [half for name, bound, half in bounds if name == symbol and inner != outer
                              and abs(bound - inner) <= half]  # fmt: skip
                    half = max(halves, default=sp.S.Zero) * BEYOND
                    yield {**point, symbol: inner - sign * half}
                    yield {**point, symbol: outer + sign * half}


def _spread(claimed: Callable[[Any], bool | None], inside: Sequence[Point]) -> list[Point]:
    """A few points inside, and what lies between them, so that a region of few points is seen from several."""
    chosen = list(inside[:MOST_INSIDE])
    for one, other in pairwise(tuple(chosen)):
        middle = {symbol: (2 * one[symbol] + other[symbol]) / 3 for symbol in one}
        if len(chosen) < MOST_INSIDE and claimed(middle):
            chosen.append(middle)
    return chosen


def _edge(claimed: Callable[[Any], bool | None], point: Point, symbol: Any, sign: int) -> tuple[Any, Any] | None:
    """The values of a parameter on both sides of the edge that comes first in one direction; None if there is none."""
    inner, step = point[symbol], FIRST * (1 + abs(point[symbol]))
    for _ in range(DOUBLINGS):
        outer = inner + sign * step
        if not claimed({**point, symbol: outer}):
            break
        inner, step = outer, 2 * step
    else:
        return None
    for _ in range(HALVINGS):
        middle = (inner + outer) / 2
        inner, outer = (middle, outer) if claimed({**point, symbol: middle}) else (inner, middle)
    return inner, outer


def on_edges(condition: Any, point: Point) -> Iterable[dict[Any, Any]]:
    """The point moved onto the edge of each comparison that is linear in one of its symbols, and beside it."""
    for each in comparisons_of(condition):
        difference = each.lhs - each.rhs
        for symbol in sorted(difference.free_symbols, key=str):
            if difference.is_polynomial(symbol) and sp.degree(difference, symbol) == 1:
                a, b = (c.xreplace(point) for c in sp.Poly(difference, symbol).all_coeffs())
                if a.is_Rational and b.is_Rational and a != 0:
                    yield from ({**point, symbol: -b / a + side * NEAR * (1 + abs(b / a))} for side in (0, 1, -1))
                break


def comparisons_of(condition: Any) -> list[Any]:
    """Return the comparisons of a condition, always in the same order."""
    return sorted(condition.atoms(sp.core.relational.Relational), key=str)
