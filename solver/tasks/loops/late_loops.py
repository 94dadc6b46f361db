"""Loops with a dead time: how they are written, and whether they are stable, by Nyquist's count."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, Unsolved, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.stated.algebra import product
from solver.stated.calculus import value_at
from solver.tasks.frequency.closed_loop import is_stable
from solver.tasks.frequency.crossovers import negative_axis_of, on_axis_of
from solver.tasks.loops.loop_stability import Inside

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop


@lemma("late_loops")
def stable_late_loop(loop: OpenLoop) -> Derivation[Inside]:
    """All roots of D + N e^{−Ts} are on the left, nothing cancelled; raises Unsolved where not all are."""
    s, N, D = loop.variable, loop.numerator, loop.denominator
    yield Step("characteristic", unclaimed="an equation for the poles", s=s, p=D + N * loop.factor)
    if loop.around:
        return (yield from _for_gains(loop))
    L = exact.on_axis(N, D, s, loop.delay)
    yield from on_axis_of(L)
    yield from negative_axis_of(L)
    if not (yield from is_stable(loop)):
        found = exact.encirclements(N, D, s, loop.delay)
        raise Unsolved("loops/unstable_late", outside=None if found.through else found.closed_loop, on=found.on_axis)
    return Inside(sp.S.One, ())


@lemma("late_loops")
def _for_gains(loop: OpenLoop) -> Derivation[Inside]:
    """The gains for which the loop is stable; raises Unsolved where there are none."""
    found = exact.late_gains(loop.numerator, loop.denominator, loop.variable, loop.delay)
    formula = loop.numerator / found.gain / loop.denominator * loop.factor
    claims = {
        f"value{i}": Claim(value_at(formula, loop.variable, sp.I * each.omega), each.value, "a value on the real axis")
        for i, each in enumerate(found.critical, 1)
        if each.omega != 0
    }
    if found.condition is sp.false:
        raise Unsolved("loops/unstable_late", outside=None, on=0)
    yield Step("for_gains", claims=claims, unclaimed="" if claims else "it begins there", found=found, L=formula,
               s=loop.variable)  # fmt: skip
    return Inside(sp.S.One, ())


def is_stable_at(loop: OpenLoop, point: Mapping[Any, complex]) -> bool:
    """Whether the loop is stable at values of its parameters, for the judges; without parameters it is known to be."""
    if not loop.around:
        return True
    known = {symbol: sp.Rational(repr(complex(value).real)) for symbol, value in point.items()}
    N, D, delay = (each.xreplace(known) for each in (loop.numerator, loop.denominator, loop.delay))
    return judges.closed_loop_poles(N, D, loop.variable, delay) == (0, 0)


def with_dead_time(loop: OpenLoop, formula: Any) -> Any:
    """A formula of L₀ as one of L, as it is written."""
    return product(formula, loop.factor) if loop.delay != 0 else formula


def rational_of(loop: OpenLoop, F: Expr) -> Expr:
    """A quotient of quotients as one in lowest terms, in s, and in e^{−Ts} with a dead time."""
    found: Expr = exact.rational(F) if loop.delay == 0 else exact.late_quotient(F, loop.variable, loop.delay)
    return found


def fraction_of(loop: OpenLoop, F: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator; e^{−Ts} is no denominator."""
    q = sp.Dummy("q")
    above, below = sp.fraction(F.xreplace({loop.factor: q}) if loop.delay != 0 else F)
    return above.xreplace({q: loop.factor}), below.xreplace({q: loop.factor})


def image_of(loop: OpenLoop, transfer: Expr, R: Expr) -> Expr:
    """What a transfer function makes of a transform, in lowest terms."""
    if loop.delay == 0:
        return exact.error_transform(transfer, R)
    found: Expr = exact.late_transform(transfer, R, loop.variable, loop.delay)
    return found


def long_run_of(loop: OpenLoop, E: Expr, inside: Inside) -> exact.LongRun:
    """What E says of the limit of e."""
    if loop.delay != 0:
        return exact.late_long_run(E, loop.variable, loop.delay, inside.polynomial)
    return exact.long_run(E, loop.variable, inside.polynomial, inside.positive, discrete=loop.discrete)


__all__ = [
    "fraction_of",
    "image_of",
    "is_stable_at",
    "long_run_of",
    "rational_of",
    "stable_late_loop",
    "with_dead_time",
]
