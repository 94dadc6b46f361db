"""Matrices of a model told by its equations: x1' = x2, x2' = -5x1 - 4x2 + u under A or B, y = 3x1 + x2 under C."""

from __future__ import annotations

import re
import unicodedata

from solver.classroom.reading.brackets import matching, split
from solver.classroom.reading.linear_sums import coefficients, with_plain_indices

_INDEX = r"_?\{?([1-9]?)\}?"
_AT = r"\s*(?:\(t\)|\[t\])?"
_RATE = re.compile(
    rf"\s*(?:d\s*x{_INDEX}{_AT}\s*/\s*d\s*t|d\s*/\s*d\s*t\s*x{_INDEX}{_AT}|x{_INDEX}(?:['′’]|_dot){_AT}"
    rf"|x{_INDEX}\s*[(\[]\s*k\s*\+\s*1\s*[)\]]|x{_INDEX}\s*_?\{{?\s*,?\s*k\s*\+\s*1\}}?)\s*=\s*(.+)",
    re.DOTALL,
)
_DOTTED = re.compile(r"([a-zξ])\u0307(_?\{?[1-9]?\}?)")
_STATE = re.compile(
    r"\s*(?:d\s*|d\s*/\s*dt\s*)?([zqwveξ])_?\{?[1-9]?\}?\s*(?:['′’/]|_dot|[(\[_]\s*\{?\s*k\s*\+)"
    r"|\s*y[^=]*=[^=]*?(?<![A-Za-z])([zqwvξ])_?[1-9]"
)
"""What the states are called, where that is not x."""
_OUTPUT = re.compile(rf"\s*y{_INDEX}\s*(?:\([tk]\)|\[k\]|_k)?\s*=\s*(.+)", re.DOTALL)
_BETWEEN = re.compile(r"\s*[,;\n]\s*(?:and\s+|und\s+)?|\s+(?:and|und)\s+")
_MATRICES = re.compile(r"\s*([-+]?)\s*(?=[\[(])")
_VECTOR = re.compile(r"\s*[*·]?\s*([xu])\s*(?:\([tk]\)|\[k\]|_k)?\s*")
_OF_STATES = ("A", "C", "closed_loop_A", "error_A")
_RATES = ("A", "B", "closed_loop_A", "error_A")
NAMES = ("A", "B", "C", "D", "closed_loop_A", "error_A")
"""Answers that equations of a model tell."""


def matrix_of(text: str, name: str, shape: tuple[int, int]) -> str:
    """Return the matrix of an answer that equations of states or outputs tell; "" of any other text.

    There must be one equation for each row of it.
    """
    text = _with_usual_states(text)
    letter, left = "x" if name in _OF_STATES else "u", _RATE if name in _RATES else _OUTPUT
    height, width = shape
    lines: dict[int, str] = {}
    for piece in split(text, _BETWEEN):
        found = left.fullmatch(piece)
        if found is None:
            if (_OUTPUT if left is _RATE else _RATE).fullmatch(piece):
                continue
            return ""
        *indices, side = found.groups()
        index = next(filter(None, indices), "")
        if not index and (whole := _beside(side, letter)):
            return whole
        row = _row(side, letter, width)
        number = int(index or 1)
        if row is None or number in lines or (not index and height > 1):
            return ""
        lines[number] = f"[{', '.join(row)}]"
    return f"[{', '.join(lines[i] for i in sorted(lines))}]" if sorted(lines) == list(range(1, height + 1)) else ""


def _with_usual_states(text: str) -> str:
    """Equations with x1' for ẋ₁, and x for the states where they are called otherwise."""
    text = _DOTTED.sub(r"\1\2'", unicodedata.normalize("NFD", with_plain_indices(text))).strip()
    called = _STATE.match(text)
    if called is None or re.search(r"(?<![a-z])x", text):
        return text
    return re.sub(
        rf"(?<![A-Za-z\\])(?<!/d\s){called[1] or called[2]}(?![a-z])|(?<=\bd){called[1]}(?=[_\d{{/ ])", "x", text
    )


def _row(side: str, letter: str, width: int) -> list[str] | None:
    """The coefficients of x1, x2, … or of u1, u2, … in a sum of both."""
    named = coefficients(side, "xu")
    if named is None:
        return None
    own = {int(index or 1): value for (of, index), value in named.items() if of == letter}
    unclear = width > 1 and any(of == letter and not index for of, index in named)
    if unclear or len(own) < sum(of == letter for of, _ in named) or max(own, default=0) > width:
        return None
    return [own.get(i, "0") for i in range(1, width + 1)]


def _beside(side: str, letter: str) -> str:
    """The matrix before x, or u, in [0 1; -2 -3] x + [0; 1] u; "" of any other sum."""
    at, found = 0, ""
    while sign := _MATRICES.match(side, at):
        end = matching(side, sign.end()) + 1
        vector = _VECTOR.match(side, end)
        if vector is None:
            return ""
        if vector[1] == letter:
            found = f"{sign[1].strip('+')}{side[sign.end() : end]}"
        at = vector.end()
    return found if at == len(side) else ""
