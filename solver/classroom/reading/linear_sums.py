"""Sums of multiples of x1, x2, u and the like, as texts: what stands before each, -5x1 - 4x2 + u."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import matching

_TERM = re.compile(
    r"^\s*([-+−]?)\s*(.*?)\s*[*·]?\s*([a-z])_?\{?([1-9]?)\}?(?:\([tk]\)|\[k\]|_k)?"
    r"\s*(?:/\s*([\w.]+|\([^()]*\)))?\s*$",
    re.DOTALL,
)
_OUTER = re.compile(r"^\s*([-+−]?\s*(?:\d+(?:\.\d+)?(?:/\d+)?)?)\s*[*·]?\s*(?=\()")
_DIVIDED = re.compile(r"(\(.*)\)\s*/\s*(\d+(?:\.\d+)?)", re.DOTALL)
_CONTINUED = re.compile(r"[*/^]\s*$|[\d.][eE]$")
"""The sign behind it is none between two terms."""
_BELOW = str.maketrans("₁₂₃₄₅₆₇₈₉−", "123456789-")

Name = tuple[str, str]
"""A letter and its index, which may be missing."""


def with_plain_indices(text: str) -> str:
    """Return a text with x1 for x₁ and - for −."""
    return text.translate(_BELOW)


def coefficients(text: str, letters: str) -> dict[Name, str] | None:
    """Return what stands before each of the letters in a sum; None where anything else stands in it.

    A factor before the brackets round all of it counts for each.
    """
    text = " ".join(with_plain_indices(text).split())
    if text == "0":
        return {}
    outer = ""
    if (found := _DIVIDED.fullmatch(text)) and matching(text, 0) == found.end(1):
        outer, text = f"(1/({found[2]}))*", found[1][1:]
    elif (found := _OUTER.match(text)) and matching(text, found.end()) == len(text) - 1:
        factor = found[1].strip()
        outer, text = f"({factor}1)*" if factor in ("", "-", "+") else f"({factor})*", text[found.end() + 1 : -1]
    named: dict[Name, str] = {}
    others = re.compile(rf"(?<![A-Za-z_])[{letters}](?![A-Za-z])")
    for term in terms(text):
        match = _TERM.match(term)
        if match is None or match[3] not in letters or others.search(match[2]) or (match[3], match[4]) in named:
            return None
        below = f"/{match[5]}" if match[5] else ""
        named[match[3], match[4]] = f"{outer}({match[1].strip('+')}({match[2] or '1'}){below})"
    return named


def terms(text: str) -> list[str]:
    """Return the terms of a sum with their signs."""
    pieces, start, at = [], 0, 0
    while at < len(text):
        if text[at] in "([{":
            at = matching(text, at) + 1
        elif text[at] in "+-" and text[start:at].strip() and not _CONTINUED.search(text[start:at]):
            pieces.append(text[start:at])
            start, at = at, at + 1
        else:
            at += 1
    return [*pieces, text[start:]]
