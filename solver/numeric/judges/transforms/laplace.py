"""The Laplace transform of a function with steps and impulses by its defining integral, as a stated formula.

ℒ{f}(s) = ∫ f(t) e^{−st} dt from 0−: an integral for each interval without jumps, and the impulses for themselves.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.time_response.response import Interval, impulses, intervals
from solver.stated import Stated
from solver.stated.algebra import product, total
from solver.stated.calculus import integral
from solver.stated.transforms import laplace


def transform_of(f: Any, t: Any, s: Any) -> Stated:
    """Return ℒ{f}(s) as a stated formula. Raises NotEvaluable where jumps can't be put in order."""
    higher, rest = derivatives_of_impulses(f, t)
    terms: list[Any] = [weight * s**order * sp.exp(-s * at) for at, order, weight in higher]
    terms += [weights[0] * sp.exp(-s * at) for at, weights in impulses(sp.ImmutableMatrix([rest]), t)]
    for span in intervals(t, rest):
        terms += _of_span(span, span.smooth(rest, t), t, s)
    return total(*terms) if terms else total(sp.S.Zero)


def _of_span(span: Interval, f: Any, t: Any, s: Any) -> list[Any]:
    """∫ f(t) e^{−st} dt over an interval; the last one goes on for ever."""
    if f == 0:
        return []
    if span.end is not None:
        return [integral(f * sp.exp(-s * t), t, span.start, span.end)]
    if span.start == 0:
        return [laplace(f, t, s)]
    return [product(sp.exp(-s * span.start), laplace(f.xreplace({t: t + span.start}), t, s))]


def derivatives_of_impulses(f: Any, t: Any) -> tuple[list[tuple[Any, int, Any]], Any]:
    """Return (time, order, weight) of the derivatives of impulses in f, and f without them.

    Raises NotEvaluable where one has a factor that changes with time.
    """
    found = []
    marked = sp.expand(f) if any(len(each.args) > 1 for each in f.atoms(sp.DiracDelta)) else f
    for each in {each for each in marked.atoms(sp.DiracDelta) if len(each.args) > 1}:
        argument, order = each.args[0], int(each.args[1])
        mark = sp.Dummy()
        weight = marked.xreplace({each: mark}).coeff(mark, 1)
        slope = sp.expand(argument).coeff(t, 1)
        if slope == 0 or weight.has(t) or sp.expand(argument - slope * t).has(t):
            raise NotEvaluable("a derivative of an impulse has a factor that changes with time")
        at = -sp.expand(argument).coeff(t, 0) / slope
        found.append((at, order, weight / (sp.Abs(slope) * slope**order)))
        marked = marked.xreplace({each: sp.S.Zero})
    return found, marked
