"""Lemmas: the compensator that was found, and whether the loop with it does what is asked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.frequencies import size_and_angle
from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient
from solver.tasks.compensators.closed_loop import loop_closed_by
from solver.tasks.compensators.locus import upper
from solver.tasks.compensators.specifications import CompensatorOptions, accuracy, crossover_claims, written
from solver.tasks.figures import plane, roots
from solver.tasks.frequency.figures import bode_figure

if TYPE_CHECKING:
    from sympy import Expr, Symbol

NEAR = 1e-9
"""What decimals leave of the difference of conjugate roots."""


@lemma("compensator")
def checked(
    G: exact.Plant, loop: exact.Compensated, before: exact.Compensated | None, options: CompensatorOptions
) -> Derivation[Answers]:
    """C as it is, the margins of C G, the error, the closed loop."""
    s, K = G.s, loop.K
    top, bottom = exact.compensator_parts(K, loop.sections, s)
    C = top / bottom
    factors = [quotient(each.T * s + 1, each.alpha * each.T * s + 1) for each in loop.sections]
    yield Step("controller", claims={"C": Claim(product(K, *factors), C, "the compensator")}, s=s, K=K,
               sections=loop.sections)  # fmt: skip
    error = error_of(G, loop, options)
    yield _check(G, loop, before, options, error)
    if not loop.stable:
        raise Unsolved("compensators/not_stable")
    if before is not None and not _is_met(loop, options):
        raise Unsolved("compensators/not_met", omega=loop.margins.gain_crossover, margin=loop.margins.phase_margin)
    if G.delay == 0:
        other = (sp.expand(before.K * G.numerator), G.denominator) if before is not None and before.stable else None
        compared = "After a step of the reference, with the compensator and with its gain alone"
        caption = "After a step of the reference" if other is None else compared
        yield from loop_closed_by((top, bottom), (G.numerator, G.denominator), s, caption, other)
    answers = Answers(
        controller=C,
        K=K,
        T=of_sections([each.T for each in loop.sections]),
        alpha=of_sections([each.alpha for each in loop.sections]),
        phase_margin=loop.margins.phase_margin,
        gain_crossover=loop.margins.gain_crossover,
    )
    if error is not None:
        answers["error"] = error
    return answers


def _is_met(loop: exact.Compensated, options: CompensatorOptions) -> bool:
    """Whether margin and crossover are those asked for: of several crossovers another one may decide."""
    found, crossover = loop.margins, options.crossover
    near = crossover is None or abs(found.gain_crossover / crossover - 1) <= sp.Rational(1, 1000)
    return bool(found.phase_margin >= options.phase_margin and near)


def of_sections(values: Sequence[Any]) -> Any:
    """Return the value of the one section, the list of those of several."""
    return values[0] if len(values) == 1 else list(values)


def error_of(G: exact.Plant, loop: exact.Compensated, options: CompensatorOptions) -> Expr | None:
    """Return the error after a unit step, where something is asked of it."""
    if options.error is None:
        return None
    c, nu = G.axis.start
    return sp.Integer(0) if nu < 0 else 1 / (1 + loop.K * c)


def _check(
    G: exact.Plant,
    loop: exact.Compensated,
    before: exact.Compensated | None,
    options: CompensatorOptions,
    error: Expr | None,
) -> Step:
    """The crossover and the margin of C G, and a table of what is asked and reached."""
    found, crossover = loop.margins, loop.margins.at_gain
    top, bottom = exact.compensator_parts(loop.K, loop.sections, G.s)
    C = top / bottom
    claims = {} if crossover is None else crossover_claims(C * written(G), G.s, crossover.omega, crossover.phase)
    loops = [("CG", loop.axis), *([("KG", before.axis)] if before is not None else [])]
    pictures: tuple[Any, ...] = bode_figure(
        "The loop with the compensator and with its gain alone", *loops, margins=found
    )
    if before is None:
        roots_found = exact.closed_by((top, bottom), (G.numerator, G.denominator), G.s).poles
        caption = "The poles of the closed loop, and those asked for"
        pictures = plane(caption, roots("poles", roots_found), roots("asked for", options.poles, "square"))
    return Step(
        "check",
        claims=claims,
        unclaimed="" if claims else "there is no crossover",
        steps=() if crossover is None else _at_the_crossover(C * written(G), G.s, crossover),
        crossover=crossover,
        phase=found.phase_margin - 180,
        margin=found.phase_margin,
        asked=_asked(options) if before is not None else {},
        asked_error=options.error,
        pair=_pair(G, loop, options) if before is None else None,
        constant=constant_of(G, loop, options),
        error=error,
        stable=loop.stable,
        s=G.s,
        figures=pictures,
    )


@where_exact
def _at_the_crossover(L: Expr, s: Symbol, crossover: exact.Crossover) -> tuple[Step, ...]:
    """Size and angle at the crossover, factor by factor."""
    return size_and_angle(L, s, sp.I * crossover.omega, sp.S.One, crossover.phase)


def _pair(G: exact.Plant, loop: exact.Compensated, options: CompensatorOptions) -> dict[str, Any]:
    """The pole asked for, the pole of the loop next to it, and the others but for its conjugate."""
    C = exact.compensator_parts(loop.K, loop.sections, G.s)
    poles = exact.closed_by(C, (G.numerator, G.denominator), G.s).poles
    wanted = upper(options.poles)
    near = min(poles, key=lambda pole: abs(complex(pole) - complex(wanted)))
    others = [p for p in poles if p != near and abs(complex(p) - complex(near).conjugate()) > NEAR]
    dominant = all(complex(p).real < 5 * complex(near).real for p in others)
    return {"wanted": wanted, "found": sp.N(near, 30), "others": others, "dominant": dominant}


def _asked(options: CompensatorOptions) -> dict[str, Any]:
    """What is asked, by name."""
    names = ("phase_margin", "crossover")
    return {name: value for name in names if (value := getattr(options, name)) is not None}


def constant_of(G: exact.Plant, loop: exact.Compensated, options: CompensatorOptions) -> tuple[str, Any, Any] | None:
    """The error constant asked for, and that of C G."""
    asked = accuracy(options)
    if asked is None or asked[0] == "error":
        return None
    name, value = asked
    limit = exact.least_gain(G, name, value).limit
    return name, value, loop.K * limit
