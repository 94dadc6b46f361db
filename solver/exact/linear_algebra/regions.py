"""The region of the parameters that conditions describe, as the image of symbols of known sign.

A parameter between bounds is a function of a positive symbol p: l + p, u − p, (l + u p)/(1 + p). The bounds are
numbers, by conditions on the parameter alone, or expressions in other parameters, by conditions that are linear in it
(a > b is a = b + p). So an expression is positive in the region if a rational function of positive symbols is positive.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache, reduce
from itertools import product
from typing import Any

import sympy as sp

from solver.conditions import Condition, Conditions, symbols_of
from solver.exact.linear_algebra.intervals import ALLOWED, Interval, intervals
from solver.exact.linear_algebra.sign_sets import (
    ANY,
    POSITIVE,
    Signs,
    factors,
    of_power,
    of_product,
    of_sum,
    signs_by_assumptions,
)

MOST_BOXES = 16
PASSES = 3


@dataclass
class Box:
    """Bounds of some symbols. The bounds of a symbol hold no symbol that is bounded by it, by itself or by others."""

    bounds: dict[sp.Symbol, Interval] = field(default_factory=dict)

    def signs(self, x: sp.Expr) -> Signs:
        """Return the signs that an expression may have in the box."""
        return signs_by_assumptions(self.written(x))

    def written(self, x: sp.Expr) -> sp.Expr:
        """Return the expression in the symbols of known sign."""
        for symbol in self._last_first():
            x = x.xreplace({symbol: _image(symbol, self.bounds[symbol])})
        return sp.together(x)

    def _last_first(self) -> list[sp.Symbol]:
        """The bounded symbols, each before those in its bounds."""
        ordered: list[sp.Symbol] = []
        left = sorted(self.bounds, key=str)
        while left:
            free = [x for x in left if not any(x in self._direct(y) for y in left if y != x)]
            ordered += free
            left = [x for x in left if x not in free]
        return ordered

    def _direct(self, x: sp.Symbol) -> set[Any]:
        bounds = self.bounds.get(x, Interval())
        return set(symbols_of(bounds.low, bounds.high))

    def depends(self, x: sp.Symbol, on: sp.Symbol) -> bool:
        """Whether the bounds of x hold a symbol, or one that is bounded by it."""
        return any(y == on or self.depends(y, on) for y in self._direct(x))

    def bound(self, condition: Condition) -> bool:
        """Take a condition in that is linear in a symbol; return whether the bounds of one say all of it now."""
        return any(self._bounded(x, condition) for x in symbols_of(condition.difference))

    def _bounded(self, x: sp.Symbol, condition: Condition) -> bool:
        difference = condition.difference
        if not difference.is_polynomial(x) or sp.degree(difference, x) != 1:
            return False
        a, b = sp.Poly(difference, x).all_coeffs()
        of_a, end = self.signs(a), -b / a
        if len(of_a) > 1 or 0 in of_a or any(y == x or self.depends(y, x) for y in symbols_of(end)):
            return False
        return self._moved(x, end, lower=1 in of_a, closed=condition.relation == ">=")

    def _moved(self, x: sp.Symbol, end: sp.Expr, *, lower: bool, closed: bool) -> bool:
        """Put a bound in place of the one before, if it says more; return False if neither is known to."""
        old = self.bounds.get(x, Interval())
        before = old.low if lower else old.high
        if before not in (-sp.oo, sp.oo):
            gain = self.signs(end - before if lower else before - end)
            if gain <= {-1, 0}:
                return True
            if not gain <= {0, 1}:
                return False
        new = (
            Interval(end, old.high, closed, old.high_closed)
            if lower
            else Interval(old.low, end, old.low_closed, closed)
        )
        self.bounds[x] = new
        if -sp.oo != new.low and new.high != sp.oo:  # there are values between the two only if they are in order
            self.bound(Condition(new.high - new.low, ">=" if new.low_closed and new.high_closed else ">"))
        return True


def _image(x: sp.Symbol, bounds: Interval) -> sp.Expr:
    """The symbol as a function of one that is positive, or not negative where an end belongs to the interval."""
    low, high = bounds.low, bounds.high
    if low == high:
        return low
    closed = bounds.low_closed if low != -sp.oo else bounds.high_closed
    if low != -sp.oo and high != sp.oo and bounds.high_closed and not bounds.low_closed:
        low, high, closed = high, low, True
    p = _beyond(x.name, closed)
    if low == -sp.oo:
        return high - p if high != sp.oo else x
    return low + p if high == sp.oo else (low + high * p) / (1 + p)


@lru_cache(maxsize=256)
def _beyond(name: str, closed: bool) -> sp.Dummy:
    """How far a symbol is beyond its bound; the same symbol each time, so that results are found again."""
    return sp.Dummy(name, **({"nonnegative": True} if closed else {"positive": True}))


@dataclass(frozen=True)
class Region:
    """Boxes that together hold all admissible values; `facts`: known signs of polynomials, by their monic form."""

    boxes: Sequence[Box]
    facts: Mapping[sp.Expr, Signs]

    def signs(self, x: sp.Expr) -> Signs:
        """Return the signs that an expression in plain symbols may have in the region."""
        powers = dict(factors(x))
        found = {factor: of_power(self._of_factor(factor), n) for factor, n in powers.items()}
        left = [factor for factor, signs in found.items() if len(signs) > 1 and powers[factor] % 2]
        known, rest = (
            reduce(of_product, (found[each] for each in listed), POSITIVE)
            for listed in ([each for each in found if each not in left], left)
        )
        if len(left) > 1:  # a fact may be about the product
            rest &= self._of_factor(sp.expand(sp.Mul(*left)))
        return of_product(known, rest)

    def _of_factor(self, x: sp.Expr) -> Signs:
        """The signs of a factor: a fact, or by the boxes, or more than a fact by something not negative."""
        lead, form = monic(x)
        known = of_product(signs_by_assumptions(lead), self.facts.get(form, ANY))
        if len(known) > 1:
            known &= self._in_boxes(x)
        if len(known) > 1:
            for sign in (1, -1):
                known &= frozenset(sign * each for each in self._beyond_a_fact(sign * x))
        return known

    def _in_boxes(self, x: sp.Expr) -> Signs:
        return frozenset().union(*(box.signs(x) for box in self.boxes)) if self.boxes else ANY

    def _beyond_a_fact(self, x: sp.Expr) -> Signs:
        """The signs of x = c g + h, where c is a positive number, g is known to be positive, and h not negative."""
        terms = sp.expand(x).as_coefficients_dict()
        for form, of_form in self.facts.items():
            g, of_g = (form, of_form) if 1 in of_form else (-form, frozenset(-each for each in of_form))
            if not of_g <= {0, 1}:
                continue
            mine = sp.expand(g).as_coefficients_dict()
            ratios = {terms[each] / c for each, c in mine.items() if each in terms}
            for ratio in sorted(c for c in ratios if c.is_positive):
                if (rest := self._in_boxes(sp.expand(x - ratio * g))) <= {0, 1}:
                    return of_sum(of_g, rest)
        return ANY


def monic(x: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return a number and the polynomial with leading coefficient one whose product x is."""
    symbols = sorted(x.free_symbols, key=str)
    if not symbols or not x.is_polynomial(*symbols):
        return sp.Integer(1), x
    lead = sp.Poly(x, *symbols).LC()
    return lead, sp.expand(x / lead)


