"""Exact numbers as decimals: the right value, the digits that are asked for, and the tolerance that marking grants."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy as sp

SHOWN = 12
"""Significant digits of a right value that does not end."""

PRECISE = 40
"""Digits to which a number is computed before it is rounded."""

LEAST_UNIT = Fraction(1, 10)
"""A number that is not whole is asked for with one decimal place at least: without, it would be read as exact."""


def exactly(value: Any) -> Fraction | None:
    """Return a real number of sympy, to 40 digits where it is irrational; None for anything else."""
    if isinstance(value, sp.Rational):
        return Fraction(value.p, value.q)
    if not isinstance(value, sp.Expr) or value.free_symbols or not value.is_number:
        return None
    parts = complex_parts(value)
    return parts[0] if parts is not None and parts[1] == 0 else None


def complex_parts(value: Any) -> tuple[Fraction, Fraction] | None:
    """Return the real and the imaginary part of a finite number; None for anything else."""
    if not isinstance(value, sp.Expr) or value.free_symbols or value.is_finite is False:
        return None
    re, im = (_fraction(part) for part in value.as_real_imag())
    if re is None or im is None:
        return None
    small = max(abs(re), abs(im)) / 10 ** (PRECISE // 2)
    return (re if abs(re) > small else Fraction(0)), (im if abs(im) > small else Fraction(0))


def _fraction(part: sp.Expr) -> Fraction | None:
    if isinstance(part, sp.Rational):
        return Fraction(part.p, part.q)
    found = part.evalf(PRECISE)
    if not isinstance(found, sp.Float) or not found.is_finite:
        return Fraction(0) if found.is_zero else None
    return Fraction(str(found))


def unit_of(number: Fraction, digits: int) -> Fraction:
    """Return one unit of the last of so many significant digits, a tenth at most; of whole numbers one."""
    if number.denominator == 1:
        return Fraction(1)
    exponent = _exponent(abs(number)) - digits + 1
    return min(Fraction(10) ** exponent, LEAST_UNIT)


def _exponent(number: Fraction) -> int:
    """Return e with 10^e ≤ number < 10^(e + 1)."""
    guess = len(str(number.numerator)) - len(str(number.denominator))
    return guess if number >= Fraction(10) ** guess else guess - 1


def tolerance_of(number: Fraction, digits: int) -> Decimal:
    """Return by how much a decimal of so many digits may differ: half a unit, nothing where it can be exact."""
    unit = unit_of(number, digits)
    return Decimal(0) if (number / unit).denominator == 1 else _decimal(unit / 2)


def value_of(number: Fraction) -> Decimal:
    """Return a number to twelve significant digits, exactly where it has no more."""
    if number.denominator == 1:
        return Decimal(number.numerator)
    return _decimal(_rounded(number, Fraction(10) ** (_exponent(abs(number)) - SHOWN + 1)))


def typed(number: Fraction, digits: int) -> str:
    """Return a number as it is typed with so many digits: 0.67, 7.0 for 7.04, 13 for 13."""
    unit = unit_of(number, digits)
    rounded = _decimal(_rounded(number, unit))
    return str(rounded.quantize(_decimal(unit))) if (number / unit).denominator != 1 else written(rounded)


def written(number: Decimal) -> str:
    """Return a decimal without needless zeros; with a power of ten where it is very small or large."""
    if number == 0:
        return "0"
    plain = number.normalize()
    few = -8 <= plain.adjusted() <= SHOWN + 3
    return f"{plain:f}" if few else f"{plain:E}"


def _rounded(number: Fraction, unit: Fraction) -> Fraction:
    return round(number / unit) * unit


def _decimal(number: Fraction) -> Decimal:
    """Return a fraction whose denominator divides a power of ten."""
    places = 0
    while (number * 10**places).denominator != 1:
        places += 1
    return Decimal(int(number * 10**places)).scaleb(-places)
