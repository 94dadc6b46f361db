"""Compensators by the root locus: a point s = −σ + jω made a root of 1 + C G, with enough gain.

The angle of C G there must be −180°. A lead section gives the angle that is missing: with its zero and its pole seen
from the point at half of it to both sides of the bisector of the angle between the way to the origin and the parallel
to the real axis, α is largest (Ogata, Modern Control Engineering, §6–6). A lag section has zero and pole so near to the
origin that they change the angle there little, and the gain at s = 0 by α (§6–7).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin
from typing import Any

import sympy as sp

from solver.exact.compensators.sections import Compensated, Plant, Section, compensated, least_gain, rounded

DIGITS = (4, 5, 6, 8)
NEAR_LEAD, NEAR_LAG = 0.005, 0.09
"""How near a root must be to the point, relatively."""

ON_THE_LOCUS = 6.0
"""Degrees by which the angle of a plant may be off for a point that is nearly on its locus."""

DISTANCES = (10, 20, 40, 80)
"""How much nearer to the origin than the point the zero of a lag section lies."""


@dataclass(frozen=True)
class AtThePoint:
    """G at the point: its value, magnitude, and angle in degrees; the angle φ that is missing to −180°, in (−180, 180].

    `theta` is the angle of the point itself, `radius` its distance to the origin.
    """

    point: sp.Expr
    value: sp.Expr
    size: sp.Expr
    angle: sp.Expr
    missing: sp.Expr
    theta: sp.Expr
    radius: sp.Expr


def plant_at(G: Plant, point: sp.Expr) -> AtThePoint:
    """Return what G is at a point of the upper half plane."""
    value = sp.expand(G.numerator.xreplace({G.s: point})) / sp.expand(G.denominator.xreplace({G.s: point}))
    number = sp.N(value, 30)
    angle = sp.Float(_degrees(number), 30)
    missing = sp.N(180 - angle, 30)
    missing = missing - 360 if missing > 180 else missing
    return AtThePoint(point, number, sp.N(abs(number), 30), angle, missing, sp.Float(_degrees(sp.N(point, 30)), 30),
                      sp.N(abs(sp.N(point, 30)), 30))  # fmt: skip


def _degrees(number: Any) -> Any:
    return sp.N(sp.arg(number) * 180 / sp.pi, 30)


@dataclass(frozen=True)
class LeadOnLocus:
    """Zero −1/T and pole −1/(αT) by their distances to the origin, K by the magnitude condition, the loop.

    `half_less` and `half_more` are (θ − φ)/2 and (θ + φ)/2, in degrees. `under`: the zero is just below the point.
    """

    at: AtThePoint
    half_less: sp.Expr
    half_more: sp.Expr
    zero: sp.Expr
    pole: sp.Expr
    section: Section
    gain: sp.Expr
    loop: Compensated


@dataclass(frozen=True)
class NoLocus:
    """Why there is no section: "not_needed" (the point is on the locus), "backwards", "too_much"; "off" for a lag."""

    why: str
    at: AtThePoint


def lead_on_locus(G: Plant, point: sp.Expr) -> LeadOnLocus | NoLocus:
    """Return the lead section by the bisector, rounded until a root is near enough to the point."""
    at = plant_at(G, point)
    phi, theta = float(at.missing), float(at.theta)
    if abs(phi) < 0.05:
        return NoLocus("not_needed", at)
    if phi < 0:
        return NoLocus("backwards", at)
    if phi >= theta - 0.5:
        return NoLocus("too_much", at)
    less, more = radians((theta - phi) / 2), radians((theta + phi) / 2)
    zero, pole = float(at.radius) * sin(less) / sin(more), float(at.radius) * sin(more) / sin(less)
    for digits in DIGITS:
        T = rounded(1 / zero, digits)
        section = Section(T, rounded(sp.Float(zero / pole), digits))
        gain = magnitude_condition(at, [section])
        loop = compensated(G, rounded(gain, digits), [section])
        if loop.stable and is_near(loop, G, point, NEAR_LEAD):
            break
    return LeadOnLocus(at, (at.theta - at.missing) / 2, (at.theta + at.missing) / 2, sp.Float(zero, 15),
                       sp.Float(pole, 15), section, gain, loop)  # fmt: skip


def magnitude_condition(at: AtThePoint, sections: list[Section]) -> sp.Expr:
    """K with |C G| = 1 at the point."""
    s = sp.N(at.point, 30)
    product = at.size
    for each in sections:
        product *= abs((each.T * s + 1) / (each.alpha * each.T * s + 1))
    return sp.N(1 / product, 30)


def is_near(loop: Compensated, G: Plant, point: sp.Expr, near: float) -> bool:
    """Whether a root of the loop is near enough to the point."""
    z = complex(sp.N(point))
    return min(abs(root - z) for root in roots_of_loop(loop, G)) <= near * abs(z)


def roots_of_loop(loop: Compensated, G: Plant) -> list[complex]:
    """The roots of D + N as floats."""
    p = sp.Poly(sp.N(loop.numerator + loop.denominator, 25), G.s)
    return [complex(root) for root in p.nroots(n=15, maxsteps=200)]


@dataclass(frozen=True)
class LagOnLocus:
    """K₀ with which the point is (nearly) a root without the section, the constant then, α, and the loop.

    `distance` is how much nearer to the origin than the point the zero lies; `angle` what the section takes.
    """

    at: AtThePoint
    gain: sp.Expr
    reached: sp.Expr
    wanted: sp.Expr
    ratio: sp.Expr
    distance: int
    angle: sp.Expr
    section: Section
    K: sp.Expr
    loop: Compensated
    root: sp.Expr


def lag_on_locus(G: Plant, point: sp.Expr, name: str, value: sp.Expr, before: tuple[Section, ...] = ()) -> Any:
    """Return the lag section (after the sections `before`) that the error needs; NoLocus where the point is off it.

    None where the constant is large enough without a section; "limit" where no gain is enough.
    """
    at = plant_at(_with(G, before), point)
    if abs(float(at.missing)) > ON_THE_LOCUS:
        return NoLocus("off", at)
    least = least_gain(G, name, value)
    if least.K is None or not least.limit.is_finite:
        return "limit"
    gain = sp.N(1 / at.size, 30)
    ratio = least.K / gain
    if float(ratio) <= 1:
        return None
    found = None
    for distance in DISTANCES:
        alpha = rounded(ratio, 3, "up")
        section = Section(rounded(distance / at.radius, 3), alpha)
        K = rounded(least.K, 12) if least.K.has(sp.Float) else least.K
        loop = compensated(G, K, [*before, section])
        z = complex(sp.N(point))
        root = min(roots_of_loop(loop, G), key=lambda each: abs(each - z))
        s = sp.N(point, 30)
        turned = (section.T * s + 1) / (section.alpha * section.T * s + 1)
        found = LagOnLocus(at, gain, sp.N(least.limit * gain, 30), least.wanted, ratio, distance, _degrees(turned),
                           section, K, loop, sp.Float(root.real, 15) + sp.I * sp.Float(root.imag, 15))  # fmt: skip
        if loop.stable and abs(root - z) <= NEAR_LAG * abs(z) / 2:
            break
    return found


def _with(G: Plant, sections: tuple[Section, ...]) -> Plant:
    """The plant behind some sections."""
    top = sp.expand(sp.Mul(*(each.T * G.s + 1 for each in sections)) * G.numerator)
    bottom = sp.expand(sp.Mul(*(each.alpha * each.T * G.s + 1 for each in sections)) * G.denominator)
    return Plant(top, bottom, G.s, G.delay)


__all__ = ["AtThePoint", "LagOnLocus", "LeadOnLocus", "NoLocus", "lag_on_locus", "lead_on_locus", "plant_at"]
