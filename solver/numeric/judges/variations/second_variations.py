"""Whether a functional is stationary, and what its nature is, by the second variation on admissible polynomials."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.variations.direct import motions, worst
from solver.numeric.judges.variations.problem import Along, Problem, numbers
from solver.numeric.judges.variations.varied import Varied

NONE = 1e-7
"""Eigenvalues relative to the largest that are none."""
CLEAR = 1e-5
"""Eigenvalues relative to the largest whose sign is beyond doubt."""


def first_variation_residual(problem: Problem, x: Mapping[str, Any] | None, t_f: Any = None) -> float:
    """Return how much admissible variations, of the end time too, change the functional to first order."""
    return worst(problem, x, t_f, lambda along: Varied(along).first())


def end_residual(problem: Problem, t_f: Any) -> float:
    """Return how far an end time is from that of an extremal found directly, relative to the time that there is."""

    def judge(along: Along) -> float:
        told = numbers(t_f, along.point, 1)[0]
        return float(abs(told - along.stop) / along.span)

    return worst(problem, None, None, judge)


def nature_holds(problem: Problem, x: Mapping[str, Any] | None, nature: str, t_f: Any = None) -> bool:
    """Whether "minimum", "maximum", "neither" or "undecided" fits the second variation on polynomials."""
    found = [_fits(Varied(along), nature) for along in motions(problem, x, t_f)]
    if nature == "undecided" and len(found) > 1:
        return True  # parameters may decide one way or the other
    if not found:
        raise NotEvaluable("no extremal was found by numbers")
    return all(found)


def _fits(varied: Varied, nature: str) -> bool:
    try:
        low, high = varied.extremes()
        least, largest = varied.curvatures()
        below, above = varied.convexity()
    except Undefined:
        return False
    plain = not varied.problem.constraints and not varied.problem.integrals
    minimum = low > CLEAR or (low > -NONE and plain and below > -NONE)
    maximum = high < -CLEAR or (high < NONE and plain and above < NONE)
    falls, rises = (low < -NONE or (plain and least < -NONE)), (high > NONE or (plain and largest > NONE))
    if nature == "minimum":
        return minimum
    if nature == "maximum":
        return maximum
    if nature == "neither":
        return falls and rises
    strict = (
        plain
        and varied.problem.stop is not None
        and ((low > CLEAR and least > CLEAR) or (high < -CLEAR and largest < -CLEAR))
    )
    return nature == "undecided" and not strict and not (low < -CLEAR and high > CLEAR)
