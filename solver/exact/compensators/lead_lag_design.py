"""Lead-lag compensators by Bode's diagram: the lead gives the phase at the crossover, the lag takes off the magnitude.

Source: Ogata, Modern Control Engineering, §7–13.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil

import sympy as sp

from solver.exact.compensators.lead_design import DIGITS, alpha_of, meets
from solver.exact.compensators.sections import Compensated, Plant, Section, compensated, rounded
from solver.exact.frequency.following import phase_crossings

MOST_ROUNDS = 10
USUAL_LEAD = 30
"""Degrees that the lead is to give where the phase of the plant never is −180°."""

LARGEST_PHASE = 80.0


@dataclass(frozen=True)
class LeadLagRound:
    """One attempt: degrees added, φ of the lead; |K G C₁| at the crossover, which the lag takes off; the loop."""

    extra: sp.Expr
    phase: sp.Expr
    lead: Section
    size: sp.Expr
    lag: Section
    loop: Compensated


@dataclass(frozen=True)
class LeadLagDesign:
    """The crossover with the phase of G there and |K G|, and the attempts; `why` is empty or says why there is none.

    "phase": the lead would have to give too much; "lag_not_needed": the lead alone has the crossover there or below.
    """

    before: Compensated
    omega: sp.Expr
    angle: sp.Expr
    size: sp.Expr
    rounds: tuple[LeadLagRound, ...]
    why: str = ""
    needed: sp.Expr = sp.S.Zero


def lead_lag_by_bode(G: Plant, K: sp.Expr, wanted: sp.Expr, crossover: sp.Expr | None, extra: sp.Expr) -> LeadLagDesign:
    """Return the attempts with more and more degrees added, until the margin wanted is there.

    Where the lead would have to give too much at the crossover that is usually taken, a lower one is tried.
    """
    before = compensated(G, K)
    places = [crossover] if crossover is not None else _usual(G, wanted, extra)
    refused: list[LeadLagDesign] = []
    for omega in places:
        found = _at(G, K, wanted, omega, extra, before)
        if found.why != "phase":
            return found
        refused.append(found)
    nowhere = LeadLagDesign(before, sp.Integer(0), sp.Integer(0), sp.Integer(0), (), "no_crossover")
    return refused[0] if refused else nowhere


def _at(G: Plant, K: sp.Expr, wanted: sp.Expr, omega: sp.Expr, extra: sp.Expr, before: Compensated) -> LeadLagDesign:
    """Return the attempts with the crossover ω."""
    angle, size = sp.N(G.axis.continuous_phase(omega), 30), sp.N(K * G.axis.magnitude(omega), 30)
    rounds: list[LeadLagRound] = []
    added = extra
    for _ in range(MOST_ROUNDS):
        phase = sp.N(wanted - 180 - angle + added, 30)
        if not 0 < float(phase) <= LARGEST_PHASE:
            why = "phase" if float(phase) > 0 else "lead_not_needed"
            return LeadLagDesign(before, omega, angle, size, tuple(rounds), why, phase)
        tried = _attempt(G, K, omega, phase, added)
        if tried is None:
            return LeadLagDesign(before, omega, angle, size, tuple(rounds), "lag_not_needed", phase)
        rounds.append(tried)
        if meets(tried.loop, wanted):
            return LeadLagDesign(before, omega, angle, size, tuple(rounds))
        added += max(1, ceil(float(wanted) - tried.loop.margin))
    return LeadLagDesign(before, omega, angle, size, tuple(rounds), "phase", phase)


def _usual(G: Plant, wanted: sp.Expr, extra: sp.Expr) -> list[sp.Expr]:
    """Where the phase of G is −180°, and where the lead has to give what it usually gives; to three digits."""
    found = [phase_crossings(G.axis, degrees) for degrees in (sp.Integer(-180), wanted + extra - 180 - USUAL_LEAD)]
    return [rounded(each[0], 3) for each in found if each]


def _attempt(G: Plant, K: sp.Expr, omega: sp.Expr, phase: sp.Expr, extra: sp.Expr) -> LeadLagRound | None:
    alpha = rounded(alpha_of(phase), 3)
    lead = Section(rounded(1 / (omega * sp.sqrt(sp.N(alpha, 30))), 3), alpha)
    x, y = lead.T * omega, lead.alpha * lead.T * omega
    size = sp.N(K * G.axis.magnitude(omega) * sp.sqrt((1 + x**2) / (1 + y**2)), 30)
    if float(size) <= 1.02:
        return None
    T = rounded(10 / omega, 3)
    a = sp.N(T * omega, 30)
    for digits in DIGITS:
        lag = Section(T, rounded(sp.sqrt((1 + a**2) * size**2 - 1) / a, digits))
        loop = compensated(G, K, [lead, lag])
        if abs(float(loop.margins.gain_crossover) / float(omega) - 1) < 9e-4:
            break
    return LeadLagRound(extra, phase, lead, size, lag, loop)
