"""Lead compensators by Bode's diagram: the phase that is missing, α of it, and the crossover that α leads to.

A section (T s + 1)/(α T s + 1) gives at most φ with sin φ = (1 − α)/(1 + α), at ω = 1/(T √α), and there |·| = 1/√α.
At a crossover ω with |K G(jω)| = 1/M it must give M, and then at most arccos(1/M); with the phase φ it is
ωT = (M − cos φ)/sin φ, ωαT = (M cos φ − 1)/(M sin φ). Source: Ogata, Modern Control Engineering, §7–11.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import asin, ceil, cos, degrees, radians, sin

import sympy as sp

from solver.exact.compensators.sections import Compensated, Plant, Section, compensated, course_of, rounded
from solver.exact.frequency.crossings import gain_crossovers

MOST_ROUNDS = 12
LARGEST_PHASE = 80.0
"""Degrees that one section is asked for at most: beyond, α goes to zero."""

SAMPLES = 600
REACH = 1000.0
"""In units of the crossover without a section: so far a crossover is looked for."""

DIGITS = (3, 4, 5, 6, 8)


@dataclass(frozen=True)
class LeadRound:
    """One attempt: degrees added, φ in degrees, α of it, ω with |K G| = √α (None: none), T, and the loop."""

    extra: sp.Expr
    phase: sp.Expr
    alpha: sp.Rational
    omega: sp.Expr | None
    section: Section | None = None
    loop: Compensated | None = None


@dataclass(frozen=True)
class LeadDesign:
    """The attempts, the last of them right if `met`; `best` is the largest margin at any crossover, at `at`."""

    before: Compensated
    rounds: tuple[LeadRound, ...]
    met: bool
    best: sp.Expr | None = None
    at: sp.Expr | None = None
    chosen: LeadAt | None = None


@dataclass(frozen=True)
class LeadAt:
    """A section for a crossover `omega`: |K G| = 1/`M` and ∠G there, the phase φ of the section, and the loop.

    ωT is `zero`, ωαT is `pole`. `largest` is arccos(1/M) in degrees.
    """

    omega: sp.Expr
    M: sp.Expr
    angle: sp.Expr
    needed: sp.Expr
    phase: sp.Expr
    largest: sp.Expr
    zero: sp.Expr
    pole: sp.Expr
    section: Section
    loop: Compensated


def meets(loop: Compensated, wanted: sp.Expr) -> bool:
    """Whether a loop is stable and has the phase margin."""
    return bool(loop.stable and loop.margins.phase_margin >= wanted)


def alpha_of(phase: sp.Expr) -> sp.Expr:
    """α of the largest phase in degrees."""
    sine = sp.N(sp.sin(sp.pi * phase / 180), 30)
    return (1 - sine) / (1 + sine)


def lead_by_bode(G: Plant, K: sp.Expr, wanted: sp.Expr, extra: sp.Expr) -> LeadDesign:
    """Return the attempts with more and more degrees added, until the margin wanted is there."""
    before = compensated(G, K)
    rounds: list[LeadRound] = []
    added = extra
    for _ in range(MOST_ROUNDS):
        tried = _attempt(G, before, wanted, added)
        if tried is None:
            break
        rounds.append(tried)
        if tried.loop is None:
            break
        if meets(tried.loop, wanted):
            return LeadDesign(before, tuple(rounds), met=True)
        missing = float(wanted) - tried.loop.margin
        added += max(1, ceil(missing)) if missing > 0 else 1
    best, at = _best(G, before, K)
    if best is not None and best > float(wanted):
        omega = rounded(at, 3)
        chosen = lead_at(G, K, wanted, omega, sp.Integer(0), spare=True)
        if isinstance(chosen, LeadAt) and meets(chosen.loop, wanted):
            return LeadDesign(before, tuple(rounds), met=True, chosen=chosen)
    shown = (None, None) if best is None else (sp.Float(best, 15), sp.Float(at, 15))
    return LeadDesign(before, tuple(rounds), False, *shown)


def _attempt(G: Plant, before: Compensated, wanted: sp.Expr, extra: sp.Expr) -> LeadRound | None:
    phase = wanted - before.margins.phase_margin + extra
    if not 0 < float(phase) <= LARGEST_PHASE:
        return None
    alpha = rounded(alpha_of(phase), 3)
    found = gain_crossovers(before.axis, sp.sqrt(alpha)).found
    if not found:
        return LeadRound(extra, phase, alpha, None)
    omega = found[-1].omega
    section = Section(rounded(1 / (sp.N(omega, 30) * sp.sqrt(sp.N(alpha, 30))), 3), alpha)
    return LeadRound(extra, phase, alpha, omega, section, compensated(G, before.K, [section]))


def _best(G: Plant, before: Compensated, K: sp.Expr) -> tuple[float | None, float]:
    """The largest phase margin at any crossover that a section can lead to, and that crossover."""
    start = float(before.margins.gain_crossover) if before.margins.gain_crossover.is_finite else 1.0
    value, (best, at) = course_of(G), (None, 0.0)
    for i in range(1, SAMPLES + 1):
        omega = start * REACH ** (i / SAMPLES)
        size, angle = value(omega)
        size *= float(K)
        if size < 1:
            margin = 180 + angle + 90 - degrees(asin(size))
            if best is None or margin > best:
                best, at = margin, omega
    return best, at


@dataclass(frozen=True)
class NoLead:
    """Why no lead section crosses there: "amplifies" (|K G| ≥ 1 already), "too_much" (of φ), "too_little"."""

    why: str
    omega: sp.Expr
    size: sp.Expr
    needed: sp.Expr
    largest: sp.Expr


def lead_at(
    G: Plant, K: sp.Expr, wanted: sp.Expr, omega: sp.Expr, extra: sp.Expr, *, spare: bool = False
) -> LeadAt | NoLead:
    """Return the section with which K G crosses at ω with the margin wanted; `spare` takes more phase than needed."""
    size, angle = K * G.axis.magnitude(omega), G.axis.continuous_phase(omega)
    needed = sp.N(wanted - 180 - angle + extra, 30)
    number = float(size)
    if number >= 1:
        return NoLead("amplifies", omega, size, needed, sp.Integer(0))
    largest = sp.Float(90 - degrees(asin(number)), 15)
    if float(needed) >= float(largest):
        return NoLead("too_much", omega, size, needed, largest)
    floor = max(float(needed), 0.0)
    phase = floor + (float(largest) - floor) / 2 if spare or float(needed) <= 0 else float(needed)
    turned, M = radians(phase), 1 / number
    zero, pole = (M - cos(turned)) / sin(turned), (M * cos(turned) - 1) / (M * sin(turned))
    for digits in DIGITS:
        T = rounded(sp.Float(zero) / omega, digits)
        section = Section(T, rounded(sp.Float(pole) / omega / T, digits, "down"))
        loop = compensated(G, K, [section])
        close = abs(float(loop.margins.gain_crossover) / float(omega) - 1) < 9e-4
        if close and meets(loop, wanted):
            break
    return LeadAt(omega, 1 / sp.N(size, 30), sp.N(angle, 30), needed, sp.Float(phase, 15), largest,
                  sp.Float(zero, 15), sp.Float(pole, 15), section, loop)  # fmt: skip


@dataclass(frozen=True)
class FreeLead:
    """A section whose largest phase is at a crossover that is asked for, and the gain that makes it the crossover."""

    omega: sp.Expr
    angle: sp.Expr
    size: sp.Expr
    phase: sp.Expr
    alpha: sp.Rational
    section: Section
    loop: Compensated


def lead_with_free_gain(G: Plant, wanted: sp.Expr, omega: sp.Expr, extra: sp.Expr) -> FreeLead | NoLead:
    """Return the section with its largest phase at ω and K = √α/|G(jω)|."""
    size, angle = G.axis.magnitude(omega), G.axis.continuous_phase(omega)
    phase = sp.N(wanted - 180 - angle + extra, 30)
    if float(phase) <= 0:
        return NoLead("too_little", omega, size, phase, sp.Integer(0))
    if float(phase) >= LARGEST_PHASE + 8:
        return NoLead("ninety", omega, size, phase, sp.Integer(90))
    for digits in DIGITS:
        alpha = rounded(alpha_of(phase), digits, "down")
        section = Section(rounded(1 / (omega * sp.sqrt(sp.N(alpha, 30))), digits), alpha)
        K = rounded(sp.sqrt(sp.N(alpha, 30)) / sp.N(size, 30), digits + 1)
        loop = compensated(G, K, [section])
        if abs(float(loop.margins.gain_crossover) / float(omega) - 1) < 9e-4 and meets(loop, wanted):
            break
    return FreeLead(omega, sp.N(angle, 30), size, phase, alpha, section, loop)
