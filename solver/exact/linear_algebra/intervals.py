"""The values of one real symbol that conditions on it alone leave: intervals with open or closed ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import sympy as sp

from solver.conditions import Condition
from solver.exact.linear_algebra.sign_sets import DIGITS, Signs, of_number

MOST = 4
"""More intervals than these are taken as one that holds them all."""

ALLOWED: dict[str, Signs] = {">": frozenset({1}), ">=": frozenset({0, 1}), "!=": frozenset({-1, 1})}
"""The signs of its difference with which a condition holds."""


@dataclass(frozen=True)
class Interval:
    """From `low` to `high`; an end belongs to it where it is `closed`. The ends may be expressions in other symbols."""

    low: sp.Expr = -sp.oo
    high: sp.Expr = sp.oo
    low_closed: bool = False
    high_closed: bool = False


def assumed_interval(x: sp.Symbol) -> list[Condition]:
    """Return what is assumed of a symbol as conditions."""
    known = []
    if x.is_nonnegative or x.is_nonpositive:
        known.append(Condition(x if x.is_nonnegative else -x, ">="))
    if x.is_nonzero:
        known.append(Condition(x, "!="))
    return known


def intervals(x: sp.Symbol, conditions: Sequence[Condition]) -> list[Interval]:
    """Return the intervals in which all conditions hold, rising; conditions that are not solved exactly are left out.

    `conditions` are on x alone. Empty where they contradict each other.
    """
    solved = [
        (each, cuts) for each in (*assumed_interval(x), *conditions) if (cuts := _cuts(each.difference, x)) is not None
    ]
    points = _rising([cut for _, cuts in solved for cut in cuts])
    usable = [each for each, _ in solved]
    ends = [-sp.oo, *points, sp.oo]
    found: list[Interval] = []
    for low, high in pairwise(ends):
        if _hold(usable, x, _between(low, high)):
            joined = found and found[-1].high == low and found[-1].high_closed
            last = found.pop() if joined else Interval(low, low)
            found.append(Interval(last.low, high, last.low_closed))
        if high != sp.oo and _hold(usable, x, high):
            if found and found[-1].high == high:
                last = found.pop()
                found.append(Interval(last.low, high, last.low_closed, high_closed=True))
            else:
                found.append(Interval(high, high, low_closed=True, high_closed=True))
    if len(found) > MOST:
        return [Interval(found[0].low, found[-1].high, found[0].low_closed, found[-1].high_closed)]
    return found


def _cuts(difference: sp.Expr, x: sp.Symbol) -> list[sp.Expr] | None:
    """The real zeros and poles of a rational function; None where they are not rational, or surds of degree two."""
    if not difference.is_rational_function(x):
        return None
    found: list[sp.Expr] = []
    for part in sp.fraction(sp.together(difference)):
        if x not in part.free_symbols:
            continue
        for factor, _ in sp.factor_list(part, x)[1]:
            p = sp.Poly(factor, x)
            if p.degree() > 2:
                return None
            found += [root for root in sp.roots(p, multiple=True) if root.is_real]
    return found


def _rising(points: Sequence[sp.Expr]) -> list[sp.Expr]:
    found: list[sp.Expr] = []
    for point in sorted(points, key=lambda each: sp.N(each, DIGITS)):
        if not found or of_number(point - found[-1]) != {0}:
            found.append(point)
    return found


def _between(low: sp.Expr, high: sp.Expr) -> sp.Rational:
    """A rational number between two ends."""
    if low == -sp.oo:
        return sp.Integer(0) if high == sp.oo else sp.floor(high) - 1
    if high == sp.oo:
        return sp.ceiling(low) + 1
    return sp.Rational(str(sp.N((low + high) / 2, DIGITS)))


def _hold(conditions: Sequence[Condition], x: sp.Symbol, value: sp.Expr) -> bool:
    """Whether all conditions hold at a value."""
    for difference, relation in conditions:
        above, below = (
            of_number(sp.expand(part.xreplace({x: value}))) for part in sp.fraction(sp.together(difference))
        )
        signs = frozenset(a * b for a in above for b in below)
        if 0 in below or not signs <= ALLOWED[relation]:
            return False
    return True
