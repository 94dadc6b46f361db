"""Spaces told by all their vectors: (t, 2t), s (-2, 1, 0) + t (-3, 0, 1) with any s and t."""

from __future__ import annotations

import re
from collections.abc import Collection
from typing import Any

import sympy as sp

from solver.classroom.reading.expected import Expected
from solver.problem.expressions.notation import GREEK_NAMES

MOST_LETTERS = 6
_INDEX = re.compile(r"_?\d+$")

Pair = tuple[Any, Any]


def spanned(read: Pair, known: Collection[sp.Symbol], expected: Expected) -> Pair:
    """Return the basis that a vector linear in letters of its own stands for, with its form; any other matrix as it is.

    Only bases of spaces are told so. Its vectors stand in columns, or in rows where these are expected. Each is what
    the vector becomes where one of the letters is one and the others are zero.
    """
    value = read[0]
    if not expected.name.endswith("_space") or 1 not in value.shape:
        return read
    letters = sorted((each for each in value.free_symbols - set(known) if _is_letter(each.name)), key=str)
    if not 0 < len(letters) <= MOST_LETTERS or not _are_linear(value, letters):
        return read
    vectors = [sp.Matrix.vstack(*_values(each, letters)) for each in read]
    value, form = (sp.ImmutableMatrix(each if expected.vectors == "rows" else each.T) for each in vectors)
    return value, form


def _is_letter(name: str) -> bool:
    letter = _INDEX.sub("", name)  # x2 and x_4 of the free unknowns
    return len(letter) == 1 or letter in GREEK_NAMES


def _are_linear(value: Any, letters: list[sp.Symbol]) -> bool:
    """Whether each entry is a sum of multiples of the letters."""
    if not all(entry.is_polynomial(*letters) for entry in value):
        return False
    return all(sum(powers) == 1 for entry in value if entry != 0 for powers in sp.Poly(entry, *letters).monoms())


def _values(vector: Any, letters: list[sp.Symbol]) -> list[Any]:
    """The values of a vector where one letter after the other is one, as rows."""
    row = vector if vector.rows == 1 else vector.T
    return [row.xreplace({each: sp.Integer(each == letter) for each in letters}) for letter in letters]
