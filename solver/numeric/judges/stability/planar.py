"""Kinds of phase portraits at values of the parameters: general ones, and those at which the kind changes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random
from typing import Any

import sympy as sp

from solver.numeric.evaluation.points import SEED, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.stability.location import planar_kind
from solver.numeric.judges.stability.regions import is_admissible, on_edges, random_value

POINTS, EDGES = 60, 8
QUADRATIC = 2


def kinds_and_exceptions(A: Any, exceptions: Sequence[Any] = ()) -> tuple[set[str], set[str]]:
    """Return the kinds of x' = A x (2×2) where none of the conditions on parameters holds, and where one does.

    Tried at random values, and where trace, determinant and discriminant, or the sides of a condition, are equal to
    zero (to each other). Raises NotEvaluable if no values are found.
    """
    general: set[str] = set()
    special: set[str] = set()
    for point in _points(A, exceptions):
        try:
            kind = planar_kind(A.xreplace(point), {})
        except (Undefined, NotEvaluable):
            continue
        (special if any(_holds(each, point) for each in exceptions) else general).add(kind)
    if not general | special:
        raise NotEvaluable("no values of the parameters were found at which the system is defined")
    return general, special


def _points(A: Any, exceptions: Sequence[Any]) -> Iterator[dict[Any, Any]]:
    """Random rational values, and values moved onto what may change the kind; the only point without parameters."""
    symbols = sorted(free_symbols(A), key=str)
    if not symbols:
        yield {}
        return
    random = Random(SEED)  # noqa: S311 - nothing secret
    drawn = [{symbol: random_value(symbol, random) for symbol in symbols} for _ in range(POINTS)]
    tr, det = A[0, 0] + A[1, 1], A[0, 0] * A[1, 1] - A[0, 1] * A[1, 0]
    named = [sp.Eq(sp.expand(x), 0) for x in (tr, det, tr**2 - 4 * det, A[0, 1], A[1, 0])]
    edges = [each for each in (*exceptions, *named) if isinstance(each, sp.Basic)]
    moved = [place for point in drawn[:EDGES] for each in edges for place in on_edges(each, point)]
    lines = dict.fromkeys(_along(point, symbol) for point in drawn[:EDGES] for symbol in symbols)
    roots = [{**dict(rest), x: root} for x, *rest in lines for each in edges for root in _roots(each, x, dict(rest))]
    yield from filter(is_admissible, [*drawn, *moved, *roots])


def _along(point: dict[Any, Any], symbol: Any) -> tuple[Any, ...]:
    """The line through a point along which one parameter varies: that one, and the others with their values."""
    return symbol, *((other, value) for other, value in point.items() if other != symbol)


def _roots(condition: Any, symbol: Any, others: dict[Any, Any]) -> list[Any]:
    """The real values of a parameter at which the sides of a comparison of degree one or two are equal.

    At a rounded one they are not quite.
    """
    found = []
    for each in condition.atoms(sp.core.relational.Relational):
        difference = sp.fraction(sp.together((each.lhs - each.rhs).xreplace(others)))[0]
        if difference.has(symbol) and difference.is_polynomial(symbol) and sp.degree(difference, symbol) <= QUADRATIC:
            *a, b, c = sp.Poly(difference, symbol).all_coeffs()
            square = sp.sqrt(b**2 - 4 * a[0] * c) if a else 0
            found += [(-b + sign * square) / (2 * a[0]) for sign in (1, -1)] if a else [-c / b]
    return [root for root in found if root.is_real and not root.has(sp.Float)]


def _holds(condition: Any, point: dict[Any, Any]) -> bool:
    """Whether a condition holds at a point."""
    truth = condition.xreplace(point) if isinstance(condition, sp.Basic) else condition
    return bool(truth.doit() if hasattr(truth, "doit") else truth)