@lru_cache(maxsize=64)
def region_of(conditions: Conditions) -> Region | None:
    """Return the region of the conditions; None where they are seen to contradict each other."""
    alone: dict[sp.Symbol, list[Condition]] = {}
    several: list[Condition] = []
    for each in conditions:
        if len(symbols := symbols_of(each.difference)) == 1:
            alone.setdefault(symbols[0], []).append(each)
        else:
            several.append(each)
    for x in symbols_of(*(each.difference for each in several)):
        alone.setdefault(x, [])
    choices = {x: _ends_apart(intervals(x, alone[x])) for x in sorted(alone, key=str)}
    if not all(choices.values()):
        return None
    if sp.prod(len(each) for each in choices.values()) > MOST_BOXES:
        choices = {x: [_hull(each)] for x, each in choices.items()}
    boxes = [_box(dict(zip(choices, each, strict=True)), several) for each in product(*choices.values())]
    region = Region([each for box in boxes for each in _apart(box)], {})
    facts: dict[sp.Expr, Signs] = {}
    for _ in range(2):
        for each in conditions:
            facts = _with_fact(Region(region.boxes, facts), each)
            if frozenset() in facts.values():
                return None
    return Region(region.boxes, facts)


def _ends_apart(found: list[Interval]) -> list[Interval]:
    """The intervals; from one with two closed ends the upper end is taken out."""
    listed: list[Interval] = []
    for each in found:
        if each.low_closed and each.high_closed and each.low != each.high:
            listed.append(Interval(each.low, each.high, low_closed=True))
            listed.append(Interval(each.high, each.high, low_closed=True, high_closed=True))
        else:
            listed.append(each)
    return listed


def _hull(found: list[Interval]) -> Interval:
    """One interval around all; its ends are open only if they cannot be reached."""
    low, high = found[0].low, found[-1].high
    if found[-1].high_closed and found[0].low_closed:
        return Interval(low, high + 1, low_closed=True)
    return Interval(low, high, found[0].low_closed, found[-1].high_closed)


def _box(bounds: dict[sp.Symbol, Interval], several: Sequence[Condition]) -> Box:
    box, left = Box(bounds), [each for each in several if each.relation != "!="]
    for _ in range(PASSES):
        left = [each for each in left if not box.bound(each)]
    return box


def _apart(box: Box) -> list[Box]:
    """The box; where both ends of a symbol belong to it, apart from them the box with the symbol at its upper end."""
    for x, each in box.bounds.items():
        if each.low_closed and each.high_closed and each.low != each.high:
            inside = {**box.bounds, x: Interval(each.low, each.high, low_closed=True)}
            at_end = {**box.bounds, x: Interval(each.high, each.high, low_closed=True, high_closed=True)}
            return [*_apart(Box(inside)), *_apart(Box(at_end))]
    return [box]


def _with_fact(region: Region, condition: Condition) -> dict[sp.Expr, Signs]:
    """The facts, and what a condition says of the factors whose signs are not known."""
    facts = dict(region.facts)
    allowed = ALLOWED[condition.relation]
    if not region.signs(condition.difference) & allowed:
        return {sp.Integer(0): frozenset()}
    known, open_factors = frozenset({1}), []
    for factor, exponent in factors(condition.difference):
        found = of_power(region.signs(factor), exponent)
        if len(found) > 1 and exponent % 2:
            open_factors.append(factor)
        else:
            known = of_product(known, found - {0} if 0 not in allowed else found)
    if open_factors and len(known) == 1 and 0 not in known:
        lead, form = monic(sp.expand(sp.Mul(*open_factors)))
        sign = next(iter(of_product(known, signs_by_assumptions(lead))))
        facts[form] = facts.get(form, ANY) & frozenset(sign * each for each in allowed)
    for factor in open_factors if 0 not in allowed else ():
        form = monic(factor)[1]
        facts[form] = facts.get(form, ANY) - {0}
    return facts
