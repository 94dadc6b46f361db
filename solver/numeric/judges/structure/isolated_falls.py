"""Isolated values of two parameters at which a rank falls, which no random line meets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.ranks import rank, rank_at
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.structure.rank_falls import holds_somewhere, is_admissible, number, roots_of

HIGHEST = 12
"""Combinations of minors of a higher degree are not solved."""


def every_isolated_fall_is_named(M: Any, conditions: Sequence[Any], along: Sequence[Any]) -> bool:
    """Whether one of the conditions holds at the common zeros of the minors of M apart from a common factor.

    `along` are two parameters, the others are general. Raises NotEvaluable.
    """
    drawn = PointSource(free_symbols(M) - set(along)).draw()
    others = {symbol: sp.Rational(str(complex(value).real)).limit_denominator(50) for symbol, value in drawn.items()}
    r = rank(M)
    for pair in _common_zeros(M.xreplace(others), along, r):
        point = {**others, **pair}
        if not is_admissible(point) or rank_at(M, {x: number(value) for x, value in point.items()}) == r:
            continue
        if not holds_somewhere(conditions, point):
            return False
    return True


def _common_zeros(M: Any, along: Sequence[Any], r: int) -> Iterator[dict[Any, Any]]:
    """The common zeros of two random combinations of the minors, without their greatest common divisor."""
    x, y = along
    f, g = (_combination(M, r, Random(SEED + k), along) for k in (0, 1))  # noqa: S311 - nothing secret
    divisor = sp.gcd(f, g)
    f, g = f.quo(divisor), g.quo(divisor)
    if max(f.total_degree(), g.total_degree()) > HIGHEST:
        raise NotEvaluable("the minors are of too high a degree")
    if f.is_ground or g.is_ground:
        return
    for root in _real(sp.resultant(f, g, y), x):
        above = [p.as_expr().xreplace({x: root}) for p in (f, g)]
        for other in _real(above[0], y) or _real(above[1], y):
            yield {x: root, y: other}


def _real(f: Any, x: Any) -> list[Any]:
    written = f.as_expr()
    if not written.has(x):
        return []
    return [sp.re(root) for root in roots_of(written, x) if abs(sp.im(root)) < sp.Float(10) ** -20]


def _combination(M: Any, r: int, random: Random, along: Sequence[Any]) -> Any:
    """The determinant of U M W for random integers in U and W, without its denominator."""
    if not all(entry.is_rational_function(*along) for entry in M):
        raise NotEvaluable("the entries are not rational in the parameters")
    U = sp.Matrix(r, M.rows, [random.randint(-9, 9) for _ in range(r * M.rows)])
    W = sp.Matrix(M.cols, r, [random.randint(-9, 9) for _ in range(r * M.cols)])
    minor = DomainMatrix.from_Matrix(U * sp.Matrix(M) * W).to_field()
    return sp.Poly(sp.fraction(sp.together(minor.domain.to_sympy(minor.det())))[0], *along)
