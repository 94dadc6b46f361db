"""The values of a parameter inside sines and cosines for which a rank falls: families with any integer in them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from random import Random
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.ranks import rank, rank_at
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.structure.rank_falls import DIGITS, is_admissible, number, roots_of

INTEGERS = (0, 1, -1, 2, -2, 5)
NEAR = sp.Float(10) ** -20


def is_in_angles(M: Any, x: Any) -> bool:
    """Whether x occurs in M, and in sines and cosines only."""
    functions = {f: sp.Integer(0) for f in M.atoms(sp.sin, sp.cos) if f.has(x)}
    return bool(functions) and not M.xreplace(functions).has(x)


def rank_falls_at(M: Any, x: Any, value: Any) -> bool:
    """Whether the rank of M is below the generic one at x = value, for several of the integers in it."""
    others, r = _general(M, x), rank(M)
    integers = sorted(free_symbols(value) - free_symbols(M), key=str)
    places = [value.xreplace(dict.fromkeys(integers, sp.Integer(k))).xreplace(others) for k in INTEGERS]
    points = [{**others, x: sp.N(place, DIGITS + 10)} for place in places]
    points = [point for point in points if is_admissible(point)]
    return bool(points) and all(_rank_at(M, point) < r for point in points)


def every_angle_is_named(M: Any, x: Any, values: Sequence[Any]) -> bool:
    """Whether each x of some turns at which the rank of M falls, the other parameters general, is one of the values."""
    others, r = _general(M, x), rank(M)
    for place in _falls(M.xreplace(others), x, r):
        point = {**others, x: place}
        if is_admissible(point) and _rank_at(M, point) < r:
            inside = [value.xreplace(others) for value in values]
            if not any(_is_of(family, place) for family in inside):
                return False
    return True


def _general(M: Any, x: Any) -> dict[Any, Any]:
    """General values of the other parameters."""
    drawn = PointSource(free_symbols(M) - {x}).draw()
    return {symbol: sp.Rational(str(complex(value).real)) for symbol, value in drawn.items()}


def _rank_at(M: Any, point: Mapping[Any, Any]) -> int:
    return int(rank_at(M, {symbol: number(value) for symbol, value in point.items()}))


def _falls(M: Any, x: Any, r: int) -> Iterator[Any]:
    """The zeros of a random combination of the minors, by u = tan(θ/2), and θ = π, some turns each."""
    M = sp.Matrix(M).applyfunc(sp.expand_trig)
    angles = {f.args[0] for f in M.atoms(sp.sin, sp.cos) if f.has(x)}
    if len(angles) != 1:
        raise NotEvaluable("the rank is tried along one angle only")
    (angle,) = angles
    slope = angle.diff(x)
    u, random = sp.Dummy("u"), Random(SEED)  # noqa: S311 - nothing secret
    turned = M.xreplace({sp.cos(angle): (1 - u**2) / (1 + u**2), sp.sin(angle): 2 * u / (1 + u**2)})
    U = sp.Matrix(r, M.rows, [random.randint(-9, 9) for _ in range(r * M.rows)])
    W = sp.Matrix(M.cols, r, [random.randint(-9, 9) for _ in range(r * M.cols)])
    minor = DomainMatrix.from_Matrix(U * turned * W, extension=True).to_field()
    roots = roots_of(minor.domain.to_sympy(minor.det()), u)
    turns = [*(2 * sp.atan(sp.re(root)) for root in roots if abs(sp.im(root)) < NEAR), sp.pi]
    for theta in turns:
        for k in INTEGERS:
            yield sp.N((theta + 2 * k * sp.pi - angle.xreplace({x: sp.Integer(0)})) / slope, DIGITS + 10)


def _is_of(family: Any, place: Any) -> bool:
    """Whether the place is the family for some integer."""
    integers = list(family.free_symbols)
    if len(integers) > 1:
        raise NotEvaluable("a value with several integers in it is not judged")
    first, second = (sp.N(family.xreplace(dict.fromkeys(integers, sp.Integer(k))), DIGITS) for k in (0, 1))
    if not integers:
        return bool(abs(first - place) < NEAR)
    steps = (place - first) / (second - first)
    return bool(abs(steps - round(steps)) < NEAR)
