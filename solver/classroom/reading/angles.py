"""Angles where degrees are asked for: what has π or an arctangent, -π/4 or -90° - arctan(ω/2), is in radians."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import matching, split
from solver.classroom.submitted import Decimal

HALF_TURN = sp.Integer(180)
TURN = 2 * sp.pi
CONVERTED = 50
"""A factor beyond it turns radians into degrees already: 57.3 arctan(ω)."""
_OF_TWO = re.compile(r"(?<![A-Za-z_])(?:a|arc)tan2\s*\(")
_INVERSE = re.compile(r"\\?(?<![A-Za-z_])(sin|cos|tan)\s*(?:\^\s*[{(]?\s*[-−]\s*1\s*[)}]?|⁻¹)\s*")
_WHOLE = re.compile(r"(?<![\w.])([1-9])(\d{1,2})(?=\s*(?:°|deg(?:rees?)?\b))")
_ANGLES = (sp.atan, sp.asin, sp.acos)
_SCALE = sp.Dummy("scale", positive=True)


def with_arcs(text: str) -> str:
    """Return an angle with tan^-1 as atan, which can be nothing else there."""
    return _INVERSE.sub(r"a\1 ", text)


def with_rounded_degrees(text: str) -> str:
    """Return a formula whose whole degrees are decimals, cos(4t - 53°) with 5.3e1°: they are rounded."""
    return _WHOLE.sub(lambda found: f"{found[1]}.{found[2]}e{len(found[2])}", text)


def with_one_argument(text: str) -> str:
    """Return atan2(y, x) as 2 atan of y/(x + r), the half of the angle; any other text as it is."""
    while found := _OF_TWO.search(text):
        end = matching(text, found.end() - 1)
        pieces = [f"({each.strip()})" for each in split(text[found.end() : end], ",")]
        if len(pieces) != 2:
            return text
        y, x = pieces
        half = f"(2*atan({y}/({x} + sqrt({x}^2 + {y}^2))))"
        text = f"{text[: found.start()]}{half}{text[end + 1 :]}"
    return text


def readings_in_degrees(value: Any, decimals: Mapping[sp.Symbol, Decimal]) -> list[Any]:
    """Return what an angle may be in degrees, the likeliest first.

    A plain number is in degrees, beside radians too. Letters beside them, a dead time, may be in radians like them, and
    numbers of less than a turn, π/2 - 1.
    """
    if not value.has(sp.pi, *_ANGLES):
        return [value]
    terms = sp.Add.make_args(sp.expand(value))
    turned = [_is_in_radians(term, decimals) for term in terms]
    if not any(turned):
        return [value]
    each = [_in_degrees(term) if turn else term for term, turn in zip(terms, turned, strict=True)]
    beside = [_numbered(term, decimals) for term, turn in zip(terms, turned, strict=True) if not turn]
    either = any(term.free_symbols or abs(term) < TURN for term in beside)
    return [sp.Add(*each), *([_in_degrees(value)] if either else [])]


def _numbered(value: Any, decimals: Mapping[sp.Symbol, Decimal]) -> Any:
    """A value with its decimals as they were written."""
    return value.xreplace({symbol: decimal.number for symbol, decimal in decimals.items()})


def _in_degrees(value: Any) -> Any:
    return sp.expand(value * HALF_TURN / sp.pi)


def _is_in_radians(term: Any, decimals: Mapping[sp.Symbol, Decimal]) -> bool:
    """Whether a term is proportional to π or to an arctangent, by a factor that is none of 180/π."""
    angles = {each: sp.Dummy(positive=True) for each in term.atoms(*_ANGLES)}
    bare = term.xreplace(angles)
    scaled = bare.xreplace({each: _SCALE * each for each in (sp.pi, *angles.values())})
    if scaled / bare != _SCALE:
        return False
    factor = _numbered(bare.xreplace(dict.fromkeys((sp.pi, *angles.values()), sp.Integer(1))), decimals)
    return not (factor.is_number and angles and abs(factor) > CONVERTED)
