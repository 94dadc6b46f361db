"""The inverse transform of a sum of rational functions times dead times, by contour integrals, as stated formulas."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.time_response.response import intervals
from solver.numeric.judges.transforms.laplace import derivatives_of_impulses
from solver.stated import Stated
from solver.stated.algebra import total
from solver.stated.calculus import value_at
from solver.stated.transforms import inverse_laplace

Term = tuple[Any, Any]
"""A dead time T ≥ 0 and the rational function that e^{−Ts} is multiplied by."""


def terms_of(F: Any, s: Any) -> list[Term]:
    """Return the dead times of F with their factors, the polynomials in e^{−Ts} multiplied out."""
    delays = {each: -sp.expand(each.args[0]).coeff(s, 1) for each in F.atoms(sp.exp) if each.has(s)}
    found: dict[Any, Any] = {}
    marks = {each: sp.Dummy(positive=True) for each in delays}
    above, below = sp.fraction(sp.together(F.xreplace(marks)))
    for term in sp.Add.make_args(sp.expand(above)):
        late, factor = sp.S.Zero, term
        for each, mark in marks.items():
            power = sp.degree(term, mark) if term.has(mark) else 0
            offset = sp.expand(each.args[0]).coeff(s, 0)
            late += power * delays[each]
            factor = factor.subs(mark, 1) * sp.exp(power * offset)
        found[late] = found.get(late, sp.S.Zero) + factor / below
    if below.has(*marks.values()) if marks else False:
        raise NotEvaluable("a dead time stands in a denominator")
    return list(found.items())


def values_in_time(F: Any, s: Any, f: Any, t: Any) -> Iterator[tuple[Any, Stated]]:
    """Yield f at times between its jumps and what contour integrals of F give there, both as stated formulas."""
    _, rest = derivatives_of_impulses(f, t)
    terms = terms_of(F, s)
    edges = sp.Add(*(sp.Heaviside(t - late) for late, _ in terms if late != 0))
    spans = intervals(t, rest, edges)
    starts = [each.start for each in spans]
    for number, span in enumerate(spans):
        begun = [(late, G) for late, G in terms if late in starts[: number + 1]]
        here = span.smooth(rest, t)
        for time in span.times(t, sp.S.One)[-1:]:
            wanted: list[Any] = [inverse_laplace(G, s, time - late) for late, G in begun] or [sp.S.Zero]
            yield value_at(here, t, time), total(*wanted)
