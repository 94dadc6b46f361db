"""Loops with parameters on the imaginary axis, judged by numbers at some values of the parameters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import mpmath
import sympy as sp

from solver.derivation import Check, Claim
from solver.numeric.judges import frequency as judges
from solver.stated.algebra import quotient

NEAR = 1e-12
BESIDE = sp.Rational(1, 1000)
ORACLE = "numpy.roots, refined"


def of_parametric_axis(found: Any, L: Any) -> Iterator[Claim]:
    """N/D is the product of the factors."""
    factors = ((sp.Add(*(c * L.s**i for i, c in enumerate(reversed(f)))), m) for f, m in L.factors)
    yield Claim(quotient(found.N.as_expr(), found.D.as_expr()), L.number * sp.Mul(*(f**m for f, m in factors)))


def of_parametric_real_axis(found: Any, L: Any) -> Iterator[Check]:
    """These are all crossings of the real axis with the values there; negative ones have their direction."""
    for values, loop in _at_values(L.N.as_expr(), L.D.as_expr(), L.N.gen):
        inner = [each for each in found if not each.start]
        wanted = sorted(loop.real_crossings())
        own = sorted((_number(each.omega, values), _number(each.value, values)) for each in inner)
        for i, label in ((0, "all crossings of the real axis"), (1, "the values there")):
            residual = judges.list_residual([pair[i] for pair in wanted], [pair[i] for pair in own])
            yield Check.within(label, ORACLE, residual, NEAR)
        turns = all(each.turn == judges.direction(loop, _number(each.omega, values)) for each in found
                    if _number(each.value, values) < 0)  # fmt: skip
        yield Check.that("their directions", "mpmath, beside them", turns)
        starts = [_number(each.value, values) for each in found if each.start]
        begins = mpmath.isfinite(loop.at_rest) and loop.at_rest < 0
        yield Check.that("the beginning of the curve", "mpmath", bool(starts) == begins)


def of_parametric_gain_crossovers(found: Any, L: Any) -> Iterator[Check]:
    """These are all frequencies with |L| = 1."""
    for values, loop in _at_values(L.N.as_expr(), L.D.as_expr(), L.N.gen):
        own = sorted(_number(omega, values) for omega, _ in found)
        residual = judges.list_residual(sorted(loop.gain_crossovers(judges.decimal(sp.S.One))), own)
        yield Check.within("all gain crossovers", ORACLE, residual, NEAR)


def of_parametric_turns(found: Any, numerator: Any, denominator: Any, s: Any) -> Iterator[Check]:
    """One case holds at most, and it counts the poles that there are."""
    for values, loop in _at_values(numerator, denominator, s):
        N, D = numerator.xreplace(values), denominator.xreplace(values)
        Z, on = judges.closed_loop_poles(N, D, s, sp.S.Zero)
        holding = [each for each in found.cases if each.condition in (True, sp.true)
                   or each.condition.xreplace(values) == sp.true]  # fmt: skip
        yield Check.that("one case holds", "compared", len(holding) == 1)
        yield Check.that("poles of the loop", "mpmath.polyroots", all(each.closed_loop == Z for each in holding))
        yield Check.that("poles on the axis", "mpmath.polyroots", on == found.on_axis)
        P, _ = judges.roots_outside(sp.Poly(D, s).all_coeffs(), discrete=False)
        yield Check.that("poles of L", "mpmath.polyroots", found.open_loop == P)
        turns = judges.turns_about(loop)
        yield Check.that("turns", "numpy, samples of the contour", all(each.clockwise == turns for each in holding))


def of_margin_in_turn(found: Any, L: Any, omega: Any) -> Iterator[Check]:
    """180° + ∠L, in (−180, 180]."""
    above = L.number * sp.Mul(*(sp.Poly(list(f), L.s).as_expr() ** m for f, m in L.factors))
    N, D = sp.fraction(sp.together(above))
    for values, loop in _at_values(N, D, L.s, omega):
        margin = found.xreplace(values)
        fits = judges.has_phase(loop, omega.xreplace(values), margin - 180)
        yield Check.that("the phase there", "mpmath", fits and -180 < judges.decimal(margin) <= 180)


def of_late_gains(found: Any, numerator: Any, denominator: Any, s: Any, delay: Any) -> Iterator[Check]:
    """On both sides of each critical gain the loop has the poles that are counted, and is stable as is said."""
    K, before = found.gain, found.small
    for each in found.critical:
        for poles, side in ((before, 1 - BESIDE), (before + each.poles, 1 + BESIDE)):
            at = sp.Rational(str(sp.N(each.gain * side, 20)))
            Z, _ = judges.closed_loop_poles(numerator.xreplace({K: at}), denominator, s, delay)
            yield Check.that("poles of the loop", "numpy, the argument principle on a contour", poles == Z)
            holds = found.condition.xreplace({K: at}) == sp.true
            yield Check.that("one case holds", "compared", holds == (not Z))
        before += each.poles


def _at_values(N: Any, D: Any, s: Any, *further: Any) -> Iterator[tuple[dict[Any, Any], judges.NumericLoop]]:
    for values in judges.values_of_parameters([N, D, *further], [s]):
        yield values, judges.numeric_loop(N.xreplace(values), D.xreplace(values), s, sp.S.Zero)


def _number(value: Any, values: dict[Any, Any]) -> Any:
    return judges.decimal((sp.S.Zero + value).xreplace(values))
