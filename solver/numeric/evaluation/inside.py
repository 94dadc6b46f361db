"""Points at which the conditions that symbols carry hold: drawn between bounds, moved over an edge, or drawn again."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from solver.conditions import (
    Condition,
    Conditions,
    Parameter,
    assumed_of,
    conditions_of,
    holds_at,
    symbols_of,
    without_conditions,
)
from solver.numeric.evaluation.values import NotEvaluable

TRIALS = 60
MOVES = 8
MARGIN = 0.04
"""How near to an end, in parts of its length, points of an interval are drawn."""


class Inside:
    """Draws values of symbols with conditions, and of those that the conditions compare them with."""

    def __init__(self, symbols: Sequence[Any], random: Random) -> None:
        self.conditions = conditions_of(symbols)
        known = {without_conditions(symbol): symbol for symbol in symbols}
        plain = set().union(*(each.difference.free_symbols for each in self.conditions))
        self.symbols = [known.get(symbol, symbol) for symbol in sorted({*plain, *known}, key=str)]
        self.random = random
        self.intervals = {symbol: self._intervals(symbol) for symbol in self.symbols}

    def point(self, usual: Callable[[Any], complex]) -> dict[Any, complex]:
        """Return a point; `usual` draws a value of a symbol without bounds. Raises NotEvaluable if none is found."""
        found = self._found(usual) if can_hold(self.conditions) else None
        if found is None:
            raise NotEvaluable("no values of the parameters were found at which the conditions hold")
        return found

    def _found(self, usual: Callable[[Any], complex]) -> dict[Any, complex] | None:
        for _ in range(TRIALS):
            found = {symbol: self._value(symbol, usual) for symbol in self.symbols}
            for _ in range(MOVES):
                broken = next((each for each in self.conditions if not _holds(each, found)), None)
                if broken is None:
                    return found
                if not self._moved(found, broken):
                    break
        return None

    def _value(self, symbol: Any, usual: Callable[[Any], complex]) -> complex:
        if not self.intervals[symbol]:
            return usual(symbol)
        low, high = self.random.choice(self.intervals[symbol])
        if low == -np.inf or high == np.inf:
            end = low if high == np.inf else high
            size = self.random.uniform(0.3, 2.5) * max(1.0, abs(end) / 2)
            value = end + size if high == np.inf else end - size
        else:
            value = low + (high - low) * self.random.uniform(MARGIN, 1 - MARGIN)
        return round(value) if symbol.is_integer else value

    def _intervals(self, symbol: Any) -> list[tuple[float, float]]:
        """The intervals in which the conditions on the symbol alone hold; none where there are no such."""
        x = without_conditions(symbol)
        alone = [each for each in self.conditions if each.difference.free_symbols == {x}]
        if not alone:
            return []
        cuts = sorted({0.0, *(root for each in alone for root in _real_roots(each.difference, x))})
        ends = [-np.inf, *cuts, np.inf]
        inside = []
        for low, high in pairwise(ends):
            middle = high - 1 if low == -np.inf else low + 1 if high == np.inf else (low + high) / 2
            assumed = not (x.is_nonnegative and middle < 0) and not (x.is_nonpositive and middle > 0)
            if assumed and all(_holds(each, {x: middle}) for each in alone):
                inside.append((low, high))
        return inside

    def _moved(self, point: dict[Any, complex], broken: Condition) -> bool:
        """Move one symbol, in which the condition is linear, to where it holds; return whether there is such a one."""
        names = {without_conditions(symbol): symbol for symbol in self.symbols}
        inside = [names[x] for x in symbols_of(broken.difference) if not names[x].is_integer]
        self.random.shuffle(inside)
        for symbol in sorted(inside, key=lambda each: len(self.intervals[each])):
            values = [_difference(broken, {**point, symbol: x}) for x in (0.0, 1.0, 2.0)]
            slope = values[1] - values[0]
            if abs(values[2] - values[0] - 2 * slope) > 1e-9 * (1 + abs(values[2])) or abs(slope) < 1e-9:
                continue
            edge = -values[0] / slope
            step = self.random.uniform(0.1, 1.5) * (1 + abs(edge) / 2)
            moved = edge + step * (1 if slope > 0 else -1)
            if not ((symbol.is_positive and moved <= 0) or (symbol.is_negative and moved >= 0)):
                point[symbol] = moved
                return True
        return False


@lru_cache(maxsize=64)
def can_hold(conditions: Conditions) -> bool:
    """Whether values are found at which conditions hold: they are looked for once."""
    random = Random(0)  # noqa: S311 - nothing secret
    symbols = [
        Parameter(x.name, conditions, **assumed_of(x)) for x in symbols_of(*(each.difference for each in conditions))
    ]
    return Inside(symbols, random)._found(lambda _: random.uniform(0.3, 2.5) * random.choice((-1, 1))) is not None


def _holds(condition: Condition, point: Mapping[Any, complex]) -> bool:
    value = _difference(condition, point)
    return bool({">": value > 0, ">=": value >= 0, "!=": value != 0}[condition.relation])


def _difference(condition: Condition, point: Mapping[Any, complex]) -> float:
    """The difference at a point; not a number where it is not real."""
    values = {symbol.plain if isinstance(symbol, Parameter) else symbol: value for symbol, value in point.items()}
    value = complex(sp.N(condition.difference.xreplace({x: sp.Integer(0) + v for x, v in values.items()})))
    return value.real if abs(value.imag) <= 1e-12 * (1 + abs(value)) else float("nan")


def _real_roots(difference: Any, x: Any) -> list[float]:
    """The real zeros and poles of a rational function, in decimals."""
    found: list[float] = []
    for part in sp.fraction(sp.together(difference)):
        if x in part.free_symbols and part.is_polynomial(x):
            roots = np.roots([complex(sp.N(c)) for c in sp.Poly(part, x).all_coeffs()])
            found += [float(root.real) for root in roots if abs(root.imag) < 1e-9 * (1 + abs(root))]
    return found


def admits(point: Mapping[Any, Any]) -> bool:
    """Whether the conditions that symbols of a point carry hold at it."""
    return holds_at(point, point)
