"""A number that is said twice: π/3 ≈ 1.047, π/3 = 1.0472 s. It is the first where the others agree with it."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import split
from solver.classroom.submitted import Decimal, Submitted

MOST_SIDES = 4
_EQUAL = re.compile(r"\s*(?:[≈≅≙≃≐]|(?<![<>=!:])=(?![=>]))\s*")
_OR = re.compile(r"^([-+−\d./]+)\s+(?:or|oder|bzw\.?)\s+([-+−]?[\d.]+\s*(?:dB|°|%|deg|rad))\s*\.?$")
_AGAIN = re.compile(
    r"^(.*[\w)°%])\s*\(\s*(?:(?:[≈≅≙~=]|approx\.?|ca\.?|about|i\.e\.|d\.h\.)\s*([-+−\d.][^()=]*)|"
    r"([-+−]?[\d.]+\s*(?:dB|°|%|rad/s|rad|deg|Hz|ms|s)))\s*\)\s*\.?$"
)
PLACES = (sp.Rational(13, 11), sp.Rational(29, 17), sp.Rational(7, 19))
_CALLED = re.compile(r"(?<![A-Za-z_\\])[A-Z]\w?\s*\(\s*(?:0|1|∞|j\s*\w*)\s*\)")
_NAMES = re.compile(r"[^\W\d]\w*")
_COMPONENTS = re.compile(r"s?(?:[RC](?:_?[\df])?)+")
_OPERATION = re.compile(r"Q_9\d+|s")
_NEAR = sp.Rational(1, 10**9)


def sides(text: str) -> list[str]:
    """Return what stands on the sides of signs = and ≈, the one text where there are none, or too many.

    In brackets a value may stand once more with a sign or a unit of its own: 3 (9.54 dB), 1/19 (≈ 0.0526).
    """
    if again := _AGAIN.match(text):
        text = f"{again[1]} = {again[2] or again[3]}"
    if either := _OR.match(text):
        text = f"{either[1]} = {either[2]}"
    found = split(text, _EQUAL)
    return found if 1 < len(found) <= MOST_SIDES and all(side.strip() for side in found) else [text]


def says_how(text: str, signals: Collection[str], *, of_functions: bool) -> bool:
    """Whether a text is a formula in values of functions, 1 - G(0), or in components beside `signals`, -RC v."""
    names = _NAMES.findall(text)
    own = any(_COMPONENTS.fullmatch(each) for each in names)
    beside = all(_COMPONENTS.fullmatch(each) or each in signals or _OPERATION.fullmatch(each) for each in names)
    return (of_functions and _CALLED.search(text) is not None) or (bool(signals) and own and beside)


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


def same(one: Submitted, other: Submitted) -> bool:
    """Whether two values may be the same, entry by entry; formulas are compared at a few places."""
    decimals = {**one.decimals, **other.decimals}
    left, right = _entries(one.form), _entries(other.form)
    if len(left) != len(right):
        return False
    if isinstance(one.form, list) and not any(each.free_symbols - set(decimals) for each in (*left, *right)):
        left, right = (sorted(each, key=lambda x: _place(x, decimals)) for each in (left, right))
    letters = sorted(set().union(*(each.free_symbols for each in (*left, *right))) - set(decimals), key=str)
    for place in PLACES:
        at = {letter: place + sp.Rational(i, 7) for i, letter in enumerate(letters)}
        if not all(agree(a.xreplace(at), b.xreplace(at), decimals) for a, b in zip(left, right, strict=True)):
            return False
    return True


def _place(number: Any, decimals: Mapping[sp.Symbol, Decimal]) -> tuple[float, float]:
    """Where a number stands among those of a list, by its parts."""
    value = complex(sp.N(number.xreplace({symbol: decimal.number for symbol, decimal in decimals.items()})))
    return round(value.real, 9), value.imag


def _entries(form: Any) -> list[Any]:
    if isinstance(form, sp.MatrixBase):
        return [form[i, j] for i in range(form.rows) for j in range(form.cols)]
    return [*form] if isinstance(form, list | tuple) else [form]
