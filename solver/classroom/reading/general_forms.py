"""Sides of equations that say in general what a side behind them says with numbers.

`A/(s + 1) + B/(s + 3) = 2/(s + 1) + 1/(s + 3)`, `λ^2 - tr(A) λ + det(A) = λ^2 - 5λ - 2`, `G_0/(1 + G_0) = …`.
"""

from __future__ import annotations

import re

from solver.classroom.reading.labels import Labels

_LOOP = re.compile(r"([A-Z]\w*(?:\s*[*·]?\s*[A-Z]\w*)*)(?:\([sz]\))?\s*/\s*\(\s*1\s*\+\s*\1(?:\([sz]\))?\s*\)")
_FOUND_BY = re.compile(r"\b(?:tr|trace|sp|spur|det)\s*\(?\s*A\b|\bd\s*/\s*d\s*[sz]\b|[∂∫∑Σ…]|\.{3}", re.IGNORECASE)
_NAMES = re.compile(r"(?<![^\W_\d])[^\W\d_][^\W_]*(?:_\w+)?")
CONSTANT = re.compile(r"(?:[A-F]|[ABCKRckr]_?\d|[αaΔ]_?\d|Delta_?\d)(?=[e-z]?$)")
"""Names of the constants of partial fractions and of general solutions."""


def is_general(side: str, labels: Labels) -> bool:
    """Whether a side has constants in place of numbers, invariants or derivatives, or is a loop that is closed."""
    if (loop := _LOOP.fullmatch(side)) and (len(loop[1]) > 1 or labels.is_of_others(side)):
        return True
    constants = [name for name in _NAMES.findall(side) if CONSTANT.match(name)]
    return labels.is_of_others(side) and (len(constants) > 1 or _FOUND_BY.search(side) is not None)
