"""What a quantity is told by: a mode e^(-2t) by its eigenvalue, a crossing at ω = 3.3, a centroid (-2, 0)."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import split
from solver.classroom.reading.names import symbols_of

LIMITS = ("y_final", "final_value", "error")
_TENDS = re.compile(
    r"\s*[,(]?\s*(?:as|for|für|when|if)?\s*[tk]\s*(?:→|->|\\to|\\rightarrow)\s*(?:∞|inf\w*|oo|\\infty)\s*\)?\s*$"
)
_VOLTS = re.compile(r"(?<=[\d.)])\s*V(?:olts?)?(?:\s*(?:/|per|pro)\s*[^\W\d_]+(?:/s(?:\^?2|²)?)?)?(?=\s*(?:[,;}\n]|$))")
_AT = re.compile(r"^\s*(?:at|bei)\s+(?=[-−+±√.\d(])", re.IGNORECASE)
_ANGLE, _RADIANS = re.compile(r"\s*∠\s*"), re.compile(r"(∠\s*±?\s*[-+−]?[\d.]+)\s*rad\b")
_PER_CENT = re.compile(r"^\s*%\s*(?:OS|PO|MP)\s*=\s*([\d.]+)\s*%?\s*$", re.IGNORECASE)
_VALUE_OF = re.compile(r"(?<=[\w)])\s*=\s*[A-Z]\w*\(\s*(?:[01]|∞|inf)\s*\)\s*$")
"""3/2 = G(0): the value of a function somewhere, and no product."""
_UNDAMPED = re.compile(r"\s*(?:no damping|undamped|ungedämpft|keine dämpfung|without damping)\s*\.?", re.IGNORECASE)
_NEVER = re.compile(r"\s*(?:K\w*\s*(?:=|→|->)\s*)?(?:\+?∞|\+?oo|inf(?:inity)?|\\infty|unendlich)\s*", re.IGNORECASE)
_MODE = re.compile(r"(?:\bthe\s+)?(?:\bmodes?\s+)?(?:e\s*\^|exp)\s*[({]\s*([-+−]?\s*[\d./]*)\s*[*·]?\s*t\s*[)}]")
_ON_THE_AXIS = re.compile(r"\s*(?:[σs]\w*\s*=\s*)?\(\s*([^(),;|]+?)\s*[,;|]\s*j?0\s*\)\s*")
_FREQUENCY = re.compile(r"\s*\\?(?:ω|omega|w)(?:_\w+|_\{\w+\})?\s*=\s*([^=≈ij]+?)\s*(?:rad/s)?\s*")
_AND = re.compile(r"\s*(?:[,;]|\band\b|\bund\b)\s*")
_NONZERO = re.compile(r"[1-9√]")


def without_limit(text: str, name: str) -> str:
    """Return 1/2 of "1/2 as t → ∞", and factors without their volts per unit."""
    if name in LIMITS:
        return _TENDS.sub("", text)
    return _VOLTS.sub("", text) if name == "scale_factors" else text


def told_otherwise(text: str, name: str, ours: Any) -> str:
    """Return the text of the quantity that is asked for, where a usual other one is told; any other text as it is."""
    if "∠" in text:
        text = _RADIANS.sub(r"\1", _ANGLE.sub("∠", text))
    if name == "overshoot":
        text = _PER_CENT.sub(r"\1 %", text)
    if name.endswith("_modes"):
        return _MODE.sub(_exponent, text)
    if not symbols_of(ours) and isinstance(ours, sp.Expr | list):
        text = _VALUE_OF.sub("", _AT.sub("", text, count=1))
    if name == "damping_ratio" and _UNDAMPED.fullmatch(text):
        return "0"
    if name == "critical_gains" and _NEVER.fullmatch(text):
        return "none"
    if name in ("centroid", "real_axis_crossings") and (point := _ON_THE_AXIS.fullmatch(text)):
        return point[1]
    on_the_axis = name == "imaginary_axis_crossings" and all(sp.re(each) == 0 != each for each in ours)
    return _as_points_of_the_axis(text) if on_the_axis else text


def _exponent(found: re.Match[str]) -> str:
    """The eigenvalue of a mode e^(-2t)."""
    return f"{found[1].strip()}1" if found[1].strip() in ("", "+", "-", "−") else found[1]


def _as_points_of_the_axis(text: str) -> str:
    """Frequencies as points: ω = 3.3, or ω = ±3.3, as ±j 3.3."""
    found = _FREQUENCY.fullmatch(text)
    if found is None:
        return text
    items = [each.strip() for each in split(found[1], _AND)]
    if len(items) == 1 and not _NONZERO.search(items[0]):
        return items[0]
    both = len(items) == 1
    signed = [f"±j*({each.lstrip('±').strip()})" if both or each.startswith("±") else f"j*({each})" for each in items]
    return ", ".join(signed)
