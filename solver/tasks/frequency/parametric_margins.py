"""Margins of a loop with parameters: crossovers that have a formula, and the condition under which it is stable."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import total
from solver.tasks.frequency.parametric_crossovers import (
    gain_crossovers_with_letters,
    gain_margin_with_letters,
    left_open,
    loop_factors,
    phase_margin_with_letters,
    real_axis_with_letters,
)
from solver.tasks.stability.parameter_region import parameter_region
from solver.tasks.stability.routh_array import rows_of

if TYPE_CHECKING:
    from solver.systems import OpenLoop


def margins_with_letters(loop: OpenLoop) -> Derivation[Answers]:
    """What the equations in ω² give of the margins, and where the closed loop is stable."""
    answers = Answers()
    L = exact.parametric_axis(loop_factors(loop))
    answers |= yield from _at_gain_crossover(loop, L)
    answers |= yield from _at_phase_crossover(L)
    condition = yield from _stable_where(loop)
    if condition in (sp.true, sp.false):
        answers["stable"] = bool(condition)
    return Answers(**answers, condition=condition)


def _at_gain_crossover(loop: OpenLoop, L: exact.ParametricAxis) -> Derivation[dict[str, Any]]:
    """The gain crossover and the phase margin; nothing where a formula or a sign is missing."""
    try:
        found = exact.parametric_gain_crossovers(L)
    except exact.NotExact as missing:
        yield from left_open("gain_crossover", **_why(missing))
        return {}
    yield from gain_crossovers_with_letters(L, found)
    if not found:
        return {"gain_crossover": sp.oo, "phase_margin": sp.oo}
    if len(found) > 1:
        yield from left_open("several_gains", **_why(None))
        return {}
    try:
        margin = yield from phase_margin_with_letters(loop_factors(loop), found[0][0])
    except exact.NotExact as missing:
        yield from left_open("phase_margin", **_why(missing))
        return {"gain_crossover": found[0][0]}
    return {"gain_crossover": found[0][0], "phase_margin": margin}


def _at_phase_crossover(L: exact.ParametricAxis) -> Derivation[dict[str, Any]]:
    """The phase crossover and the gain margin; nothing where a formula or a sign is missing."""
    try:
        crossings = exact.parametric_real_axis(L)
        negative = [each for each in crossings if exact.decided_sign(each.value) < 0]
    except exact.NotExact as missing:
        yield from left_open("phase_crossover", **_why(missing))
        return {}
    yield from real_axis_with_letters(L, crossings, every=False)
    if len(negative) > 1:
        yield from left_open("several_phases", **_why(None))
        return {}
    at = negative[0] if negative else None
    ratio, decibels = yield from gain_margin_with_letters(at)
    return {"phase_crossover": sp.oo if at is None else at.omega, "gain_margin": ratio, "gain_margin_db": decibels}


def _why(missing: Any) -> dict[str, Any]:
    """The reason that the algebra gave, as values of a step."""
    values = missing.reason.values if missing is not None else {}
    why = missing.reason.kind.split("/")[-1] if missing is not None else ""
    return {"why": why, "p": values.get("p"), "n": values.get("n"), "sign": values.get("what")}


@lemma("parametric_crossovers")
def _stable_where(loop: OpenLoop) -> Derivation[Any]:
    """Routh's criterion for D + N, solved for the gain."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    p = sp.Poly(D + N, s).as_expr()
    if p == 0:
        raise Unsolved("conversions/ill_posed_loop")
    yield Step("characteristic", claims={"p": Claim(total(D, N), p, "characteristic polynomial")}, s=s, p=p)
    listed = sp.Poly(p, s).all_coeffs()
    if exact.decided_sign(sp.factor(listed[0])) < 0:
        listed = [sp.expand(-each) for each in listed]
    array = yield from rows_of(exact.routh(listed), s)
    conditions = [row.computed[0] for row in array.rows]
    special = any(row.special for row in array.rows)
    gain: list[Any] = sorted(set(N.free_symbols) - set(D.free_symbols), key=str)
    condition = sp.false if special else exact.all_positive(conditions, gain[:1])
    yield Step(
        "condition",
        unclaimed="the answer, which has a check of its own",
        condition=condition,
        truth="always" if condition is sp.true else "never" if condition is sp.false else "",
        conditions=[each for each in conditions if exact.sign_of(each) != 1],
        special=special,
        figures=() if special else parameter_region(conditions, [], condition),
    )
    return condition


__all__ = ["margins_with_letters"]
