"""Spaces told by equations for what lies in them: {x : x1 + 2x2 = 0}, x1 = -2x2 - x3, x1 = x2 = x3."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import enclosed, split
from solver.classroom.reading.linear_sums import Name, coefficients, with_plain_indices

_HEAD = re.compile(
    r"^(?:(?:x|y|v|w|z|\(\s*[a-z]_?\d?(?:\s*[,;]\s*[a-z]_?\d?)+\s*\)(?:\^T|')?)\s*(?:(?:∈|\bin\b)\s*(?:R|ℝ|IR)\s*(?:\^\s*\{?\d\}?|[²³⁴])?)?"
    r"\s*(?::|\||mit|with)\s*|all\s+\w\s+with\s+)"
)
_FREE = re.compile(
    r"\s*(?:[,;(]\s*(?:with\s+|mit\s+|and\s+|und\s+|where\s+)?|\s(?:with|mit|and|und|where|for|für)\s+)(?:[a-z]_?\d?(?:\s*,\s*|\s+and\s+|\s+und\s+))*[a-z]_?\d?\s*"
    r"(?:(?:is|are|ist|sind)?\s*(?:free|frei|beliebig|arbitrary|any)(?:\s+wählbar)?|(?:∈|\bin\b)\s*(?:R|ℝ|IR))\s*\)?\s*\.?$"
)
_BETWEEN = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")
_LETTERS = ("x", "y", "v", "w", "z")
_ORDER = "xyz"
MOST_ENTRIES = 9

Equation = dict[Name, str]


def solved(text: str, size: int) -> str:
    """Return the vector (-2q2 - q3, q2, q3) of all that satisfies x1 + 2x2 + x3 = 0; "" of any other text.

    Equations must say each of some entries by the others, or there is but one.
    """
    bare = with_plain_indices(text).strip()
    bare = bare[1:-1].strip() if enclosed(bare, "{}") else bare
    bare = _FREE.sub("", _HEAD.sub("", bare, count=1))
    sides = [[side.strip() for side in piece.split("=")] for piece in split(bare, _BETWEEN)]
    if not sides or not 1 < size <= MOST_ENTRIES or any(len(each) < 2 for each in sides):
        return ""
    pairs = [(each, last) for *before, last in sides for each in before]
    names = _names(bare, size)
    if not names:
        return ""
    letters = "".join(sorted({of for of, _ in names}))
    found = [(coefficients(left, letters), coefficients(right, letters)) for left, right in pairs]
    equations = [(left, right) for left, right in found if left is not None and right is not None]
    if len(equations) < len(pairs) or any({*left, *right} - set(names) for left, right in equations):
        return ""
    known = _by_others(equations) or _by_first(equations, names)
    if not known:
        return ""
    free = {name: f"q_{i}" for i, name in enumerate(names, 1)}
    entries = [_sum(known[name], free) if name in known else free[name] for name in names]
    return f"({', '.join(entries)})"


def _names(text: str, size: int) -> list[Name]:
    """The names of the entries: x1, x2, … or x, y, z; nothing where they are called otherwise."""
    used = set(re.findall(r"(?<![A-Za-z])([a-z])_?([1-9]?)(?![A-Za-z\d])", text))
    for letter in _LETTERS:
        names = [(letter, str(i)) for i in range(1, size + 1)]
        own = {name for name in used if name[0] == letter}
        if own and own <= set(names):
            return names
    names = [(letter, "") for letter in _ORDER[:size]]
    return names if used & set(names) and size <= len(_ORDER) else []


def _by_others(equations: list[tuple[Equation, Equation]]) -> dict[Name, Equation]:
    """Entries that each equation says by others, x1 = -2x2, which no equation says."""
    known: dict[Name, Equation] = {}
    for left, right in equations:
        if left == right:  # x2 = x2
            continue
        if len(left) != 1 or next(iter(left)) in known:
            return {}
        ((name, factor),) = left.items()
        known[name] = {each: f"({value})/({factor})" for each, value in right.items()}
    return {} if any(set(right) & set(known) for right in known.values()) else known


def _by_first(equations: list[tuple[Equation, Equation]], names: list[Name]) -> dict[Name, Equation]:
    """The first entry of one equation by the others."""
    if len(equations) != 1:
        return {}
    left, right = equations[0]
    whole = {name: f"({left.get(name, '0')}) - ({right.get(name, '0')})" for name in names if {name} & {*left, *right}}
    first = next((name for name in names if name in whole), None)
    if first is None:
        return {}
    return {first: {name: f"-({value})/({whole[first]})" for name, value in whole.items() if name != first}}


def _sum(equation: Equation, letters: dict[Name, str]) -> str:
    return " + ".join(f"({value})*{letters[name]}" for name, value in equation.items()) or "0"
