"""The straight parts of a root locus: its segments of the real axis, and the asymptotes of the branches to infinity."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.root_locus.equation import LocusEquation, PlacedRoot, roots_with_factors


@dataclass(frozen=True)
class RealPoint:
    """A real pole or zero of L; `right` counts the real poles and zeros to the right of it, each as often as it is."""

    point: PlacedRoot
    pole: bool
    right: int


def real_points(equation: LocusEquation) -> tuple[RealPoint, ...]:
    """The real poles and zeros from right to left."""
    found = [
        (each, pole)
        for p, pole in ((equation.denominator, True), (equation.numerator, False))
        for each in roots_with_factors(p)
        if each.real
    ]
    found.sort(key=lambda pair: -sp.N(pair[0].value, 40))
    listed, right = [], 0
    for each, pole in found:
        listed.append(RealPoint(each, pole, right))
        right += each.multiplicity
    return tuple(listed)


def real_axis_segments(equation: LocusEquation) -> list[sp.Interval]:
    """The intervals of the real axis with K ≥ 0, from left to right, their ends counted in.

    To the right of a point of the locus of 180° lie an odd number of real poles and zeros, of 0° an even one.
    """
    points, odd = real_points(equation), equation.positive
    ends = [sp.oo, *(each.point.value for each in points), -sp.oo]
    counts = [*(each.right for each in points), sum(each.point.multiplicity for each in points)]
    found: list[tuple[sp.Expr, sp.Expr]] = []
    for low, high, count in zip(ends[1:], ends, counts, strict=False):
        if bool(count % 2) == odd:
            if found and found[-1][0] == high:
                found[-1] = (low, found[-1][1])
            else:
                found.append((low, high))
    return [sp.Interval(low, high) for low, high in reversed(found)]


@dataclass(frozen=True)
class Asymptotes:
    """`angles` in degrees, in (−180°, 180°], and their `centroid`; `poles` and `zeros` are the sums of these."""

    angles: tuple[sp.Expr, ...]
    centroid: sp.Expr
    poles: sp.Expr
    zeros: sp.Expr


def asymptotes(equation: LocusEquation) -> Asymptotes | None:
    """The asymptotes of the deg D − deg N branches that go to infinity; None where there are none."""
    q = equation.excess
    if q < 1:
        return None
    start = 180 if equation.positive else 0
    angles = tuple(normal_angle(sp.Rational(start + 360 * k, q)) for k in range(q))
    poles, zeros = (_sum_of_roots(p) for p in (equation.denominator, equation.numerator))
    return Asymptotes(angles, sp.expand((poles - zeros) / q), poles, zeros)


def normal_angle(degrees: sp.Expr) -> sp.Expr:
    """The angle from −180° (excluded) to 180°."""
    turns = sp.ceiling((degrees - 180) / 360)
    return degrees - 360 * turns


def _sum_of_roots(p: sp.Poly) -> sp.Expr:
    if p.degree() == 0:
        return sp.Integer(0)
    K, listed = p.domain, p.rep.to_list()
    return expression(K, -listed[1] / listed[0])
