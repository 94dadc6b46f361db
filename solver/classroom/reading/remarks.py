"""What stands beside a value and is none of it: the gain at a crossing, a region of convergence, what is transformed.

`-0.42 (K = 0.385)`, `±1.41j at K = 6`, `1/(s + 2), Re s > -2`, `L{f(t)} = 1/s`.
"""

from __future__ import annotations

import re

from solver.classroom.reading.counts import NUMBERS
from solver.problem.expressions.notation import GREEK_NAMES

_NAME = r"\\?[^\W\d]\w{0,11}(?:\([stzk]\))?"
_BESIDE = re.compile(
    rf"\s*(?:\(\s*(?:at|for|with|bei|für|mit)?\s*(?P<in>{_NAME})\s*[=≈]\s*[^()=,;]+(?:\s[\w/]+)?\)"
    rf"|,?\s+(?:at|for|bei|für)\s+(?P<at>{_NAME})\s*[=≈]\s*[^=,;()]+?)(?=\s*(?:[,;\])}}]|\.(?!\d)|\band\b|\bund\b|$))"
)
_WHERE = re.compile(r"(?<=[\w)°%∞])\s*\(\s*(?:for |für |if |at )?(?=[^()]*[^\W\d_])[^()=]*[<>≤≥][^()]*\)")
"""Where a value holds: -40 (ω < 2), -20 (2 < ω < 10)."""
_FOUND = re.compile(r"(?<=[\w)°%∞])\s*\(\s*=\s*(?=[^()=]*[A-Za-z]_\{?\w)[^()=]*\)")
"""How a value is found: 0.25 (= 1/K_a)."""
_BETWEEN = re.compile(
    r"(?<=[\d)])\s*[,(]?\s*(?:lies |which is |liegt )?(?:between|zwischen)"
    r"\s+[-+−]?[\d.]+\s+(?:and|und)\s+[-+−]?[\d.]+\s*\)?\s*$"
)
_AT_POLES = re.compile(
    r"(?<=[\d)°])\s*[,(]?\s*(?:for|at|from|bei|für|am|vom)\s+(?:the\s+|den\s+|dem\s+)?(?:upper\s+|complex\s+)*"
    r"(?:poles?|pol(?:en)?)\s*(?:at |bei |[sp]\s*=)?\s*[-+−±\d./√ij ]*\)?\s*$"
)
"""Where a point lies, of which pole an angle is."""
_WORDS = re.compile(
    r"(?<=[\w)°%∞.])\s+\(\s*(\d?\s*[^\W\d_]{3,}(?:[\s,-]+[^\W\d_]{2,}){0,7})\s*\)(?=\s*(?:[,;]|\.?\s*$))"
)
_SAYING = frozenset(
    "not no nicht kein keine none never neither without ohne except außer but aber double twice triple times fold"
    " multiplicity each both conjugate conjugated conj konjugiert plus minus negative negativ inverse reciprocal half"
    " squared wrong false falsch unless rad radian radians degree degrees deg grad decibel decibels percent prozent"
    " hertz seconds second sekunden sek milliseconds minutes volt volts more less mehr weniger doppelt zweifach"
    " dreifach".split()
)
"""Words that say something of a value: it may be another one."""
_FREQUENCIES = ("_crossover", "_frequency", "bandwidth")
_COUNTED = re.compile(r"(?:alg\w*_?)?(?:m|mult\w*|am|a_m|AV|VF|vf|μ|mu|ν|nu|vielfachheit)(?:_?a)?")
"""Names of what says how often a value counts."""
_REGION = re.compile(
    r"\s*(?:,|;|\(|\bfor\b|\bfür\b|\bROC\s*:?|\bwith\b)+\s*(?:ROC\s*:?\s*)?"
    r"(?:(?:\\?(?:Re|Real|operatorname\{Re\})\s*[({]?\s*s\s*[)}]?|σ|sigma)\s*>\s*[^,;=<>]+"
    r"|\|\s*z\s*\|\s*>\s*[^,;=<>]+)\)?\s*\.?$"
)
_SAMPLED = re.compile(
    r"\s*(?:,|;|\()\s*(?:(?:with|for|mit|für)\s+)?(?:sampl\w+ time:?\s*)?"
    r"(?:T(?:_?\{?[sSaA0]\}?)?|h|dt)\s*=\s*[\d.]+\s*(?:s|sec|ms|seconds?)?\s*\)?\s*\.?$"
)
_HORIZON = re.compile(r"\s*,?\s*\(?(?:for|für|,)?\s*0\s*(?:<=?|≤)\s*t\s*(?:<=?|≤)\s*[\w./π√]+\s*\)?\s*\.?$")
_CONSTANT = re.compile(r"\s*(?:=|,|\()\s*(?:const(?:ant)?|konst(?:ant)?)\b\.?\)?\s*(?=[,;]|$)")
_TRANSFORMED = re.compile(
    r"^\s*(?:\\mathcal\s*\{?\s*[LZ]\s*\}?|\\mathscr\s*\{?\s*[LZ]\s*\}?|[LZℒ𝒵])\s*(?P<inverse>\^\s*\{?\(?\s*[-−]\s*1\s*\)?\}?|⁻¹)?"
    r"\s*\\?[{\[(][^=]*?[}\])]\s*=\s*(?=\S)"
)
_EQUATION = re.compile(r"^\s*(?:\w+\.)*Eq\s*\(\s*([A-Za-z]\w*(?:\([tk]\))?)\s*,\s*(.+)\)\s*$", re.DOTALL)
_SOLVED = re.compile(r"^[^=,;]*[-+−*^²³][^=,;]*=\s*0\s*[,;:]\s*(?=[^\s=])")


