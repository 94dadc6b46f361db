"""The peak of a response, from the residues of its transform."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from math import exp, factorial
from typing import Any

import mpmath
import sympy as sp

from solver.exact.functions.fractions import highest_power, residue_at
from solver.exact.functions.rational import RationalMatrix
from solver.exact.functions.residues import FactorResidues
from solver.exact.linear_algebra.radicals import multiple_angles
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.linear_algebra.spectrum import DIGITS
from solver.exact.time_response.long_run import constant_root, limit, slowest
from solver.exact.time_response.signals import read_signal, written
from solver.exact.time_response.stationary import Stationary, stationary

SAMPLES = 1500
LATEST = 40.0
"""In units of the slowest time constant: later than that nothing is left to see."""

SEEN = 1e-7
"""What exceeds the start and the limit by less than that, relatively, is not called a peak."""


@dataclass(frozen=True)
class Peak:
    """The value of largest size that a function attains after its start, and when first.

    `stationary` is how the times without a slope were found (None in discrete time), `number` which of them it is,
    counted from 0. It counts time from `delay`.
    """

    time: sp.Expr
    value: sp.Expr
    stationary: Stationary | None = None
    number: int = 0
    delay: sp.Expr = sp.S.Zero


def peak(image: RationalMatrix, y: sp.Expr, time: sp.Symbol, *, discrete: bool) -> Peak | None:
    """The peak of a scalar function y with an image; None where its size is largest at the start or in the limit.

    Only for functions that tend to a limit, or oscillate steadily with one frequency; with parameters only for one
    pair that starts level from zero, the step response of an under-damped system.
    """
    if y.has(sp.DiracDelta, sp.Heaviside):
        return None
    if y.free_symbols - {time}:
        return None if discrete else _of_step(image, y, time)
    final = limit(image, discrete=discrete)
    moving = [pole for pole in image.poles if not constant_root(pole[0].factor, discrete=discrete)]
    if not moving or (final is None and not _steady(image, moving, discrete=discrete)):
        return None
    bound = float(abs(final[0])) if final is not None else 0.0
    if discrete:
        return _largest_sample(image, y, time, bound) if final is not None else None
    found = stationary(y, [(root, order) for each, order in moving for root in each.factor.roots], time)
    if found is None:
        found = Stationary("searched", _term_by_term(sp.diff(y, time), time), None, _searched(image))
    return _best(y, time, found, bound)


def _steady(image: RationalMatrix, moving: Sequence[tuple[FactorResidues, int]], *, discrete: bool) -> bool:
    """Whether the function is a constant and one undamped oscillation."""
    (each, order), *others = moving
    root = each.factor.roots[0]
    constant = [power for other, power in image.poles if constant_root(other.factor, discrete=discrete)]
    single = not others and order == 1 and each.factor.degree == 2 and all(power == 1 for power in constant)
    return single and not discrete and root.kind == "complex" and root.sigma == 0


def _of_step(image: RationalMatrix, y: sp.Expr, t: sp.Symbol) -> Peak | None:
    """The peak of c (1 − e^{σt}(cos ωt − σ/ω sin ωt)), whose slope is a multiple of e^{σt} sin ωt: it overshoots."""
    final = limit(image, discrete=False)
    moving = [pole for pole in image.poles if not constant_root(pole[0].factor, discrete=False)]
    if final is None or final[0] == 0 or len(moving) != 1:
        return None
    (each, order), *_ = moving
    root = next((root for root in each.factor.roots if root.kind == "complex" and is_positive(root.shift)), None)
    if (
        root is None
        or order != 1
        or each.factor.degree != 2
        or any(sp.cancel(sp.diff(y, t, i).subs(t, 0)) != 0 for i in (0, 1))
    ):
        return None
    speed = sp.cancel(final[0] * (root.sigma**2 + root.shift**2) / root.shift)
    first, slope = sp.pi / root.shift, speed * sp.exp(root.sigma * t) * sp.sin(root.shift * t)
    found = Stationary("pair", slope, (sp.sin(root.shift * t), sp.S.Zero), [first])
    return Peak(first, final[0] * (1 + sp.exp(sp.pi * root.sigma / root.shift)), found)


def _term_by_term(slope: sp.Expr, t: sp.Symbol) -> sp.Expr:
    """A slope with one term for each mode and power of time."""
    terms = read_signal(slope, t, discrete=False).terms.items()
    return sp.Add(*(c * written(term, t, discrete=False) for (_, term), c in terms))


def _best(y: sp.Expr, t: sp.Symbol, flat: Stationary, bound: float) -> Peak | None:
    """The stationary point with the largest size, if it is larger than at the start and in the limit."""
    found: Peak | None = None
    largest = max(bound, abs(float(y.subs(t, 0).evalf(DIGITS)))) * (1 + SEEN) + 1e-300
    for number, time in enumerate(flat.times):
        size = abs(float(y.subs(t, time).evalf(DIGITS))) if float(time.evalf(DIGITS)) > 0 else 0.0
        if size > largest * (1 + 1e-13):
            value = y.subs(t, time)
            value = value.evalf(DIGITS) if time.has(sp.Float) else sp.expand(value, power_exp=False, log=False)
            found, largest = Peak(time, value, flat, number), size
    return found


def _searched(image: RationalMatrix) -> list[sp.Expr]:
    """The zeros of the slope between samples, in decimals; the largest value is at one of them."""
    with mpmath.workdps(DIGITS + 15):
        modes = modes_of(image)
    rates = [-m.real for m, _, _ in modes if m.real < 0]
    last = LATEST / min(rates) if rates else 0.0
    fastest = max((abs(m) for m, _, _ in modes), default=1.0)
    fine = [last * (i / SAMPLES) ** 3 for i in range(SAMPLES + 1)]
    even = [last * i / SAMPLES for i in range(SAMPLES)]
    times = sorted({*fine, *even, *(i / fastest / 20 for i in range(SAMPLES) if i / fastest / 20 < last)})
    slope = _slope(modes)
    values = [(value, t) for t in times if (value := slope(t))]  # a zero met exactly is between its neighbours
    return [_refined(modes, a, b) for (before, a), (after, b) in pairwise(values) if before * after < 0]


def _slope(modes: Sequence[tuple[Any, int, Any]]) -> Callable[[float], float]:
    """The derivative of the sum of the modes, roughly: of each conjugate pair one mode, twice."""
    terms = [(complex(m), j, complex(c) * (2 if m.imag > 0 else 1)) for m, j, c in modes if m.imag >= 0]
    simple = [(m, c * m) for m, j, c in terms if j == 1]
    real = [(m.real, a.real) for m, a in simple if not m.imag]
    turning = [(m, a) for m, a in simple if m.imag]
    others = [term for term in terms if term[1] > 1]

    def at(t: float) -> float:
        total = sum(a * exp(m * t) for m, a in real) + sum((a * cmath.exp(m * t)).real for m, a in turning)
        return total + (float(value_of_modes(others, t, 1, cmath.exp)) if others else 0.0)

    return at


def _refined(modes: Sequence[tuple[complex, int, Any]], a: float, b: float) -> sp.Expr:
    with mpmath.workdps(DIGITS + 15):
        slope = partial(value_of_modes, modes, order=1, exponential=mpmath.exp)
        reached = mpmath.mpf(10) ** (-DIGITS - 5) * max(abs(a), abs(b))  # a smaller step is none, and is not waited for
        root = mpmath.findroot(slope, (a, b), solver="anderson", tol=reached, maxsteps=200, verify=False)
        return sp.Float(root, DIGITS)


def modes_of(image: RationalMatrix) -> list[tuple[Any, int, Any]]:
    """λ, j and the coefficient of t^{j−1}/(j−1)! e^{λt}, in numbers."""
    found = []
    for each, order in image.poles:
        for root in each.factor.roots:
            value = mpmath.mpmathify(sp.N(root.value, DIGITS + 15))
            for j in range(1, order + 1):
                c = residue_at(each.residues[j - 1], root, image.shape)[0]
                found.append((mpmath.mpc(value), j, mpmath.mpc(mpmath.mpmathify(sp.N(c, DIGITS + 15)))))
    return found


def value_of_modes(modes: Sequence[tuple[Any, int, Any]], t: Any, order: int, exponential: Callable[[Any], Any]) -> Any:
    """The derivative of an order (0 or 1) of the sum of the modes, in the arithmetic of `exponential`."""
    total: Any = 0
    for value, j, c in modes:
        envelope = t ** (j - 1) / factorial(j - 1)
        slope = value * envelope + (t ** (j - 2) / factorial(j - 2) if j > 1 else 0)
        total += c * exponential(value * t) * (slope if order else envelope)
    return total.real


def _largest_sample(image: RationalMatrix, y: sp.Expr, k: sp.Symbol, bound: float) -> Peak | None:
    """The sample of largest size, among those before everything has died out."""
    constant = slowest(image, discrete=True)
    last = min(int(LATEST * (constant or 0.0)) + _highest_order(image) + 2, SAMPLES)
    values = [float(y.subs(k, i).evalf(DIGITS)) for i in range(last)]
    largest = max(map(abs, values))
    first = next(i for i in range(last) if abs(values[i]) >= largest * (1 - 1e-13))
    if first == 0 or abs(values[first]) <= max(bound, abs(values[0])) * (1 + SEEN):
        return None
    return Peak(sp.Integer(first), sp.expand(multiple_angles(y.subs(k, first))))


def _highest_order(image: RationalMatrix) -> int:
    """The highest multiplicity of a pole."""
    return max((highest_power(each) for each in image.residues), default=0)
