"""Matched poles and zeros by numerical roots."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.judges.digital.sampled import MANY, numbers_of

SAME = "1e-15"
"""A root that is so small beside the others is at zero."""


def matched_residual(G: Any, s: Any, T: Any, answer: Any, z: Any) -> float:
    """Return the largest relative difference of an answer and the matched equivalent of G at random z."""
    worst, context = 0.0, MANY.context
    above, below = (sp.Poly(side, s) for side in sp.fraction(sp.together(G)))
    for point in admissible((free_symbols(G) | free_symbols(T) | free_symbols(answer)) - {s, z}, 2):
        zeros, poles = ([*numbers_of([p.all_coeffs()], point)[0]] for p in (above, below))
        period = numbers_of([[T]], point)[0][0]
        for at in (context.mpc("0.3", "0.71"), context.mpc("-1.7", "0.4")):
            found = numbers_of([[answer]], {**point, z: at})[0][0]
            wanted = _matched(zeros, poles, period, at)
            worst = worst_of((worst, float(abs(found - wanted) / max(abs(found), abs(wanted), context.mpf("1e-30")))))
    return with_many_digits(worst, G, answer)


def _matched(N: list[Any], D: list[Any], T: Any, z: Any) -> Any:
    """The value at z: roots to e^{sT}, one zero at infinity stays, the gain by the lowest coefficients."""
    context = MANY.context
    (zeros, c), (poles, d) = (_roots(p) for p in (N, D))
    at_minus_one = max(len(D) - len(N) - 1, 0)
    value = (z + 1) ** at_minus_one
    unscaled = context.mpf(2) ** at_minus_one
    for roots, sign in ((zeros, 1), (poles, -1)):
        for root in roots:
            image = context.exp(root * T)
            value *= (z - image) ** sign
            unscaled *= ((1 - image) if root != 0 else 1 / (1 / T)) ** sign
    return value * (c / d) / unscaled


def _roots(p: list[Any]) -> tuple[list[Any], Any]:
    """The roots, those at zero exactly, and the lowest coefficient that is not zero."""
    low = len(p) - 1
    while abs(p[low]) == 0:
        low -= 1
    kept = p[: low + 1]
    found = MANY.context.polyroots(kept, maxsteps=500, extraprec=400) if low else []
    return [*found, *[MANY.context.mpf(0)] * (len(p) - 1 - low)], p[low]


def mapped_residual(poles: Any, T: Any, answer: Any) -> float:
    """Return the largest relative difference of an answer's poles, in any order, and e^{sT} of some poles."""
    if len(poles) != len(answer):
        return float("inf")
    worst = 0.0
    symbols = {x for each in (*poles, T, *answer) for x in free_symbols(each)}
    for point in admissible(symbols, 2):
        values = numbers_of([[T, *poles]], point)[0]
        wanted = [MANY.context.exp(s * values[0]) for s in values[1:]]
        for z in numbers_of([list(answer)], point)[0]:
            distances = [float(abs(each - z)) for each in wanted]
            nearest = wanted.pop(distances.index(min(distances)))
            worst = worst_of((worst, float(abs(nearest - z) / max(abs(nearest), MANY.context.mpf("1e-30")))))
    return with_many_digits(worst, *poles, T, answer)
