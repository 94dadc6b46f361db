"""The pair (ζ, ω_n) that meets two specifications of a step response, found by bisection with 40 digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from random import Random
from typing import Any

import mpmath
import sympy as sp

from solver.conditions import conditions_of
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.points import SEED, PointSource
from solver.numeric.evaluation.values import NotEvaluable

DIGITS = 40
DAMPING = ("damping_ratio", "overshoot")
ORDER = ("damping_ratio", "natural_frequency", "settling_time", "peak_time", "overshoot", "rise_time")
"""Of more specifications than two the first are met, not both about the damping; the others are rounded ones."""

Number = Any
"""A number of mpmath."""


def with_unit_frequency(name: str, zeta: Number, band: Number) -> Number:
    """Return what is specified, for ω_n = 1. Times are proportional to 1/ω_n; ω_n itself counts as a frequency."""
    root = mpmath.sqrt(1 - zeta**2)
    match name:
        case "overshoot":
            return mpmath.exp(-mpmath.pi * zeta / root)
        case "settling_time":
            return band / zeta
        case "peak_time":
            return mpmath.pi / root
        case "rise_time":
            return (mpmath.pi - mpmath.acos(zeta)) / root
        case "damping_ratio":
            return zeta
    return mpmath.mpf(1)


def damping_and_frequency(given: Mapping[str, Any], band: Any = 4) -> tuple[Number, Number]:
    """Return ζ and ω_n that meet two of the specifications (numbers). Raises NotEvaluable if none does."""
    with mpmath.workdps(DIGITS):
        values = {name: mpmath.mpmathify(sp.N(given[name], DIGITS)) for name in _met(given)}
        damping = next((name for name in DAMPING if name in values), None)
        speeds = [name for name in values if name not in DAMPING]
        if not speeds:
            raise NotEvaluable("the specifications do not fix the natural frequency")
        if damping == "damping_ratio":
            zeta = values[damping]
        elif damping and values["overshoot"] == 0:
            zeta = mpmath.mpf(1)
        elif damping:
            zeta = _bisected(lambda z: with_unit_frequency("overshoot", z, band) - values["overshoot"])
        else:
            zeta = _bisected(lambda z: _mismatch(speeds[:2], values, z, band))
        name = speeds[0]
        if name == "natural_frequency":
            return zeta, values[name]
        return zeta, with_unit_frequency(name, zeta, band) / values[name]


def _met(given: Mapping[str, Any]) -> list[str]:
    """Return the names of two specifications that fix the poles; all there are where they do not."""
    names = [name for name in ORDER if name in given]
    second = [name for name in names[1:] if not {names[0], name} <= set(DAMPING)]
    return [names[0], second[0]] if second else names


def _mismatch(names: list[str], values: Mapping[str, Number], zeta: Number, band: Number) -> Number:
    """Return the difference of the logarithms of the ω_n that two specifications ask for."""
    frequencies = [
        values[name] if name == "natural_frequency" else with_unit_frequency(name, zeta, band) / values[name]
        for name in names
    ]
    return mpmath.log(frequencies[0]) - mpmath.log(frequencies[1])


def _bisected(function: Callable[[Number], Number]) -> Number:
    """Return the zero of a monotone function of ζ in (0, 1), or of one that only reaches it beyond: settling, ω_n."""
    low, high = mpmath.mpf(10) ** -DIGITS, 1 - mpmath.mpf(10) ** -DIGITS
    start = function(low) > 0
    if (function(high) > 0) == start:
        raise NotEvaluable("no damping ratio between 0 and 1 meets both specifications")
    for _ in range(4 * DIGITS):
        middle = (low + high) / 2
        low, high = (middle, high) if (function(middle) > 0) == start else (low, middle)
    return low


def second_order_cases(given: Mapping[str, Any], band: Any = 4) -> list[tuple[dict[Any, Any], Number, Number]]:
    """Return points (values of the parameters) with the ζ and ω_n there; one point where there are no parameters."""
    symbols = sorted({symbol for value in given.values() for symbol in (sp.Integer(0) + value).free_symbols}, key=str)
    random = Random(SEED)  # noqa: S311 - nothing secret
    found: list[tuple[dict[Any, Any], Number, Number]] = []
    inside = PointSource(symbols) if conditions_of(symbols) else None
    for _ in range(60 if symbols else 1):
        point = {symbol: sp.Rational(random.randint(10, 300), 100) for symbol in symbols}
        if inside is not None:
            point = {symbol: sp.Rational(str(complex(value).real)) for symbol, value in inside.draw().items()}
        values = {name: (sp.Integer(0) + value).subs(point) for name, value in given.items()}
        if symbols and not all(value > 0 and (name not in DAMPING or value < 1) for name, value in values.items()):
            continue
        try:
            found.append((point, *damping_and_frequency(values, band)))
        except NotEvaluable:
            if not symbols:
                raise
        if len(found) == 2:
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found that meet the specifications")
    return found


def second_order_poles(given: Mapping[str, Any], band: Any = 4) -> list[Any]:
    """Return the two poles as decimals of 40 digits; in symbols where ζ is given and specifications hold some.

    Raises NotEvaluable where they hold symbols and ζ is not given.
    """
    if any((sp.Integer(0) + value).free_symbols for value in given.values()):
        return _poles_in_symbols(given, band)
    _, zeta, omega_n = second_order_cases(given, band)[0]
    with mpmath.workdps(DIGITS):
        apart = omega_n * mpmath.sqrt(mpmath.mpc(zeta**2 - 1))
        return [_number(-zeta * omega_n + sign * apart) for sign in (1, -1)]


def _poles_in_symbols(given: Mapping[str, Any], band: Any) -> list[Any]:
    """The roots of s² + 2ζω s + ω², whatever ζ is."""
    speed = next((name for name in given if name in ("natural_frequency", "settling_time", "peak_time")), None)
    if "damping_ratio" not in given or speed is None:
        raise NotEvaluable("poles in symbols are judged where the damping ratio is given")
    zeta, value = (sp.Integer(0) + given[name] for name in ("damping_ratio", speed))
    omega_n = {"natural_frequency": value, "settling_time": band / (zeta * value)}.get(
        speed, sp.pi / (value * sp.sqrt(1 - zeta**2))
    )
    return [omega_n * (-zeta + sign * sp.sqrt(zeta**2 - 1)) for sign in (1, -1)]


def _number(z: Number) -> sp.Expr:
    return sp.Float(z.real, DIGITS) + sp.I * sp.Float(z.imag, DIGITS) if z.imag else sp.Float(z.real, DIGITS)


def second_order_residual(
    given: Mapping[str, Any], band: Any, formula: Callable[[Number, Number], list[Number]], answer: list[Any]
) -> float:
    """Return the largest relative difference of the answer's values and of formula(ζ, ω_n), lists of equal length."""
    worst = 0.0
    for point, zeta, omega_n in second_order_cases(given, band):
        with mpmath.workdps(DIGITS):
            expected = formula(zeta, omega_n)
            values = [mpmath.mpmathify(complex_of(each, point)) for each in answer]
            if len(values) != len(expected):
                return float("inf")
            size = max(abs(each) for each in expected)
            gaps = [abs(a - b) / size for a, b in zip(values, expected, strict=True)]
            worst = worst_of((worst, *(float(gap) for gap in gaps)))
    return with_many_digits(worst, given, band, answer)


def complex_of(value: Any, point: Mapping[Any, Any]) -> Any:
    """Return an expression's value at a point with 40 digits. Raises NotEvaluable where it is no number there."""
    number = sp.N((sp.Integer(0) + value).subs(point), DIGITS)
    if number.free_symbols or not number.is_number:
        raise NotEvaluable("the answer holds symbols that the question does not")
    return number
