"""Lag compensators by Bode's diagram: the crossover moves down to where the phase is enough.

There |K G| = α, and the section (T s + 1)/(α T s + 1) with its zero a decade below, T = 10/ω, divides by nearly α and
costs at most 90° − arctan 10 = 5.7°. Source: Ogata, Modern Control Engineering, §7–12.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import sympy as sp

from solver.exact.compensators.lead_design import DIGITS, meets
from solver.exact.compensators.sections import Compensated, Plant, Section, compensated, course_of, rounded
from solver.exact.frequency.following import phase_crossings

MOST_ROUNDS = 8
DECADES = (10, 20, 40, 100, 200)
"""How far below the crossover the zero is put."""

SAMPLES = 400


@dataclass(frozen=True)
class LagRound:
    """One attempt: degrees added, the phase of G looked for, ω where it is, α = |K G| there, T, and the loop."""

    extra: sp.Expr
    phase: sp.Expr
    omega: sp.Expr | None
    size: sp.Expr | None = None
    section: Section | None = None
    loop: Compensated | None = None


@dataclass(frozen=True)
class LagDesign:
    """The attempts, the last of them right if `met`; else `best` is the largest margin of G anywhere, at `at`."""

    before: Compensated
    rounds: tuple[LagRound, ...]
    met: bool
    best: sp.Expr | None = None
    at: sp.Expr | None = None


def lag_by_bode(G: Plant, K: sp.Expr, wanted: sp.Expr, extra: sp.Expr) -> LagDesign:
    """Return the attempts with more and more degrees added, until the margin wanted is there."""
    before = compensated(G, K)
    rounds: list[LagRound] = []
    added = extra
    for _ in range(MOST_ROUNDS):
        tried = _attempt(G, K, wanted, added)
        rounds.append(tried)
        if tried.loop is None:
            break
        if meets(tried.loop, wanted):
            return LagDesign(before, tuple(rounds), met=True)
        missing = float(wanted) - tried.loop.margin
        added += max(1, ceil(missing)) if missing > 0 else 1
    best, at = _best(G, before)
    return LagDesign(before, tuple(rounds), False, sp.Float(best, 15), sp.Float(at, 15))


def _attempt(G: Plant, K: sp.Expr, wanted: sp.Expr, extra: sp.Expr) -> LagRound:
    phase = wanted - 180 + extra
    found = [omega for omega in phase_crossings(G.axis, phase) if float(K * G.axis.magnitude(omega)) > 1]
    if not found:
        return LagRound(extra, phase, None)
    omega = found[-1]
    size = sp.N(K * G.axis.magnitude(omega), 30)
    section = Section(rounded(10 / omega, 3), rounded(size, 3))
    return LagRound(extra, phase, omega, size, section, compensated(G, K, [section]))


def _best(G: Plant, before: Compensated) -> tuple[float, float]:
    """The largest margin that G itself would have at any lower crossover."""
    stop = float(before.margins.gain_crossover) if before.margins.gain_crossover.is_finite else 1.0
    value = course_of(G)
    listed = [(180 + value(omega)[1], omega) for i in range(SAMPLES) if (omega := stop * 10 ** (-5 * i / SAMPLES))]
    return max(listed)


@dataclass(frozen=True)
class NoLag:
    """Why no lag section crosses there: "amplifies" (|K G| ≤ 1: it only attenuates), "phase" (of G is too little)."""

    why: str
    omega: sp.Expr
    size: sp.Expr
    margin: sp.Expr


@dataclass(frozen=True)
class LagAt:
    """The section for a crossover that is asked for: |K G| and ∠G there, the decade of the zero, and the loop."""

    omega: sp.Expr
    size: sp.Expr
    angle: sp.Expr
    below: int
    section: Section
    loop: Compensated


def lag_at(G: Plant, K: sp.Expr, wanted: sp.Expr, omega: sp.Expr) -> LagAt | NoLag:
    """Return the section with which K G crosses at ω with the margin wanted: α from |C G| = 1."""
    size, angle = sp.N(K * G.axis.magnitude(omega), 30), sp.N(G.axis.continuous_phase(omega), 30)
    if float(size) <= 1:
        return NoLag("amplifies", omega, size, angle + 180)
    if float(angle + 180) <= float(wanted):
        return NoLag("phase", omega, size, angle + 180)
    for below in DECADES:
        for digits in DIGITS:
            T = rounded(below / omega, 3)
            a = sp.N(T * omega, 30)
            section = Section(T, rounded(sp.sqrt((1 + a**2) * size**2 - 1) / a, digits + 1))
            loop = compensated(G, K, [section])
            if abs(float(loop.margins.gain_crossover) / float(omega) - 1) < 9e-4:
                break
        if meets(loop, wanted):
            return LagAt(omega, size, angle, below, section, loop)
    return NoLag("phase", omega, size, angle + 180)
