"""The directions in which branches leave complex poles and reach complex zeros, in degrees.

Near a pole p of multiplicity m, D(s) = E(s) (s − p)ᵐ, the branches are (s − p)ᵐ = −K N(p)/E(p); near a zero alike.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import mpmath
import sympy as sp

from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.root_locus.equation import WORKING_DIGITS, LocusEquation, PlacedRoot, roots_with_factors
from solver.exact.root_locus.lines import normal_angle

LARGEST_DENOMINATOR = 120
"""An angle that is such a part of a half turn, or a multiple of it, is told as a rational number."""

NEAR = sp.Float(10) ** -24


@dataclass(frozen=True)
class Arrow:
    """The angle of the arrow from another pole or zero to the point; `times` it counts (its multiplicity)."""

    start: sp.Expr
    arrow: sp.Expr
    degrees: sp.Expr
    times: int
    pole: bool


@dataclass(frozen=True)
class Bearings:
    """Of one pole or zero above the real axis: the arrows to it, their angles summed up, and the directions there."""

    point: PlacedRoot
    pole: bool
    arrows: tuple[Arrow, ...]
    total: sp.Expr
    angles: tuple[sp.Expr, ...]


def departures(equation: LocusEquation) -> tuple[Bearings, ...]:
    """The directions at the complex poles of the upper half plane, in the order of the poles."""
    return tuple(
        _directions(equation, each, pole=True) for each in roots_with_factors(equation.denominator) if each.upper
    )


def arrivals(equation: LocusEquation) -> tuple[Bearings, ...]:
    """The directions at the complex zeros of the upper half plane, from which their branches come."""
    return tuple(
        _directions(equation, each, pole=False) for each in roots_with_factors(equation.numerator) if each.upper
    )


def _directions(equation: LocusEquation, at: PlacedRoot, *, pole: bool) -> Bearings:
    arrows = []
    for p, of_pole in ((equation.numerator, False), (equation.denominator, True)):
        for other in roots_with_factors(p):
            if other is not at and not (of_pole == pole and other.value == at.value):
                arrow = sp.expand(at.value - other.value)
                arrows.append(Arrow(other.value, arrow, degrees_of(arrow), other.multiplicity, of_pole))
    start = sp.Integer(180 if equation.positive else 0)
    sign = 1 if pole else -1
    total = start + sum(sign * (-1 if each.pole else 1) * each.times * each.degrees for each in arrows)
    total = _tidied(total)
    m = at.multiplicity
    angles = tuple(normal_angle(_tidied((total + 360 * q) / m)) for q in range(m))
    return Bearings(at, pole, tuple(arrows), total, angles)


def degrees_of(x: sp.Expr) -> sp.Expr:
    """The angle of a complex number that is not zero, in degrees: rational where it is so, else a decimal."""
    with mpmath.workdps(WORKING_DIGITS):
        real, imaginary = sp.N(x, WORKING_DIGITS).as_real_imag()
        angle = mpmath.degrees(mpmath.atan2(mpmath.mpmathify(imaginary), mpmath.mpmathify(real)))
        return _tidied(sp.Float(angle, WORKING_DIGITS))


def _tidied(degrees: sp.Expr) -> sp.Expr:
    """A rational number in place of a decimal that agrees with one of a small denominator; else a decimal of 30 digits.

    Arguments of algebraic numbers that are rational are multiples of such fractions of a half turn.
    """
    if degrees.is_Rational:
        return degrees
    near = Fraction(str(degrees / 180)).limit_denominator(LARGEST_DENOMINATOR)
    rational = sp.Rational(180 * near.numerator, near.denominator)
    return rational if abs(degrees - rational) < NEAR else sp.Float(degrees, DIGITS)
