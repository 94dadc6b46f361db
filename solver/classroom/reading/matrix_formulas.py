"""Formulas of A, B, C, D that stand before a value and say how it is found: T^-1 A T, D - C A^-1 B, e^(A T)."""

from __future__ import annotations

import re

_AT_ZERO = re.compile(
    r"(?:D\s*[-−]\s*|[-−]\s*)C\s*[*·]?\s*(?:A\s*(?:\^\s*[({]?-1[)}]?|⁻¹)|inv\(A\))\s*[*·]?\s*B(?:\s*\+\s*D)?"
    r"|C\s*\(\s*-\s*A\s*\)\s*\^\s*[({]?-1[)}]?\s*B(?:\s*\+\s*D)?"
)
_OF_INVERSE = re.compile(r".*A\s*(?:\^\s*[({]?-1|⁻¹)|.*inv\(A\)")
"""The gain at s = 0 by the matrices; what else has the inverse of A in it is no such gain."""
_OF_FUNCTION = re.compile(r"(?<![A-Za-z])[GHT]\w?\s*\(")
_FUNCTION_AT_ZERO = re.compile(r"\|?\s*(?:\\?lim\b.*?)?[GHT]\w?\s*\(\s*(?:s|0|j0|j\*0|s\s*=\s*0)\s*\)\s*\|?")
_SAMPLED = re.compile(
    r"(?:e\s*\^\s*[({]?\s*A\s*[*·]?\s*T\w*\s*[)}]?|expm?\(A\s*[*·]?\s*T\w*\)|I\w?\s*\+\s*A\s*[*·]?\s*T\w*(?:\s*\+[\s\w^/²!().…]*)?)"
)
"""The matrix of a sampled plant."""
_SIMILAR = re.compile(r"\s*(?:(?:T\s*(?:\^[({]?-1[)}]?|⁻¹)|inv\(T\)|T\s*\\)\s*\*?\s*(?:A\s*\*?\s*T|B)|C\s*\*?\s*T)\s*")


def is_similar(text: str) -> bool:
    """Whether a text is a matrix in other coordinates, T^-1 A T, T^-1 B or C T."""
    return _SIMILAR.fullmatch(text) is not None


def is_sampled(text: str) -> bool:
    """Whether a text is the matrix of a sampled plant, or how it begins as a series."""
    return _SAMPLED.fullmatch(text) is not None


def is_gain_at_zero(text: str) -> bool | None:
    """Return whether a text is the gain at s = 0, D - C A^-1 B or G(0).

    None of one without the inverse of A and without a transfer function.
    """
    if _OF_INVERSE.match(text):
        return _AT_ZERO.fullmatch(text) is not None
    return _FUNCTION_AT_ZERO.fullmatch(text) is not None if _OF_FUNCTION.search(text) else None