def without_remarks(text: str, own: str) -> str:
    """Return numbers without the values of other names beside them; `own` is the name of the answer."""

    def bare(found: re.Match[str]) -> str:
        name = found["in"] or found["at"]
        itself = name == own or (own.endswith(_FREQUENCIES) and name.strip("\\") in ("ω", "omega", "w"))
        return found[0] if itself or _COUNTED.fullmatch(name) else ""

    text = _AT_POLES.sub("", _BETWEEN.sub("", _WHERE.sub("", _FOUND.sub("", text))))
    return _BESIDE.sub(bare, text) if "=" in text or "≈" in text else text


def without_words_in_brackets(text: str) -> str:
    """Return numbers without remarks in brackets that are made of words and say nothing of them: 5.8 (numerically)."""

    def bare(found: re.Match[str]) -> str:
        said = set(re.findall(r"[^\W\d_]+", found[1].lower()))
        return found[0] if said & (_SAYING | NUMBERS.keys() | GREEK_NAMES) else ""

    return _WORDS.sub(bare, text)


def without_region(text: str) -> str:
    """Return a transform without where it converges."""
    return _REGION.sub("", text)


def without_sample_time(text: str) -> str:
    """Return a pulse transfer function without the sample time beside it."""
    return _SAMPLED.sub("", text)


def without_horizon(text: str) -> str:
    """Return what is optimal without the time from 0 on for which it is, and without that it is constant."""
    return _CONSTANT.sub("", _HORIZON.sub("", text))


def without_transformed(text: str, name: str) -> str:
    """Return F of L{f(t)} = F, and f of L^-1{F(s)} = f; any other text as it is."""
    found = _TRANSFORMED.match(text)
    if found is None or name not in ("F", "f") or bool(found["inverse"]) is not (name == "f"):
        return text
    return text[found.end() :]


def of_equation(text: str) -> str:
    """Return y(t) = f of sympy's Eq(y(t), f); "" of any other text."""
    found = _EQUATION.match(text)
    return f"{found[1]} = {found[2]}" if found else ""


def behind_equation(text: str) -> str:
    """Return λ = 4, -1 of λ² - 3λ - 4 = 0, λ = 4, -1; any other text as it is."""
    found = _SOLVED.match(text)
    return text[found.end() :] if found and re.search(r"=", text[found.end() :]) else text
