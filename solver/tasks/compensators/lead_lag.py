"""Lemma: a lead and a lag section by Bode's diagram."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.frequencies import size_and_angle
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.compensators.lead import of_sine
from solver.tasks.compensators.refusals import not_both
from solver.tasks.compensators.specifications import CompensatorOptions, written

if TYPE_CHECKING:
    from sympy import Expr

EXTRA = 6
"""Degrees that are added at first: what the lag section costs at most, with its zero a decade below the crossover."""


@lemma("lead_lag_design")
def both_in_attempts(G: exact.Plant, K: Expr, options: CompensatorOptions) -> Derivation[exact.Compensated]:
    """The crossover, the lead that its phase needs, the lag for what is left of the magnitude; raises Unsolved."""
    wanted = options.phase_margin
    extra = options.extra_phase if options.extra_phase is not None else sp.Integer(EXTRA)
    found = exact.lead_lag_by_bode(G, K, wanted, options.crossover, extra)
    if found.why == "no_crossover":
        raise Unsolved("compensators/no_crossover")
    at = value_at(written(G, K), G.s, sp.I * found.omega)
    principal = sp.N(found.angle - 360 * sp.ceiling((found.angle - 180) / 360), 30)
    claims = {
        "size": Claim(absolute(at), found.size, "the magnitude there"),
        "phase": Claim(phase(at), principal, "the phase there"),
    }
    lines = size_and_angle(written(G, K), G.s, sp.I * found.omega, found.size, principal)
    yield Step("crossover", claims=claims, steps=lines, found=found, given=options.crossover is not None)
    if found.rounds:
        claims = {
            f"phase{i}": Claim(
                total(difference(difference(wanted, sp.Integer(180)), found.angle), each.extra), each.phase, "the phase"
            )
            for i, each in enumerate(found.rounds)
        }
        yield Step("attempts", claims=claims, rounds=found.rounds, extra=extra, chosen=options.extra_phase is None)
    if found.why:
        raise not_both(found.why, needed=found.needed, omega=found.omega, wanted=wanted)
    yield _sections(G, K, found)
    return found.rounds[-1].loop


def _sections(G: exact.Plant, K: Expr, found: exact.LeadLagDesign) -> Step:
    """α₁, T₁ and α₂, T₂ of the attempt that succeeds."""
    last = found.rounds[-1]
    omega, s, lead = found.omega, G.s, last.lead
    T = 1 / (omega * sp.sqrt(sp.N(lead.alpha, 30)))
    inner = product(quotient(lead.T * s + 1, lead.alpha * lead.T * s + 1), written(G, K))
    claims = {
        "alpha": Claim(quotient(*of_sine(last.phase)), exact.alpha_of(last.phase), "α of the lead"),
        "T": Claim(quotient(sp.Integer(1), product(omega, sp.sqrt(lead.alpha))), T, "T of the lead"),
        "size": Claim(absolute(value_at(inner, s, sp.I * omega)), last.size, "the magnitude with the lead"),
        "T2": Claim(quotient(sp.Integer(10), omega), sp.Integer(10) / omega, "T of the lag"),
    }
    lines = size_and_angle((lead.T * s + 1) / (lead.alpha * lead.T * s + 1) * written(G, K), s, sp.I * omega, last.size)
    return Step("sections", claims=claims, steps=lines, round=last, omega=omega, several=len(found.rounds) > 1)
