"""Compensators K Π (T s + 1)/(α T s + 1) in a loop: the least gain for an error, the loop with its margins.

α < 1 is a lead section, α > 1 a lag section. Numbers that are chosen are rounded, and then checked as they are.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, ROUND_HALF_EVEN, Decimal
from functools import cached_property
from math import atan, atan2, degrees
from typing import Any

import sympy as sp

from solver.exact.frequency.axis import OnAxis, on_axis
from solver.exact.frequency.encirclements import encirclements
from solver.exact.frequency.margins import Margins, margins_of

POWERS = {"error": 0, "position_constant": 0, "velocity_constant": 1, "acceleration_constant": 2}
"""The power of s that the loop is multiplied by before s → 0."""


@dataclass(frozen=True)
class Section:
    """(T s + 1)/(α T s + 1)."""

    T: sp.Rational
    alpha: sp.Rational

    @property
    def lead(self) -> bool:
        """Whether it turns the phase forward."""
        return bool(self.alpha < 1)


@dataclass(frozen=True)
class Plant:
    """G = N/D e^{−delay s}, polynomials in s with numbers; `in_factors` are both as they were given, if in factors."""

    numerator: sp.Expr
    denominator: sp.Expr
    s: sp.Symbol
    delay: sp.Expr = sp.S.Zero
    in_factors: tuple[sp.Expr, sp.Expr] | None = None

    @cached_property
    def axis(self) -> OnAxis:
        """G on the imaginary axis."""
        return on_axis(self.numerator, self.denominator, self.s, self.delay)


def compensator_parts(K: sp.Expr, sections: Sequence[Section], s: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator of K Π (T s + 1)/(α T s + 1)."""
    top = sp.Mul(*(each.T * s + 1 for each in sections))
    bottom = sp.Mul(*(each.alpha * each.T * s + 1 for each in sections))
    return (K * top if len(sections) != 1 else sp.Mul(K, top, evaluate=False) if K != 1 else top), bottom


@dataclass(frozen=True)
class Compensated:
    """The loop C G: its margins, and whether the loop that it closes is stable."""

    K: sp.Expr
    sections: tuple[Section, ...]
    numerator: sp.Expr
    denominator: sp.Expr
    axis: OnAxis
    margins: Margins
    stable: bool

    @property
    def margin(self) -> float:
        """The phase margin as a float."""
        return float(self.margins.phase_margin)


def compensated(G: Plant, K: sp.Expr, sections: Sequence[Section] = ()) -> Compensated:
    """Return the loop of K and some sections before a plant."""
    top = sp.expand(K * sp.Mul(*(each.T * G.s + 1 for each in sections)) * G.numerator)
    bottom = sp.expand(sp.Mul(*(each.alpha * each.T * G.s + 1 for each in sections)) * G.denominator)
    L = on_axis(top, bottom, G.s, G.delay)
    turns = encirclements(top, bottom, G.s, G.delay)
    stable = turns.closed_loop == 0 and turns.on_axis == 0 and not turns.through
    return Compensated(K, tuple(sections), top, bottom, L, margins_of(L), stable)


@dataclass(frozen=True)
class LeastGain:
    """The least gain K for an error or a constant of K G, with lim s^k G for s → 0 (`limit`: 0, a number or oo).

    `K` is None where no gain does it: the limit is zero. Where the limit is infinite any gain does, and K is 1.
    """

    power: int
    limit: sp.Expr
    wanted: sp.Expr
    K: sp.Expr | None


def least_gain(G: Plant, name: str, value: sp.Expr) -> LeastGain:
    """Return the least gain of a proportional controller that meets a specification by its name."""
    power = POWERS[name]
    c, nu = G.axis.start  # G ≈ c s^ν
    limit = c if nu + power == 0 else sp.oo * sp.sign(c) if nu + power < 0 else sp.Integer(0)
    wanted = 1 / value - 1 if name == "error" else value
    if limit == 0:
        return LeastGain(power, limit, wanted, None)
    return LeastGain(power, limit, wanted, wanted / limit if limit.is_finite else sp.Integer(1))


def rounded(value: Any, digits: int, way: str = "near") -> sp.Rational:
    """Return a positive number to some significant digits, as a fraction; `way` is "near", "up" or "down"."""
    number = Decimal(sp.N(value, 30).__str__())
    place = Decimal(1).scaleb(number.adjusted() - digits + 1)
    how = {"near": ROUND_HALF_EVEN, "up": ROUND_CEILING, "down": ROUND_FLOOR}[way]
    return sp.Rational(str(number.quantize(place, rounding=how)))


def course_of(G: Plant) -> Callable[[float], tuple[float, float]]:
    """Return |G(jω)| and its continuous phase in degrees as a function of ω, in floats: for looking around."""
    top, bottom = ([float(c) for c in p.all_coeffs()] for p in (G.axis.N, G.axis.D))
    c, nu = G.axis.start
    start = 90.0 * nu - (180.0 if c.is_negative else 0.0)
    roots = [(complex(r), m) for r, m in G.axis.roots]
    late = float(G.delay)

    def value(omega: float) -> tuple[float, float]:
        angle = start - degrees(omega * late)
        for r, m in roots:
            if r.imag:
                angle += m * degrees(atan2(-2 * omega * r.real, abs(r) ** 2 - omega**2))
            else:
                angle += m * degrees(atan(-omega / r.real))
        return abs(_at(top, 1j * omega) / _at(bottom, 1j * omega)), angle

    return value


def _at(coefficients: Sequence[float], x: complex) -> complex:
    total = 0j
    for c in coefficients:
        total = total * x + c
    return total
