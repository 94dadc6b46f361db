"""Texts of lists put otherwise: a conjugate for both of a pair, what is said of all items, multiplicities, sets."""

from __future__ import annotations

import re

_COLUMN = re.compile(r"\s*[\[(]([^\[\]();,]+(?:;[^\[\]();,]+)+)[\])]\s*")
_NAMED = re.compile(r"\s*([^\W\d]\w*)\s*[:=]\s*([^:=]*\S)\s*")
_CALL = re.compile(
    r"^\s*(?:\w+\.)*(?:roots|eig\w*|Eigenvalues|poles?|zeros?|tzero|spec|solve|Solve)\s*"
    r"(?:\([^()]*\)|\[[^\[\]]*\])\s*=\s*(?=[-+−±\d\[{(])"
)
_CONJUGATE = re.compile(
    r"\s*(?:,|\+|\band\b|\bund\b|\bplus\b)\s*(?:its |the |das |ihre?\w* |\()?\s*"
    r"(?:(?:complex |komplex )?conj(?:ugates?|\.)?"
    r"|(?:komplex )?konjugierte?s?|c\.\s?c\.|cc|k\.\s?k\.)\)?\s*\.?\s*$",
    re.IGNORECASE,
)
_IMAGINARY = re.compile(r"^(.*?)([-+−])(\s*(?:[ij][^-+−,;]*|[^-+−,;]*[ij]))$")
_MULTIPLICITY = re.compile(
    r",\s*((?:alg\w*\.?\s*)?(?:mult\w*\.?|vielfachheit|vfh\.?)\s*(?:=|of)?\s*\d)(?=\s*(?:[,;.]|$))", re.IGNORECASE
)
_GEOMETRIC = re.compile(
    r",\s*(?:geom\w*\.?\s*(?:mult\w*\.?|vielfachheit|vfh\.?)|g\.?\s?[mv]\.?)\s*(?:=|of)?\s*\d(?=\s*\))", re.IGNORECASE
)
_EACH = re.compile(
    r"^([^:=]*?)[,:]?\s+\(?(?:each|both|jeweils|beide)\s+(?:(?:with|of|mit)\s+)?(?:(?:algebraic\s+)?(?:multiplicity|mult\.|"
    r"vielfachheit)\s*(\d)|double|twice|doppelt)\)?\s*\.?$",
    re.IGNORECASE,
)
_ANGLES_OF_ALL = re.compile(r"^[^,;]*\(\s*(?:2\s*[kqnlm]|[kqnlm]\s*·?\s*360)[^,;=:]*[=:]\s*(?=[^=]*$)")
_THEN = re.compile(r"\s*(?:→|->|,?\s+(?:then|dann|danach)\b)\s*")
_OR = re.compile(r"\s+(?:or|oder)\s+")
_SETS = re.compile(r"\}\s*(?:∪|\bund\b|\band\b|,)\s*\{")


def with_conjugates(text: str) -> str:
    """Return -1 ± 2j for -1 + 2j and its conjugate; "" of any other text."""
    found = _CONJUGATE.search(text)
    parts = _IMAGINARY.match(text[: found.start()].strip()) if found else None
    return f"{parts[1]}±{parts[3]}" if parts else ""


def with_multiplicities(text: str) -> str:
    """Return -1 (mult. 2) for "-1, mult. 2", without what is said of geometric multiplicities."""
    return _GEOMETRIC.sub("", _MULTIPLICITY.sub(r" (\1)", text))


def each_so_often(text: str) -> str:
    """Return -1 (multiplicity 2), -2 (multiplicity 2) for "{-1, -2} each with multiplicity 2"."""

    def spread(found: re.Match[str]) -> str:
        items = re.split(r"\s*(?:[,;]|\band\b|\bund\b)\s*", found[1].strip(" {}[]"))
        return ", ".join(f"{item} (multiplicity {found[2] or 2})" for item in items)

    return _EACH.sub(spread, text)


def behind_angles_of_all(text: str) -> str:
    """Return 60°, 180°, 300° for "180°(2k + 1)/3 = 60°, 180°, 300°"."""
    return _ANGLES_OF_ALL.sub("", text)


def one_after_another(text: str) -> str:
    """Return -20, -40 for "-20, then -40" and for "-20 → -40"."""
    return _THEN.sub(", ", text)


def joined_alternatives(text: str) -> str:
    """Return {x: 1}, {x: 2} for "{x: 1} or {x: 2}"."""
    return _OR.sub(", ", text)


def joined_sets(text: str) -> str:
    """Return {-1, -2} for {-1} ∪ {-2}."""
    return _SETS.sub(", ", text)


def behind_call(text: str) -> str:
    """Return the values of roots([1 3 2]) = -1, -2, without what finds them."""
    return _CALL.sub("", text)


def as_point(text: str) -> str:
    """Return (1, 2) of the column [1; 2], and x = 1, y = 2 of these lines with colons; "" of any other text."""
    if found := _COLUMN.fullmatch(text):
        return f"({found[1].replace(';', ', ')})"
    lines = [_NAMED.fullmatch(line) for line in text.strip().split("\n")]
    return ", ".join(f"{line[1]} = {line[2]}" for line in lines if line) if len(lines) > 1 and all(lines) else ""
