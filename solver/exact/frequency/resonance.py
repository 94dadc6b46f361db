"""Frequency responses of T: functions of ω, the largest magnitude, and where it has fallen to 1/√2 of that at ω = 0."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import mpmath
import sympy as sp

from solver.exact.frequency.axis import OnAxis
from solver.exact.frequency.crossings import Crossover, gain_crossovers
from solver.exact.frequency.following import turning_points
from solver.exact.frequency.surds import WORKING, decimal, value_of
from solver.exact.linear_algebra.signs import is_positive
from solver.exact.stability.boundary import parts_on_circle
from solver.exact.time_response.signals import read_signal


@dataclass(frozen=True)
class Resonance:
    """The largest |T|, at ω > 0; `polynomial` in w = ω² is zero where |T|² has no slope, at `stationary` ω."""

    polynomial: sp.Poly
    stationary: tuple[sp.Expr, ...]
    peak: Crossover | None


@dataclass(frozen=True)
class Bandwidth:
    """|T(0)|/√2 and the first frequency where |T| falls to it (None: nowhere); `polynomial` is zero there in ω²."""

    level: sp.Expr
    polynomial: sp.Poly
    omega: sp.Expr | None


@dataclass(frozen=True)
class Sinusoid:
    """α cos ωt + β sin ωt."""

    omega: sp.Expr
    cosine: sp.Expr
    sine: sp.Expr


@dataclass(frozen=True)
class Oscillations:
    """A constant and sinusoids, the frequencies rising where they are numbers."""

    constant: sp.Expr
    sinusoids: tuple[Sinusoid, ...]


def oscillations(u: sp.Expr, t: sp.Symbol) -> Oscillations | None:
    """Read a signal as a sum of a constant and sinusoids; None for others, and for a constant alone."""
    found = read_signal(u, t, discrete=False)
    if found.impulses or any(begin != 0 or n or growth != 0 for begin, (n, growth, _, _) in found.terms):
        return None
    angles = list(dict.fromkeys(angle for _, (_, _, angle, _) in found.terms if angle != 0))
    if not angles or not all(is_positive(angle) for angle in angles):
        return None
    if all(angle.is_number for angle in angles):
        angles.sort(key=decimal)
    parts = {(angle, sine): c for (_, (_, _, angle, sine)), c in found.terms.items()}
    waves = (Sinusoid(w, parts.get((w, False), sp.S.Zero), parts.get((w, True), sp.S.Zero)) for w in angles)
    return Oscillations(parts.get((sp.S.Zero, False), sp.S.Zero), tuple(waves))


@lru_cache(maxsize=64)
def resonance(L: OnAxis) -> Resonance | None:
    """Where |T| is largest; None where it goes to infinity on the axis, or does not depend on ω."""
    P, Q = L.parts.above, L.parts.below
    p = P.diff() * Q - P * Q.diff()
    if p.is_zero or L.start[1] < 0 or L.places(Q) or (L.end is not None and value_of(Q, L.end.value) == 0):
        return None
    ends = [] if L.end is None else [L.end]
    listed = [(root, L.magnitude(root.omega)) for root in (*L.places(p), *ends)]
    bounds = [decimal(L.magnitude(sp.S.Zero))]
    if L.end is None and L.excess == 0:
        bounds.append(abs(decimal(L.N.LC() / L.D.LC())))
    best = max(listed, key=lambda pair: decimal(pair[1]), default=None)
    peak = None
    if best is not None and decimal(best[1]) > max(bounds) * (1 + mpmath.mpf(10) ** -12):
        root, size = best
        peak = Crossover(root.omega, root.value, size, L.phase(root.omega), end=root is L.end)
    return Resonance(p, tuple(root.omega for root, _ in listed if root is not L.end), peak)


@lru_cache(maxsize=64)
def bandwidth(L: OnAxis) -> Bandwidth | None:
    """Where |T| = |T(0)|/√2 for the first time; None where T(0) is zero or infinite."""
    c, power = L.start
    if power:
        return None
    level = sp.expand(abs(c) / sp.sqrt(2))
    found = gain_crossovers(L, level)
    first = found.found[0].omega if found.found else None
    return Bandwidth(level, found.polynomial, first)


def phase_function(L: OnAxis, omega: sp.Symbol) -> sp.Expr:
    """∠L(jω) in degrees for ω > 0: arctangents of the factors where their sum stays in (−180, 180], else one of all.

    Of a discrete loop it is their sum, each in (−180, 180]; a factor z turns by ωT.
    """
    if L.discrete:
        return _of_samples(L, omega)
    factors = [(factor, sign * m) for p, sign in ((L.N, 1), (L.D, -1)) for factor, m in p.factor_list()[1]]
    simple = all(factor.degree() <= 2 for factor, _ in factors) and _within_a_turn(L)
    late = 180 * omega * L.delay / sp.pi
    if simple:
        c, power = L.start
        start = 90 * power - (180 if decimal(c) < 0 else 0)
        return (
            sp.Add(sp.Integer(start), *(m * _angle(f, omega) for f, m in factors if f.degree() and f.TC() != 0)) - late
        )
    R, slope = (p.as_expr().subs(L.parts.w, omega**2) for p in (L.parts.real, L.parts.imaginary))
    real, imaginary = R, sp.expand(omega * slope)
    if L.late:
        turned = omega * L.delay
        c, s = sp.cos(turned), sp.sin(turned)
        real, imaginary = real * c + imaginary * s, imaginary * c - real * s
    return 180 * sp.atan2(imaginary, real) / sp.pi


def _of_samples(L: OnAxis, omega: sp.Symbol) -> sp.Expr:
    """The sum of the angles of the monic factors at e^{jωT}, and 180° where the number before them is negative."""
    angles: list[sp.Expr] = [sp.Integer(180)] if decimal(L.N.LC() / L.D.LC()) < 0 else []
    for p, sign in ((L.N, 1), (L.D, -1)):
        for factor, m in p.factor_list()[1]:
            if factor.degree() == 1 and factor.TC() == 0:
                turned = omega * L.sample_time
            else:
                even, odd = parts_on_circle(factor.to_field().monic(), L.parts.w)
                c, s = L.place(omega), L.unit(omega)
                imaginary = sp.expand(s * odd.as_expr().subs(L.parts.w, c))
                turned = sp.atan2(imaginary, even.as_expr().subs(L.parts.w, c))
            angles.append(sign * m * 180 / sp.pi * turned)
    return sp.Add(*angles)


def _angle(factor: sp.Poly, omega: sp.Symbol) -> sp.Expr:
    """The angle of a factor divided by its value at 0: it begins with 0°."""
    c = factor.all_coeffs()
    if factor.degree() == 1:
        return 180 / sp.pi * sp.atan(omega * c[0] / c[1])
    below = c[2] - c[0] * omega**2
    return 180 / sp.pi * (sp.atan2(c[1] * omega, below) if c[2] > 0 else sp.atan2(-c[1] * omega, -below))


def _within_a_turn(L: OnAxis) -> bool:
    """Whether the continuous phase stays in (−180°, 180°], by its values where it turns and at both ends."""
    if L.late:
        return False
    with mpmath.workdps(WORKING):
        turning = turning_points(L)
        tiny = (turning[0] if turning else mpmath.mpf(1)) * mpmath.mpf(10) ** -12
        large = (turning[-1] if turning else mpmath.mpf(1)) * mpmath.mpf(10) ** 12
        size = max([mpmath.mpf(1), *(abs(r) for r, _ in L.roots)])
        at = [tiny, *(each * (1 + sign * mpmath.mpf(10) ** -15) for each in turning for sign in (-1, 1)), large * size]
        values = [L.turned(each) for each in at]
        return bool(min(values) > -180 and max(values) <= 180)


__all__ = ["Bandwidth", "Oscillations", "Resonance", "Sinusoid", "bandwidth", "oscillations", "phase_function",
           "resonance"]  # fmt: skip
