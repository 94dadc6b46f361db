"""How often L(jω) with parameters goes round −1: the turns, and the poles of the loop, case by case.

A crossing of the negative real axis is a turn where it lies left of −1, which parameters may decide; everything else
(the poles of L, the beginning and the end of the curve, the directions) must be the same for all their values.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

import sympy as sp

from solver.exact.frequency.encirclements import half_turn_passes
from solver.exact.frequency.parametric_crossings import (
    ParametricAxis,
    ParametricCrossing,
    PositiveRoot,
    parametric_axis,
    parametric_real_axis,
    positive_roots,
)
from solver.exact.frequency.with_parameters import decided_sign, parametric_factors
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.root_counts import root_counts
from solver.exact.stability.routh import routh

MOST_OPEN = 3
"""So many crossings may be left of −1 or not; more make too many cases."""


@dataclass(frozen=True)
class TurnCase:
    """Where `condition` holds (True: always) the curve turns `clockwise`, and the loop has `closed_loop` poles.

    `beyond` are the crossings left of −1; poles are those in the right half plane.
    """

    condition: Any
    beyond: tuple[ParametricCrossing, ...]
    clockwise: int
    closed_loop: int


@dataclass(frozen=True)
class PoleArc:
    """What becomes of the half circle round a pole of L on the axis, at `omega` ≥ 0: half turns clockwise at infinity.

    They pass the negative real axis `passes` times, those of a pair together.
    """

    omega: sp.Expr
    half_turns: int
    passes: int


@dataclass(frozen=True)
class ParametricTurns:
    """The cases, with P = `open_loop` poles of L in the right half plane.

    `on_axis` poles of the loop on the axis cancel in L; `closing` is what the way through ω = ∞ adds.
    """

    cases: tuple[TurnCase, ...]
    open_loop: int
    on_axis: int
    arcs: tuple[PoleArc, ...]
    closing: int
    crossings: tuple[ParametricCrossing, ...]

    @property
    def condition(self) -> Any:
        """Where the closed loop is stable."""
        if self.on_axis:
            return sp.false
        return sp.Or(*(case.condition for case in self.cases if not case.closed_loop))


def parametric_turns(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol) -> ParametricTurns:
    """Count for L = N/D with parameters, nothing cancelled in N and D; raises NotExact where a sign is not known."""
    L = parametric_axis(parametric_factors(numerator, denominator, s))
    if L.excess < 0:
        raise NotExact("conversions/ill_posed_direct_path")
    P, _ = _counted(denominator, s)
    hidden = sp.gcd(sp.Poly(numerator, s), sp.Poly(denominator, s)).as_expr()
    _, on_axis = _counted(hidden, s)
    crossings = parametric_real_axis(L)
    negative = [each for each in crossings if decided_sign(each.value) < 0]
    arcs = tuple(_arcs(L))
    closing = _closing(L)
    fixed = sum(each.passes for each in arcs) + closing
    sides = {each: sign_of(sp.factor(1 + each.value)) for each in negative}
    if 0 in sides.values():
        raise NotExact("frequency/through_minus_one", discrete=False)
    moving = [each for each, side in sides.items() if side is None]
    cases = []
    for condition, beyond in _patterns(moving, L):
        left = tuple(each for each in negative if sides[each] == -1 or each in beyond)
        turns = fixed + sum(each.turn * (1 if each.start else 2) for each in left)
        if turns + P < 0:
            raise NotExact("frequency/count_not_confirmed")
        cases.append(TurnCase(condition, left, turns, turns + P))
    return ParametricTurns(tuple(cases), P, on_axis, arcs, closing, crossings)


def _patterns(
    moving: Sequence[ParametricCrossing], L: ParametricAxis
) -> Iterator[tuple[Any, tuple[ParametricCrossing, ...]]]:
    """Which crossings lie left of −1, and where that is so; what cannot be is left out."""
    if not moving:
        yield sp.true, ()
        return
    if len(moving) > MOST_OPEN:
        raise NotExact("frequency/too_many_cases", n=len(moving))
    gain = sorted(L.N.LC().free_symbols - L.D.LC().free_symbols, key=str) or sorted(
        set().union(*(each.value.free_symbols for each in moving)), key=str
    )
    for signs in product((1, -1), repeat=len(moving)):
        beyond = tuple(each for each, sign in zip(moving, signs, strict=True) if sign < 0)
        if _contradicts(moving, signs):
            continue
        conditions = [sign * sp.factor(1 + each.value) for each, sign in zip(moving, signs, strict=True)]
        condition = all_positive(conditions, gain[:1])
        if condition is not sp.false:
            yield condition, beyond


def _contradicts(moving: Sequence[ParametricCrossing], signs: Sequence[int]) -> bool:
    """Whether a crossing that is left of another one is said to be right of −1, and the other one left of it."""
    pairs = list(zip(moving, signs, strict=True))
    return any(
        one < other and sign_of(sp.factor(a.value - b.value)) in (0, 1) for a, one in pairs for b, other in pairs
    )


def _counted(p: sp.Expr, s: sp.Symbol) -> tuple[int, int]:
    """The roots on the right and on the axis; raises NotExact where a sign that decides is not known."""
    right = on = 0
    for factor, m in sp.Poly(p, s).factor_list()[1]:
        listed = factor.all_coeffs()
        if len(listed) < 2:
            continue
        counts = root_counts(listed)
        if counts is None:
            column = (sp.cancel(each / listed[0]) for each in routh(listed).first_column)
            what = next(each for each in column if sign_of(each) is None)
            raise NotExact("frequency/stability_not_known", p=factor.as_expr(), what=sp.factor(what))
        right, on = right + m * counts.outside, on + m * counts.on
    return right, on


def _arcs(L: ParametricAxis) -> Iterator[PoleArc]:
    """The poles on the axis, that at the origin first."""
    c, power = L.start
    if power < 0:
        limit = 90 * power - (180 if decided_sign(c) < 0 else 0)
        I = L.parts.imaginary
        lowest = next(x for x in reversed(I.all_coeffs()) if x != 0)
        # on the negative real axis the phase is above −180° where the curve is below the axis
        after = limit - decided_sign(lowest) if limit % 360 == 180 else limit
        yield PoleArc(sp.S.Zero, -power, half_turn_passes(2 * limit - 180 * power - after, after))
    for root in positive_roots(L.parts.below):
        before, after = (_quadrant(L, root, side) for side in (-1, 1))
        m = root.power // 2
        after += 360 * round((before - 180 * m - after) / 360)
        yield PoleArc(root.frequency, m, 2 * half_turn_passes(before, after))


def _quadrant(L: ParametricAxis, root: PositiveRoot, side: int) -> int:
    """The direction of L just below (`side` −1) or above a pole on the axis, as the middle of its quadrant."""
    signs = [_beside(p, root, side) for p in (L.parts.real, L.parts.imaginary)]
    return {(1, 1): 45, (-1, 1): 135, (-1, -1): -135, (1, -1): -45, (1, 0): 0, (-1, 0): 180, (0, 1): 90, (0, -1): -90}[
        signs[0], signs[1]
    ]


def _beside(p: sp.Poly, root: PositiveRoot, side: int) -> int:
    """The sign of p just beside a root."""
    if p.is_zero:
        return 0
    times = 0
    while p.rem(root.factor).is_zero:
        p, times = p.quo(root.factor), times + 1
    return root.sign_of(p) * (root.slope * side) ** times


def _closing(L: ParametricAxis) -> int:
    """The crossing at ω = ∞, of a loop whose L(∞) is left of −1."""
    if L.excess:
        return 0
    value = sp.factor(L.N.LC() / L.D.LC())
    return 0 if decided_sign(1 + value) > 0 else -decided_sign(L.parts.imaginary.LC())


__all__ = ["ParametricTurns", "PoleArc", "TurnCase", "parametric_turns"]
