"""A number that is said twice: π/3 ≈ 1.047, π/3 = 1.0472 s. It is the first where the others agree with it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import split
from solver.classroom.submitted import Decimal

MOST_SIDES = 4
_EQUAL = re.compile(r"\s*(?:[≈≅]|(?<![<>=!:])=(?![=>]))\s*")
_NEAR = sp.Rational(1, 10**9)


def sides(text: str) -> list[str]:
    """Return what stands on the sides of signs = and ≈, the one text where there are none, or too many."""
    found = split(text, _EQUAL)
    return found if 1 < len(found) <= MOST_SIDES and all(side.strip() for side in found) else [text]


def agree(one: Any, other: Any, decimals: Mapping[sp.Symbol, Decimal]) -> bool:
    """Whether two numbers, with symbols for their decimals, may be the same; False of what is no number."""
    values = {symbol: decimal.number for symbol, decimal in decimals.items()}
    difference = one - other
    if difference.free_symbols - set(decimals) or difference.has(sp.nan, sp.oo, sp.zoo):
        return False
    slopes = {each: abs(difference.diff(each).xreplace(values)) for each in difference.free_symbols}
    spread = [slope * decimals[each].half_unit for each, slope in slopes.items()]
    allowed = sp.Add(*spread) + _NEAR * abs(one.xreplace(values))
    return bool(sp.N(abs(difference.xreplace(values)), 30) <= sp.N(allowed, 30))
