"""What stands beside a value and is none of it: the gain at a crossing, a region of convergence, what is transformed.

`-0.42 (K = 0.385)`, `±1.41j at K = 6`, `1/(s + 2), Re s > -2`, `L{f(t)} = 1/s`; and constants that are told behind the
formula they stand in: `A/(s + 1) + B/s, A = 2, B = -1`.
"""

from __future__ import annotations

import re
from collections.abc import Collection

from solver.classroom.reading.brackets import split

_NAME = r"\\?[^\W\d]\w{0,11}(?:\([stzk]\))?"
_BESIDE = re.compile(
    rf"\s*(?:\(\s*(?:at|for|with|bei|für|mit)?\s*(?P<in>{_NAME})\s*[=≈]\s*[^()=,;]+(?:\s[\w/]+)?\)"
    rf"|,?\s+(?:at|for|bei|für)\s+(?P<at>{_NAME})\s*[=≈]\s*[^=,;()]+?)(?=\s*(?:[,;\])}}.]|\band\b|\bund\b|$))"
)
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
_TRANSFORMED = re.compile(
    r"^\s*(?:\\mathcal\s*\{?\s*[LZ]\s*\}?|\\mathscr\s*\{?\s*[LZ]\s*\}?|[LZℒ𝒵])\s*(?P<inverse>\^\s*\{?\(?\s*[-−]\s*1\s*\)?\}?|⁻¹)?"
    r"\s*\\?[{\[(][^=]*?[}\])]\s*=\s*(?=\S)"
)
_EQUATION = re.compile(r"^\s*(?:\w+\.)*Eq\s*\(\s*([A-Za-z]\w*(?:\([tk]\))?)\s*,\s*(.+)\)\s*$", re.DOTALL)
_GIVEN = re.compile(rf"^({_NAME})\s*=\s*([^=<>≤≥,;]+)$")
_WITH = re.compile(r"\s*,?\s*(?:\b(?:with|where|mit|wobei|and|und)\b|[,;:])\s*")
_SOLVED = re.compile(r"^[^=,;]*[-+−*^²³][^=,;]*=\s*0\s*[,;:]\s*(?=[^\s=])")
MOST_CONSTANTS = 8


def without_remarks(text: str, own: str) -> str:
    """Return numbers without the values of other names beside them; `own` is the name of the answer."""

    def bare(found: re.Match[str]) -> str:
        name = found["in"] or found["at"]
        return found[0] if name == own or _COUNTED.fullmatch(name) else ""

    return _BESIDE.sub(bare, text) if "=" in text or "≈" in text else text


def without_region(text: str) -> str:
    """Return a transform without where it converges."""
    return _REGION.sub("", text)


def without_sample_time(text: str) -> str:
    """Return a pulse transfer function without the sample time beside it."""
    return _SAMPLED.sub("", text)


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


def with_constants(text: str, known: Collection[str]) -> str:
    """Return a formula with the numbers that are told behind it in place of their names; "" where there are none.

    A name that means something in the problem is none of those.
    """
    formula, *rest = split(text, _WITH) or [""]
    given = [_GIVEN.match(each.strip()) for each in rest]
    found = [each for each in given if each is not None]
    if not found or len(found) < len(given) or len(found) > MOST_CONSTANTS:
        return ""
    for each in found:
        if each[1] in known:
            return ""
        beside = "|(?=[sz](?!\\w))" if len(each[1]) == 1 else ""  # τs
        whole = re.compile(rf"(?<![\w\\]){re.escape(each[1])}(?:(?!\w){beside})")
        if not whole.search(formula):
            return ""
        value = f"({each[2].strip()})"
        formula = whole.sub(lambda _, value=value: value, formula)  # type: ignore[misc]
    return formula


def behind_equation(text: str) -> str:
    """Return λ = 4, -1 of λ² - 3λ - 4 = 0, λ = 4, -1; any other text as it is."""
    found = _SOLVED.match(text)
    return text[found.end() :] if found and re.search(r"=", text[found.end() :]) else text
