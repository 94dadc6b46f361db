"""Is a given x(t), y(t) the response of a system? By its differential equation and by the formula of convolution.

Steps and impulses cut the time into intervals; on each the input and a closed form are smooth, so that derivatives and
quadrature are sound there. What the impulses do at a cut follows from the formula, which runs across all cuts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from solver.conditions import conditions_of
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.expressions import evaluate, value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.stated import Stated
from solver.stated.algebra import exponential, product, total
from solver.stated.calculus import integral

JUMPS = (sp.Heaviside, sp.DiracDelta)
TRIED = 20


@dataclass(frozen=True)
class Interval:
    """A stretch of time without jumps, beginning at `start`; `end` is None for the last one."""

    start: Any
    end: Any
    cuts: tuple[Any, ...]

    def smooth(self, expression: Any, t: Any) -> Any:
        """Return the expression as it is inside the interval: steps are 0 or 1, impulses are 0."""
        jumps = {each for each in expression.atoms(*JUMPS) if each.has(t)}
        return expression.xreplace({jump: self._value(jump, t) for jump in jumps})

    def _value(self, jump: Any, t: Any) -> Any:
        if isinstance(jump, sp.DiracDelta):
            return sp.S.Zero
        slope, at = _jump(jump, t)
        begun = _position(at, self.cuts) <= _position(self.start, self.cuts)
        return sp.S.One if begun == bool(slope.is_positive) else sp.S.Zero

    def times(self, t: Any, scale: Any) -> list[Any]:
        """Return times inside the interval; the last interval takes the random t, measured from its start."""
        if self.end is None:
            return [self.start + scale * t]
        return [self.start + (self.end - self.start) * sp.Rational(part, 7) for part in (2, 6)]


def delayed(u: Any, t: Any, delay: Any) -> Any:
    """Return u(t − T), which is zero before t = T."""
    terms = [] if delay == 0 else sp.Add.make_args(sp.expand(u))
    late = [
        term.xreplace({t: t - delay}) * (1 if term.has(sp.DiracDelta) else sp.Heaviside(t - delay)) for term in terms
    ]
    return sp.Add(*late) if late else u


def intervals(t: Any, *formulas: Any) -> list[Interval]:
    """Return the stretches of t ≥ 0 on which the formulas have no jump. Raises NotEvaluable if their order is open."""
    found = {_jump(jump, t)[1] for formula in formulas for jump in formula.atoms(*JUMPS) if jump.has(t)}
    later: list[Any] = []
    for at in found:
        if _is_positive(at):
            later = _inserted(later, at)
        elif not (at.is_nonpositive or _is_positive(-at)):
            raise NotEvaluable("when a step or impulse comes depends on a parameter")
    cuts = (sp.S.Zero, *later)
    return [Interval(start, end, cuts) for start, end in zip(cuts, (*later, None), strict=True)]


def _inserted(times: list[Any], at: Any) -> list[Any]:
    for i, each in enumerate(times):
        if _is_positive(each - at):
            return [*times[:i], at, *times[i:]]
        if not _is_positive(at - each):
            raise NotEvaluable("the order of two jumps depends on a parameter")
    return [*times, at]


def _is_positive(x: Any) -> bool:
    """Whether a time is positive: as its symbols are assumed, or at all points where their conditions hold."""
    if x.is_positive or not conditions_of(x.free_symbols):
        return bool(x.is_positive)
    return all(complex(evaluate(x, point)).real > 0 for point in admissible(x.free_symbols, TRIED))


def _position(at: Any, cuts: Sequence[Any]) -> int:
    return cuts.index(at) if at in cuts else 0


def _jump(jump: Any, t: Any) -> tuple[Any, Any]:
    """Return the slope of the argument and the time at which it is zero."""
    argument = sp.expand(jump.args[0])
    slope = argument.coeff(t, 1)
    if slope.has(t) or slope == 0 or argument.coeff(t, 0).has(t) or slope.is_positive is None:
        raise NotEvaluable("the time of a step or impulse is not known")
    return slope, -argument.coeff(t, 0) / slope


def impulses(inputs: Any, t: Any) -> list[tuple[Any, Any]]:
    """Return (time, weights) of the impulses in a column of expressions."""
    found: dict[Any, Any] = {}
    for jump in {each for each in inputs.atoms(sp.DiracDelta) if each.has(t)}:
        slope, at = _jump(jump, t)
        mark = sp.Dummy()
        weights = inputs.xreplace({jump: mark}).applyfunc(lambda entry, mark=mark: sp.expand(entry).coeff(mark, 1))
        weights = _just_before(weights, t, at) / sp.Abs(slope)
        found[at] = found.get(at, sp.zeros(*inputs.shape)) + weights
    return [(at, sp.ImmutableMatrix(weights)) for at, weights in found.items()]


def _just_before(weights: Any, t: Any, at: Any) -> Any:
    """Return the factor of an impulse at its time; steps in it are taken as they are there."""
    steps = {each for each in weights.atoms(sp.Heaviside) if each.has(t)}
    here = {each: sp.Integer(int(bool(each.args[0].subs(t, at).is_nonnegative))) for each in steps}
    return weights.xreplace(here).subs(t, at)


def convolution_formula(
    A: Any, B: Any, x0: Any, inputs: Any, t: Any, interval: Interval, before: Sequence[Interval]
) -> Stated:
    """Return x(t) = e^{At} x0 + Σ e^{A(t − T)} B c + ∫ e^{A(t − τ)} B u(τ) dτ in an interval, as a stated formula."""
    tau = sp.Dummy("tau")
    terms: list[Any] = [product(exponential(product(t, A)), x0)]
    if B is not None and inputs is not None:
        for at, weights in impulses(inputs, t):
            if _position(at, interval.cuts) <= _position(interval.start, interval.cuts):
                terms.append(product(exponential(product(t - at, A)), B, weights))
        for each in (*before, interval):
            u = each.smooth(inputs, t).xreplace({t: tau})
            if any(u):
                end = t if each is interval else each.end
                integrand = product(exponential(product(t - tau, A)), B, u)
                terms.append(integral(integrand, tau, each.start, end))
    return total(*terms)


def time_scale(A: Any) -> Any:
    """Return a factor for random times that suits the fastest mode of A; 1 where A has parameters."""
    if free_symbols(A):
        return sp.S.One
    fastest = float(np.max(np.abs(np.linalg.eigvals(value_of(A, Environment.at([{}])).value[0])), initial=0.0))
    return sp.Rational(round(64 * 3 / fastest) or 1, 64) if fastest > 3 else sp.S.One


def samples(A: Any, B: Any, x0: Any, inputs: Any, k: Any, count: int) -> Iterator[tuple[int, Any, Any]]:
    """Yield (k, x(k), u(k)) for k = 0, 1, … by the recursion x(k + 1) = A x(k) + B u(k), as stated formulas."""
    x = x0
    for step in range(count):
        u = sampled(inputs, k).xreplace({k: sp.Integer(step)}) if inputs is not None else None
        yield step, x, u
        x = total(product(A, x), product(B, u)) if u is not None else product(A, x)


def sampled(expression: Any, k: Any) -> Any:
    """Return an expression in k with steps that are one at their start, and impulses as unit pulses."""
    jumps = {each for each in expression.atoms(*JUMPS) if each.has(k)}
    return expression.xreplace(
        {
            jump: sp.Piecewise((1, sp.Ge(jump.args[0], 0)), (0, True))
            if isinstance(jump, sp.Heaviside)
            else sp.KroneckerDelta(jump.args[0], 0)
            for jump in jumps
        }
    )


def beginnings(inputs: Any, k: Any) -> list[Any]:
    """Return the samples, numbers all, at which steps and impulses begin."""
    if inputs is None:
        return []
    jumps = {each for each in inputs.atoms(*JUMPS) if each.has(k)}
    found = [_jump(jump, k)[1] for jump in jumps]
    return [sp.ceiling(at) for at in found if at.is_number and at.is_positive]


def residual_of_pairs(pairs: Sequence[tuple[Any, Any]]) -> float:
    """Return the largest residual of several equalities, parameters at random values."""
    points = admissible(free_symbols([side for pair in pairs for side in pair]), 2)
    return worst_of(equality_residual(left, right, [dict(point) for point in points]) for left, right in pairs)
