"""Lemmas: a lag section by Bode's diagram, in attempts or for a crossover that is given."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.frequencies import size_and_angle
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute, phase
from solver.tasks.compensators.refusals import no_lag
from solver.tasks.compensators.specifications import CompensatorOptions, written

if TYPE_CHECKING:
    from sympy import Expr

EXTRA = 6
"""Degrees that are added at first: a section with its zero a decade below costs at most 5.7°."""


@lemma("lag_design")
def lag_in_attempts(G: exact.Plant, K: Expr, options: CompensatorOptions) -> Derivation[exact.Compensated]:
    """Attempts with more and more degrees added; raises Unsolved where the plant has the phase nowhere."""
    wanted = options.phase_margin
    extra = options.extra_phase if options.extra_phase is not None else sp.Integer(EXTRA)
    found = exact.lag_by_bode(G, K, wanted, extra)
    claims = {
        f"phase{i}": Claim(total(difference(wanted, sp.Integer(180)), each.extra), each.phase, "the phase looked for")
        for i, each in enumerate(found.rounds)
    }
    yield Step("attempts", claims=claims, rounds=found.rounds, wanted=wanted, extra=extra, met=found.met,
               chosen=options.extra_phase is None)  # fmt: skip
    last = found.rounds[-1]
    if not found.met or last.loop is None or last.section is None or last.omega is None:
        raise Unsolved("compensators/lag_cannot", best=found.best, omega=found.at, wanted=wanted)
    L = written(G, K)
    at = value_at(L, G.s, sp.I * last.omega)
    claims = {
        "phase": Claim(phase(at), sp.N(_principal(last.phase), 30), "the phase there"),
        "size": Claim(absolute(at), last.size, "the magnitude there"),
        "T": Claim(quotient(sp.Integer(10), last.omega), sp.N(10 / last.omega, 30), "T"),
    }
    lines = size_and_angle(L, G.s, sp.I * last.omega, last.size, sp.N(_principal(last.phase), 30))
    yield Step("section", claims=claims, steps=lines, round=last, several=len(found.rounds) > 1, T=last.section.T,
               alpha=last.section.alpha)  # fmt: skip
    return last.loop


def _principal(degrees: Expr) -> Expr:
    """An angle in (−180, 180]."""
    return degrees - 360 * sp.ceiling((degrees - 180) / 360)


@lemma("lag_design")
def lag_for_a_crossover(G: exact.Plant, K: Expr, options: CompensatorOptions) -> Derivation[exact.Compensated]:
    """The section for a crossover that is given; raises Unsolved where none does it."""
    omega, wanted = options.crossover, options.phase_margin
    assert omega is not None  # noqa: S101 - the caller has seen to it
    found = exact.lag_at(G, K, wanted, omega)
    at = value_at(written(G, K), G.s, sp.I * omega)
    size = Claim(absolute(at), found.size, "the magnitude there")
    if isinstance(found, exact.NoLag):
        yield Step("at_the_crossover", claims={"size": size}, omega=omega, margin=found.margin)
        raise no_lag(found.why, omega=omega, size=found.size, margin=found.margin, wanted=wanted)
    a = sp.N(found.section.T * omega, 30)
    alpha = sp.sqrt((1 + a**2) * found.size**2 - 1) / a
    claims = {
        "size": size,
        "phase": Claim(phase(at), sp.N(_principal(found.angle), 30), "the phase there"),
        "T": Claim(quotient(sp.Integer(found.below), omega), sp.Integer(found.below) / omega, "T"),
    }
    lines = size_and_angle(written(G, K), G.s, sp.I * omega, found.size, claims["phase"].right)
    yield Step("crossing", claims=claims, steps=lines, found=found, omega=omega, T=found.section.T, a=a, exactly=alpha,
               alpha=found.section.alpha, below=sp.Integer(found.below))  # fmt: skip
    return found.loop
