"""What a stable gain costs that is not the optimal one."""

from __future__ import annotations

from typing import Any

from solver.lazy import sympy as sp
from solver.numeric.judges import optimal as judges
from solver.tasks.told import short, spectrum
from solver.words import Reason

NOTABLE = 1e-3
"""The part of the least cost by which another one must be larger to be told."""


def dearer(weights: judges.Weights, K: Any, x0: Any, factor: Any) -> Reason | None:
    """Return the poles and the cost of a gain beside the least, from x(0) or from the unit vector that shows most.

    Another factor before the cost than ½ is told: the student may have taken it where the question names none.
    """
    found = judges.costs(weights, K)
    if found is None or (x0 is not None and x0.free_symbols):
        return None
    own, least = found
    n = len(own)
    starts = [x0] if x0 is not None else [sp.ImmutableMatrix(sp.eye(n)[:, i]) for i in range(n)]
    costs = [tuple(float((start.T * sp.Matrix(X) * start)[0, 0]) for X in (own, least)) for start in starts]
    (cost, best), start = max(zip(costs, starts, strict=True), key=lambda each: each[0][0] - each[0][1])
    if cost - best <= NOTABLE * abs(best):
        return None
    found_poles = spectrum(weights.A - weights.B * K)
    told = {"cost": short(sp.Float(cost) * factor), "least": short(sp.Float(best) * factor)}
    told["factor"] = None if factor == sp.Rational(1, 2) else factor
    return Reason("meanings/dearer", {"found": found_poles, "start": sp.ImmutableMatrix(start), **told})
