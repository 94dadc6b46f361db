"""Reduced transfer functions judged: by the eigenvalues of the system and the roots of the function itself."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.judges.classical.poles import shown_poles
from solver.numeric.judges.representation.minimal import (
    MANY,
    NOTHING,
    minimal_part,
    numbers_at,
    points_of,
    quadruple_at,
)

WRONG = float("inf")
ALIKE = 1e-12
FAR = "1e-25"
CIRCLE = 7200


def dominant_residual(plant: Any, order: int, name: str, answer: Sequence[Any], *, discrete: bool = False) -> float:
    """Return the largest distance of the poles listed and those that are kept, or dropped, relative to their size."""
    worst = 0.0
    for point in points_of(plant, answer):
        kept, dropped = _divided(shown_poles(plant, point), order, discrete=discrete)
        worst = worst_of((worst, _distance(numbers_at(answer, point), kept if name == "kept" else dropped)))
    return with_many_digits(worst, *plant, answer)


def _slowness(p: Any, *, discrete: bool) -> tuple[float, float]:
    """By what poles are sorted, the slowest first."""
    if discrete:
        return -round(float(abs(p)), 12), -float(p.real)
    return -float(p.real), abs(float(p.imag))


def _divided(poles: list[Any], order: int, *, discrete: bool) -> tuple[list[Any], list[Any]]:
    """The slowest poles and the others: pairs and multiple poles together, those that do not decay always kept."""
    groups: list[list[Any]] = []
    for p in sorted(poles, key=partial(_slowness, discrete=discrete)):
        mate = next((g for g in groups if any(_near(p, q) or _near(p, q.conjugate()) for q in g)), None)
        if mate is not None:
            mate.append(p)
        else:
            groups.append([p])
    kept: list[Any] = []
    while groups and (_lasts(groups[0][0], discrete=discrete) or len(kept) + len(groups[0]) <= order or not kept):
        kept += groups.pop(0)
    return kept, [p for group in groups for p in group]


def _lasts(p: Any, *, discrete: bool) -> bool:
    return bool(abs(p) >= 1 - ALIKE if discrete else p.real >= -ALIKE)


def _near(p: Any, q: Any) -> bool:
    return bool(abs(p - q) <= ALIKE * (1 + abs(p)))


def _distance(found: Sequence[Any], right: Sequence[Any]) -> float:
    """The largest distance of two lists of numbers in any order."""
    if len(found) != len(right):
        return WRONG
    left, worst = list(right), 0.0
    for p in found:
        nearest = min(left, key=lambda q: float(abs(p - q)))
        left.remove(nearest)
        worst = max(worst, float(abs(p - nearest) / (1 + abs(nearest))))
    return worst


def reduced_residual(plant: Any, order: int, G: Any, *, discrete: bool = False) -> float:
    """Return how far a rational function in s is from one with the poles kept, the value near zero and slow zeros.

    A zero nearer to the origin than all dropped poles must be there, as far as there are poles for it; no zero may be
    there that the system has not. In discrete time it is a function in z, and one stands for the origin.
    """
    s, rest = sp.Symbol("z" if discrete else "s"), int(discrete)
    worst = 0.0
    for point in points_of(plant, G.subs(s, 2)):
        rational = {x: sp.Rational(complex(value).real) for x, value in dict(point).items()}
        at = tuple(M.xreplace(rational) for M in plant)
        function = sp.together(G.xreplace(rational))
        if not function.is_rational_function(s) or function.free_symbols - {s}:
            return WRONG
        top, bottom = (sp.Poly(each, s) for each in sp.fraction(function))
        A, B, C, D = quadruple_at(at, {})
        A, B, C = minimal_part(A, B, C)
        poles = shown_poles(at, {})
        kept, dropped = _divided(poles, order, discrete=discrete)
        worst = worst_of((worst, _distance(_roots(bottom), kept)))
        if worst > ALIKE * 1e3 or top.degree() > bottom.degree():
            return max(worst, 1.0)
        room = len(kept) - (1 if abs(D.reshape(-1)[0]) < NOTHING else 0)
        worst = worst_of((worst, _zeros_off((A, B, C, D), (poles, dropped), _roots(top), room, rest)))
        near = rest + MANY.context.mpc(FAR, FAR)
        ours, whole = (_value(each, near) for each in ((top, bottom), (A, B, C, D)))
        worst = worst_of((worst, float(abs(ours / whole - 1)) if whole else WRONG))
    return with_many_digits(worst, *plant, G)


def _roots(p: Any) -> list[Any]:
    """The roots of a polynomial of numbers."""
    if p.degree() <= 0:
        return []
    listed = [MANY.context.mpmathify(c) for c in numbers_at(p.all_coeffs(), {})]
    return list(MANY.context.polyroots(listed, maxsteps=500, extraprec=400))


def _value(function: Any, x: Any) -> Any:
    """The value of N/D, or of C (xI − A)⁻¹ B + D."""
    m = MANY.context
    if len(function) == 2:
        top, bottom = (m.polyval([m.mpmathify(c) for c in numbers_at(p.all_coeffs(), {})], x) for p in function)
        return top / bottom
    A, B, C, D = function
    pencil = m.eye(len(A)) * x - m.matrix(A.tolist())
    return (m.matrix(C.tolist()) * m.lu_solve(pencil, m.matrix(B.tolist())))[0] + D.reshape(-1)[0]


def _zeros_off(
    system: Any, sets: tuple[Sequence[Any], Sequence[Any]], found: Sequence[Any], most: int, rest: int
) -> float:
    """How far zeros of the reduced function are from zeros of the whole; ∞ where a slow one is missing."""
    m, (poles, dropped) = MANY.context, sets
    size = max([m.mpf(1), *(abs(p) for p in poles)])
    worst = 0.0
    for zero in found:
        beside, at = (_value(system, zero + d) for d in (size / 10, m.mpf("1e-25")))
        worst = max(worst, float(abs(at) / abs(beside)) if beside else WRONG)
    near = min(abs(p - rest) for p in dropped)
    inside = _zeros_inside(system, poles, near * (1 - m.mpf("1e-6")), rest)
    return worst if worst > ALIKE * 1e3 or len(found) >= min(inside, most) else WRONG


def _zeros_inside(system: Any, poles: Sequence[Any], radius: Any, rest: int) -> int:
    """How many zeros lie in a circle about a point: the poles in it and how often the function turns round zero."""
    A, B, C, D = (np.array(M.tolist(), dtype=complex).reshape(M.shape) for M in system)
    points = rest + float(radius) * np.exp(2j * np.pi * np.arange(CIRCLE + 1) / CIRCLE)
    pencils = points[:, None, None] * np.eye(len(A)) - A
    values = (C @ np.linalg.solve(pencils, np.broadcast_to(B, (len(points), *B.shape)))).reshape(-1) + D.reshape(-1)[0]
    turns = float(np.sum(np.angle(values[1:] / values[:-1]))) / (2 * np.pi)
    return round(turns) + sum(1 for p in poles if abs(p - rest) < radius)
