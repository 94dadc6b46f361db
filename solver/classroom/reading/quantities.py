"""What a quantity is told by: a mode e^(-2t) by its eigenvalue, a crossing at ω = 3.3, a centroid (-2, 0)."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import sympy as sp

from solver.classroom.reading.brackets import split
from solver.classroom.reading.in_order import by_variables
from solver.classroom.reading.names import symbols_of
from solver.classroom.reading.remarks import without_words_in_brackets

LIMITS = ("y_final", "final_value", "error")
_TENDS = re.compile(
    r"\s*[,(]?\s*(?:as|for|für|when|if)?\s*[tk]\s*(?:→|->|\\to|\\rightarrow)\s*(?:∞|inf\w*|oo|\\infty)\s*\)?\s*$"
)
_VOLTS = re.compile(
    r"(?<=[\d.)])\s*V(?:olts?)?(?:\s*(?:/|per|pro)\s*(?:[^\W\d_]+(?:/s(?:\^?2|²)?)?|\([^()]*\)))?(?=\s*(?:[,;}\n]|$))"
)
_AT = re.compile(r"^\s*(?:at|bei)\s+(?=[-−+±√.\d(])", re.IGNORECASE)
_ANGLE, _RADIANS = re.compile(r"\s*∠\s*"), re.compile(r"(∠\s*±?\s*[-+−]?[\d.]+)\s*rad\b")
_PER_CENT = re.compile(r"^\s*%\s*(?:OS|PO|MP)\s*=\s*([\d.]+)\s*%?\s*$", re.IGNORECASE)
_VALUE_OF = re.compile(r"(?<=[\w)])\s*=\s*[A-Z]\w*\(\s*(?:[01]|∞|inf)\s*\)\s*$")
"""3/2 = G(0): the value of a function somewhere, and no product."""
_UNDAMPED = re.compile(r"\s*(?:no damping|undamped|ungedämpft|keine dämpfung|without damping)\s*\.?", re.IGNORECASE)
_NEVER = re.compile(r"\s*(?:K\w*\s*(?:=|→|->)\s*)?(?:\+?∞|\+?oo|inf(?:inity)?|\\infty|unendlich)\s*", re.IGNORECASE)
_MODE = re.compile(
    r"(?:\bthe\s+)?(?:\bmodes?\s+)?(?:(?:e\s*\^|exp)\s*[({]\s*|e\s*\^\s*(?=[-+−\dt]))([-+−]?\s*[\d./]*)\s*[*·]?\s*t\b\s*[)}]?"
)
_UNBOUNDED = re.compile(
    r"\s*(?:it |e |the error |der fehler )?(?:(?:grows|increases|wächst|steigt)"
    r"(?: (?:without (?:bound|limit)|unboundedly|to infinity|über alle grenzen|unbegrenzt|unbeschränkt|ins unendliche))"
    r"|(?:is )?(?:unbounded|not finite|nicht endlich)|unbeschränkt|unbegrenzt"
    r"|unendlich(?: groß)?|infinitely (?:large|big)|diverges|divergiert)(?:\s*[,(].*)?\s*\.?",
    re.IGNORECASE | re.DOTALL,
)
"""Of an error, or of a margin: ∞."""
_NONE_INFINITE = re.compile(
    r"\s*(?:does not exist|none|not defined|undefined|existiert nicht)\s*[,(]\s*(?:i\.e\. |so |also )?"
    r"(?:infinite|infinity|∞|inf|unendlich)\s*\)?\s*\.?",
    re.IGNORECASE,
)
_INFINITE = re.compile(
    r"^(\s*(?:[^\W\d][\w ]*?[=:→]\s*)?\+?(?:∞|inf(?:inity|inite)?|oo|unendlich|\\infty))\s*"
    r"(?:dB|°|deg|rad/s|s|sec|1/s|[,;(]\s*(?:the|die|der|das|since|because|as|da|weil|it|no|there|phase)\b.*)\s*\.?\s*$",
    re.IGNORECASE | re.DOTALL,
)
"""∞ has no unit, and reasons behind it say no other value."""
_SLOPES = re.compile(r"\s*[-+−]?\d+0?(?:\s*/\s*[-+−]?\d+)+(?=\s*(?:dB\b.*)?$)")
_CONJUGATE_ANGLE = re.compile(
    r"^\s*([-+−]?)\s*([\d.]+)\s*(°|deg)?\s*[,;(]?\s*(?:and|und)\s+([-+−]?)\s*([\d.]+)\s*(?:°|deg)?\s+"
    r"(?:for|at|bei|für|am)\s+(?:the\s+|den\s+|dem\s+)?(?:complex )?(?:conj|konj)[^()]*\)?\s*$"
)
_ON_THE_AXIS = re.compile(r"\s*(?:[σs]\w*\s*=\s*)?\(\s*([^(),;|]+?)\s*[,;|]\s*j?0\s*\)\s*")
_FREQUENCY = re.compile(r"\s*\\?(?:ω|omega|w)(?:_\w+|_\{\w+\})?\s*=\s*([^=≈ij]+?)\s*(?:rad/s)?\s*")
_AND = re.compile(r"\s*(?:[,;]|\band\b|\bund\b)\s*")
_AT_REST = re.compile(r"\s*[A-Z]\w*\s*\(\s*[sz]?\s*=?\s*[01]\s*\)\s*=")
_IN_DECIBELS = re.compile(r"^\s*20\s*[*·]?\s*(?:log|lg)(?:_?\{?10\}?|₁₀)?\s*[^=≈]*[=≈]\s*(?=[-+−]?[\d.]+\s*dB\s*$)")
"""How a ratio in decibels is found."""
_NONZERO = re.compile(r"[1-9√]")


def is_value_at_rest(text: str, name: str) -> bool:
    """Whether a text is labelled as the value of a function that an answer is, G(0) of a DC gain."""
    return name == "dc_gain" and _AT_REST.match(text) is not None


def without_limit(text: str, name: str) -> str:
    """Return 1/2 of "1/2 as t → ∞", and factors without their volts per unit."""
    if name in LIMITS:
        return _TENDS.sub("", text)
    return by_variables(_VOLTS.sub("", text)) if name == "scale_factors" else text


def told_otherwise(text: str, name: str, ours: Any) -> str:
    """Return the text of the quantity that is asked for, where a usual other one is told; any other text as it is."""
    if "∠" in text:
        text = _RADIANS.sub(r"\1", _ANGLE.sub("∠", text))
    if name.endswith("_modes"):
        return _MODE.sub(_exponent, text)
    if not symbols_of(ours) and isinstance(ours, sp.Expr | list):
        text = _VALUE_OF.sub("", _AT.sub("", text, count=1))
    if name in LIMITS or name == "dc_gain" or name.endswith(("_constant", "_margin", "_margin_db", "_crossover")):
        text = _IN_DECIBELS.sub("", text) if name in ("dc_gain", "gain_margin") else text
        return "∞" if _UNBOUNDED.fullmatch(text) or _NONE_INFINITE.fullmatch(text) else _INFINITE.sub(r"\1", text)
    if name in _TOLD:
        return _TOLD[name](text)
    if name.endswith("_angles"):
        return _CONJUGATE_ANGLE.sub(_of_the_upper_pole, without_words_in_brackets(text))
    on_the_axis = name == "imaginary_axis_crossings" and all(sp.re(each) == 0 != each for each in ours)
    return _as_points_of_the_axis(text) if on_the_axis else text


def _slopes(text: str) -> str:
    """Slopes with a bar between them, -40/-20/-40 dB/decade."""
    found = _SLOPES.match(text)
    return found[0].replace("/", ",") + text[found.end() :] if found else text


def _on_the_real_axis(text: str) -> str:
    found = _ON_THE_AXIS.fullmatch(text)
    return found[1] if found else text


_TOLD: dict[str, Callable[[str], str]] = {
    "overshoot": lambda text: _PER_CENT.sub(r"\1 %", text),
    "damping_ratio": lambda text: "0" if _UNDAMPED.fullmatch(text) else text,
    "critical_gains": lambda text: "none" if _NEVER.fullmatch(text) else text,
    "slopes": _slopes,
    **dict.fromkeys(("magnitude", "bode_gain", "resonant_peak"), lambda text: _IN_DECIBELS.sub("", text)),
    **dict.fromkeys(("centroid", "real_axis_crossings"), _on_the_real_axis),
}
"""What is told otherwise, by the name of the answer."""


def _of_the_upper_pole(found: re.Match[str]) -> str:
    """-45° of "-45° and +45° for the conjugate pole"; where the two are not opposite, what stands there."""
    sign, number, unit, other_sign, other = found.groups()
    opposite = number == other and (sign in ("-", "−")) is not (other_sign in ("-", "−"))
    return f"{sign}{number}{unit or ''}" if opposite else found[0]


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
