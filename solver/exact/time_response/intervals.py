"""Functions with delayed steps, written interval by interval."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.time_response.signals import in_order


def by_intervals(y: sp.Expr, begins: Iterable[sp.Expr], t: sp.Symbol, *, discrete: bool) -> sp.Piecewise | None:
    """y for 0 ≤ t < T₁ (k < k₁), T₁ ≤ t < T₂, …; None where nothing begins later, or in an unknown order."""
    times = in_order(dict.fromkeys([sp.S.Zero, *begins]))
    if times is None or len(times) == 1 or y.has(sp.KroneckerDelta):
        return None
    spans = []
    for start, end in zip(times, [*times[1:], None], strict=True):
        steps = {each: sp.Integer(int(_begun(each, start, t))) for each in y.atoms(sp.Heaviside)}
        here = y.xreplace(steps)
        bounds: list[Any] = [] if start == 0 and discrete else [sp.GreaterThan(t, start, evaluate=False)]
        bounds += [] if end is None else [sp.StrictLessThan(t, end, evaluate=False)]
        spans.append((here, sp.And(*bounds)))
    return sp.Piecewise(*spans, evaluate=False)


def _begun(step: sp.Heaviside, start: sp.Expr, t: sp.Symbol) -> bool:
    """Whether a step has begun at a time at which something begins."""
    return possible_signs(sp.expand(start - (t - step.args[0]))) <= {0, 1}
