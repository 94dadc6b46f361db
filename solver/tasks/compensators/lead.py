"""Lemmas: a lead section by Bode's diagram, in attempts or for a crossover that is given."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.frequencies import size_and_angle
from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.calculus import value_at
from solver.stated.complex_numbers import absolute
from solver.tasks.compensators.refusals import no_lead
from solver.tasks.compensators.specifications import CompensatorOptions, written

if TYPE_CHECKING:
    from sympy import Expr

EXTRA = 5
"""Degrees that are added at first: the section moves the crossover to where the phase is less."""


@lemma("lead_design")
def lead_in_attempts(G: exact.Plant, K: Expr, options: CompensatorOptions) -> Derivation[exact.Compensated]:
    """Attempts with more and more degrees added; raises Unsolved where one section cannot give the margin."""
    wanted = options.phase_margin
    extra = options.extra_phase if options.extra_phase is not None else sp.Integer(EXTRA)
    found = exact.lead_by_bode(G, K, wanted, extra)
    if found.rounds:
        yield _attempts(found, wanted, extra, chosen=options.extra_phase is None)
    last = found.rounds[-1] if found.rounds else None
    if found.met and found.chosen is None and last is not None:
        yield _section(G, K, last, found, wanted)
        assert last.loop is not None  # noqa: S101 - it meets what is asked
        return last.loop
    if found.met and found.chosen is not None:
        yield Step("another_crossover", unclaimed="a choice", omega=found.chosen.omega, tried=bool(found.rounds))
        yield at_crossover(G, K, found.chosen, wanted, sp.Integer(0))
        return found.chosen.loop
    raise Unsolved("compensators/lead_cannot", best=found.best, omega=found.at, wanted=wanted)


def _attempts(found: exact.LeadDesign, wanted: Expr, extra: Expr, *, chosen: bool) -> Step:
    """The table of attempts."""
    margin = found.before.margins.phase_margin
    claims = {
        f"phase{i}": Claim(total(difference(wanted, margin), each.extra), each.phase, "the phase of the section")
        for i, each in enumerate(found.rounds)
    }
    return Step("attempts", claims=claims, rounds=found.rounds, wanted=wanted, margin=margin, extra=extra,
                chosen=chosen, met=found.met and found.chosen is None)  # fmt: skip


def _section(G: exact.Plant, K: Expr, last: exact.LeadRound, found: exact.LeadDesign, wanted: Expr) -> Step:
    """α and T of the attempt that succeeds."""
    assert last.section is not None and last.omega is not None  # noqa: S101, PT018 - it succeeds
    exactly = exact.alpha_of(last.phase)
    T = 1 / (sp.N(last.omega, 30) * sp.sqrt(sp.N(last.alpha, 30)))
    size = absolute(value_at(written(G, K), G.s, sp.I * last.omega))
    claims = {
        "phase": Claim(
            total(difference(wanted, found.before.margins.phase_margin), last.extra), last.phase, "the phase needed"
        ),
        "alpha": Claim(quotient(*of_sine(last.phase)), exactly, "α"),
        "size": Claim(size, sp.sqrt(last.alpha), "the magnitude there"),
        "T": Claim(quotient(sp.Integer(1), product(last.omega, sp.sqrt(last.alpha))), T, "T"),
    }
    lines = size_and_angle(written(G, K), G.s, sp.I * last.omega, sp.sqrt(last.alpha))
    return Step("section", claims=claims, steps=lines, round=last, several=len(found.rounds) > 1, alpha=last.alpha,
                T=last.section.T)  # fmt: skip


def of_sine(phase: Expr) -> tuple[Any, Any]:
    """State 1 − sin φ and 1 + sin φ."""
    sine = sp.sin(sp.pi * phase / 180)
    sine = sp.N(sine, 30)
    return difference(sp.Integer(1), sine), total(sp.Integer(1), sine)


@lemma("lead_design")
def lead_for_a_crossover(G: exact.Plant, K: Expr | None, options: CompensatorOptions) -> Derivation[exact.Compensated]:
    """The section for a crossover that is given; K None: the gain is free. Raises Unsolved where none does it."""
    omega, wanted = options.crossover, options.phase_margin
    assert omega is not None  # noqa: S101 - the caller has seen to it
    extra = options.extra_phase if options.extra_phase is not None else sp.Integer(0)
    if K is None:
        free = exact.lead_with_free_gain(G, wanted, omega, extra)
        if isinstance(free, exact.NoLead):
            raise no_lead(free.why, omega=omega, needed=free.needed, size=free.size,
                           largest=free.largest, wanted=wanted)  # fmt: skip
        yield _free(G, free, wanted, extra)
        return free.loop
    found = exact.lead_at(G, K, wanted, omega, extra)
    if isinstance(found, exact.NoLead):
        size = sp.N(found.size, 30)
        yield Step("at_the_crossover", claims={"size": _size(G, K, omega, size)}, omega=omega, size=size)
        raise no_lead(found.why, omega=omega, needed=found.needed, size=size,
                       largest=found.largest, wanted=wanted)  # fmt: skip
    yield at_crossover(G, K, found, wanted, extra)
    return found.loop


def _size(G: exact.Plant, K: Any, omega: Expr, size: Expr) -> Claim:
    return Claim(absolute(value_at(written(G, K), G.s, sp.I * omega)), size, "the magnitude there")


def at_crossover(G: exact.Plant, K: Expr, found: exact.LeadAt, wanted: Expr, extra: Expr) -> Step:
    """T and α from the magnitude and the phase at one frequency."""
    phi = sp.pi * found.phase / 180
    cosine, sine = sp.N(sp.cos(phi), 30), sp.N(sp.sin(phi), 30)
    size = 1 / found.M
    needed = difference(difference(wanted, sp.Integer(180)), found.angle)
    claims = {
        "size": _size(G, K, found.omega, size),
        "M": Claim(quotient(sp.Integer(1), size), found.M, "M"),
        "needed": Claim(needed if extra == 0 else total(needed, extra), found.needed, "the phase needed"),
        "zero": Claim(quotient(difference(found.M, cosine), sine), found.zero, "ωT"),
        "pole": Claim(
            quotient(difference(product(found.M, cosine), sp.Integer(1)), product(found.M, sine)), found.pole, "ωαT"
        ),
    }
    principal = found.angle - 360 * sp.ceiling((found.angle - 180) / 360)
    lines = size_and_angle(written(G, K), G.s, sp.I * found.omega, size, sp.N(principal, 30))
    return Step("crossing", claims=claims, steps=lines, found=found, T=found.section.T, alpha=found.section.alpha,
                exactly=sp.Abs(found.phase - found.needed) < sp.Float("1e-9"))  # fmt: skip


def _free(G: exact.Plant, found: exact.FreeLead, wanted: Expr, extra: Expr) -> Step:
    """α from the phase, T from the crossover, K from the magnitude."""
    T = 1 / (found.omega * sp.sqrt(sp.N(found.alpha, 30)))
    size = sp.N(found.size, 30)
    K = sp.sqrt(sp.N(found.alpha, 30)) / size
    needed = total(difference(difference(wanted, sp.Integer(180)), found.angle), extra)
    claims = {
        "needed": Claim(needed, found.phase, "the phase needed"),
        "alpha": Claim(quotient(*of_sine(found.phase)), exact.alpha_of(found.phase), "α"),
        "T": Claim(quotient(sp.Integer(1), product(found.omega, sp.sqrt(found.alpha))), T, "T"),
        "size": _size(G, sp.Integer(1), found.omega, size),
        "K": Claim(quotient(sp.sqrt(found.alpha), size), K, "K"),
    }
    return Step("free_gain", claims=claims, found=found, T=found.section.T, alpha=found.alpha, K=found.loop.K,
                extra=extra)  # fmt: skip
