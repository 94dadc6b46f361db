"""Kinds of phase portraits at values of the parameters: general ones, and those at which the kind changes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random
from typing import Any

import sympy as sp

from solver.numeric.evaluation.points import SEED, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.stability.edges import on_edges
from solver.numeric.judges.stability.location import clusters, planar_kind
from solver.numeric.judges.stability.regions import is_admissible, random_value

POINTS, EDGES = 60, 8
QUADRATIC = 2


def kinds_and_exceptions(
    A: Any, exceptions: Sequence[Any] = (), *, discrete: bool = False
) -> tuple[set[str], set[str]]:
    """Return the kinds of x' = A x (2×2; discrete: x(k+1)) where no condition on parameters holds, and where one does.

    Tried at random values, and where trace, determinant and discriminant (discrete: p(±1), det − 1 and the
    discriminant), or the sides of a condition, are equal to zero (to each other). Raises NotEvaluable if no values are
    found.
    """
    general: set[str] = set()
    special: set[str] = set()
    for point in _points(A, exceptions, discrete=discrete):
        try:
            kind = (planar_kind_in_z if discrete else planar_kind)(A.xreplace(point), {})
        except (Undefined, NotEvaluable):
            continue
        (special if any(_holds(each, point) for each in exceptions) else general).add(kind)
    if not general | special:
        raise NotEvaluable("no values of the parameters were found at which the system is defined")
    return general, special


def _points(A: Any, exceptions: Sequence[Any], *, discrete: bool) -> Iterator[dict[Any, Any]]:
    """Random rational values, and values moved onto what may change the kind; the only point without parameters."""
    symbols = sorted(free_symbols(A), key=str)
    if not symbols:
        yield {}
        return
    random = Random(SEED)  # noqa: S311 - nothing secret
    drawn = [{symbol: random_value(symbol, random) for symbol in symbols} for _ in range(POINTS)]
    tr, det = A[0, 0] + A[1, 1], A[0, 0] * A[1, 1] - A[0, 1] * A[1, 0]
    edges_of_kinds = (1 - tr + det, 1 + tr + det, det - 1) if discrete else (tr, det)
    named = [sp.Eq(sp.expand(x), 0) for x in (*edges_of_kinds, tr**2 - 4 * det, A[0, 1], A[1, 0])]
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


def planar_kind_in_z(A: Any, point: Any) -> str:
    """Return the kind of x(k+1) = A x(k), n = 2, by |λ| and dim ker(A − λI); "" for an eigenvalue −1 beside another."""
    groups = clusters(A, point)
    mp = groups[0][3]
    tiny = mp.mpf(10) ** -30
    values = [value for value, *_ in groups]
    outside = [0 if abs(abs(value) - 1) <= tiny else 1 if abs(value) > 1 else -1 for value in values]
    speed = "stable" if outside[0] < 0 else "unstable"
    if abs(mp.im(values[0])) > tiny:
        return f"{speed} focus" if outside[0] else "center"
    if any(abs(value - 1) <= tiny for value in values):
        lonely = len(groups) == 1
        return "line of equilibria" if not lonely else "all points are equilibria" if groups[0][2]() == 2 else "shear"
    if 0 in outside:
        return ""
    if len(groups) == 1:
        return f"{speed} star" if groups[0][2]() == 2 else f"{speed} degenerate node"
    return f"{speed} node" if outside[0] == outside[1] else "saddle"
