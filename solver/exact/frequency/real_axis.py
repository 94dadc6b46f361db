"""Where L(jω) meets the negative real axis: exact where ω² (cos ωT) is of degree two at most, else in decimals."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.crossings import Crossover, gain_crossovers
from solver.exact.frequency.following import HALF_TURN, levels, turning_points
from solver.exact.frequency.surds import WORKING, decimal, value_of
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import DIGITS


@dataclass(frozen=True)
class PhaseCrossovers:
    """Where L < 0: the roots of I, Im(N D̄) = ω I(ω²), with R < 0; None with a dead time. `everywhere`: I is zero.

    `real_axis` are all frequencies ω > 0 where L is real and not zero, with its value there; π/T is one of them.
    With a dead time there are more beyond the last one, all of smaller size; `last` is then its frequency.
    """

    polynomial: sp.Poly | None
    found: tuple[Crossover, ...]
    everywhere: bool = False
    real_axis: tuple[tuple[sp.Expr, sp.Expr], ...] = ()
    last: sp.Expr | None = None


@lru_cache(maxsize=64)
def phase_crossovers(L: OnAxis) -> PhaseCrossovers:
    """All ω ≥ 0 where L(jω) is real and negative; raises NotExact for a dead time beside L₀(∞) ≠ 0."""
    if L.late:
        return _late_crossovers(L)
    p, R = L.parts.imaginary, L.parts.real
    start = _at_rest(L)
    if p.is_zero:
        return PhaseCrossovers(p, (), everywhere=True)
    sign = L.first_sign(p)
    found = [] if start is None else [_at_an_end(sp.S.Zero, L.place(sp.S.Zero), start, sign)]
    every = []
    for root in L.places(p):
        before, sign = sign, sign * (-1) ** root.multiplicity
        if _is_root(R, root.value):
            continue  # a pole or zero on the axis
        real, _ = L.rational_value(root.value)
        every.append((root.omega, real))
        if decimal(real) < 0:
            turn = 0 if before == sign else sign
            found.append(Crossover(root.omega, root.value, -real, sp.Integer(HALF_TURN), turn))
    if L.end is not None and all(value_of(each, L.end.value) != 0 for each in (L.parts.above, L.parts.below)):
        real, _ = L.rational_value(L.end.value)
        every.append((L.end.omega, real))
        if decimal(real) < 0:
            found.append(_at_an_end(L.end.omega, L.end.value, real, -sign))
    return PhaseCrossovers(p, tuple(found), real_axis=tuple(every))


def _at_an_end(omega: sp.Expr, place: sp.Expr, value: sp.Expr, turn: int) -> Crossover:
    """Where the curve crosses the negative real axis on its way to that of −ω."""
    return Crossover(omega, place, -value, sp.Integer(HALF_TURN), turn, end=True)


def _at_rest(L: OnAxis) -> sp.Expr | None:
    """L(0) where that is finite and negative."""
    c, power = L.start
    return c if power == 0 and decimal(c) < 0 else None


def _is_root(p: sp.Poly, x: sp.Expr) -> bool:
    """Whether a polynomial is zero at a number; in decimals, but for rounding."""
    value = value_of(p, x)
    if not x.has(sp.Float):
        return bool(value == 0)
    size = sum(abs(decimal(c) * decimal(x) ** i) for i, c in enumerate(reversed(p.all_coeffs())))
    return bool(abs(decimal(value)) <= size * mpmath.mpf(10) ** (8 - DIGITS))


def _late_crossovers(L: OnAxis) -> PhaseCrossovers:
    """With a dead time: those of every level −180° − 360° k up to the first one beyond which |L₀| only falls."""
    if L.excess == 0:
        raise NotExact("frequency/dead_time_and_feedthrough")
    flat = [*_stationary(L), *(each.omega for each in gain_crossovers(L).found)]
    beyond = max(map(decimal, flat), default=mpmath.mpf(0))
    start, found, every = _at_rest(L), [], []
    with mpmath.workdps(WORKING):
        for omega, level, turn in levels(L, beyond):
            exact = _exactly(L, omega, level)
            magnitude = L.magnitude(exact)
            negative = level % 360 == HALF_TURN
            every.append((exact, -magnitude if negative else magnitude))
            if negative:
                found.append(Crossover(exact, sp.expand(exact**2), magnitude, sp.Integer(HALF_TURN), turn))
    if start is not None:
        first = 1 if _falls_at_once(L) else -1
        found.insert(0, _at_an_end(sp.S.Zero, sp.S.Zero, start, first))
    return PhaseCrossovers(None, tuple(found), real_axis=tuple(every), last=found[-1].omega if found else None)


def _exactly(L: OnAxis, omega: Any, level: int) -> sp.Expr:
    """The frequency in a closed form where ∠L₀ does not depend on it, else in decimals."""
    if not L.roots:
        c, power = L.start
        angle = 90 * power - (180 if decimal(c) < 0 else 0)
        return sp.pi * (angle - level) / (180 * L.delay)
    return sp.Float(omega, DIGITS)


def _stationary(L: OnAxis) -> list[sp.Expr]:
    """Where |L₀| has no slope."""
    P, Q = L.parts.above, L.parts.below
    p = P.diff() * Q - P * Q.diff()
    return [] if p.is_zero else [root.omega for root in L.places(p)]


def _falls_at_once(L: OnAxis) -> bool:
    """Whether the phase falls from ω = 0 on."""
    first = next(iter(turning_points(L)), mpmath.mpf(1)) / 2
    with mpmath.workdps(WORKING):
        return bool(L.turned(first) < L.turned(mpmath.mpf(0)))


__all__ = ["PhaseCrossovers", "phase_crossovers"]
