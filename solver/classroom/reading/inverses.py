"""Inverses and powers of matrices that are written out: [1 1; 0 2]^-1, inv([1 1; 0 2]), [0 1; -2 -3]^3.

An inverse is written out by Cramer's rule, up to three rows; a power as a product.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import cells, matching

_POWER = re.compile(r"\s*(?:\^|\*\*)\s*(?:[({]\s*([-−]?\s*\d)\s*[)}]|([-−]?\d)(?![\w.]))|\s*(⁻¹|[²³])")
_CALL = re.compile(r"(?:\w+\.)*(?:inv|Inverse|inverse)\s*[(\[]\s*(?=\[)")
_OVER = re.compile(r"(?<=[\])])\s*/\s*(?=\[)")
_RAISED = {"⁻¹": -1, "²": 2, "³": 3}
MOST_ROWS = 3
MOST_FACTORS = 5
MOST_CHARACTERS = 1500

Cells = Sequence[Sequence[str]]


def with_inverses(text: str) -> str:
    """Return a text with its inverses and powers of matrices written out; "" where there are none, or one is too large.

    A matrix behind / is the inverse that a factor is multiplied by from the right.
    """
    if "[" not in text or len(text) > MOST_CHARACTERS:
        return ""
    raised = _with_powers(_OVER, _with_powers(_CALL, text))
    found, at = False, 0
    while (start := raised.find("[", at)) >= 0:
        at = matching(raised, start) + 1
        if (power := _POWER.match(raised, at)) is None:
            continue
        exponent = _RAISED.get(power[3] or "") or int((power[1] or power[2]).replace("−", "-").replace(" ", ""))
        written = _written(raised[start:at], exponent)
        if not written:
            return ""
        found, raised = True, f"{raised[:start]}{written}{raised[power.end() :]}"
        at = start + len(written)
    return raised if found and len(raised) <= 2 * MOST_CHARACTERS else ""


def _with_powers(before: re.Pattern[str], text: str) -> str:
    """A text with inv([1 2; 3 4]), or / [1 2; 3 4], as [1 2; 3 4]^-1, a factor."""
    at = 0
    while found := before.search(text, at):
        end = matching(text, found.end()) + 1
        rest = text[end:].lstrip()
        if before is _CALL and not rest.startswith((")", "]")):
            at = found.end()
            continue
        factor = "*" if before is _OVER else ""
        text = f"{text[: found.start()]}{factor}{text[found.end() : end]}^-1{rest[1:] if before is _CALL else rest}"
        at = found.start() + 1
    return text


def _written(matrix: str, exponent: int) -> str:
    """A power of a square matrix; "" of one that is not square, or too large."""
    lines = cells(matrix)
    if not lines or any(len(line) != len(lines) for line in lines):
        return ""
    if 1 < exponent <= MOST_FACTORS:
        return "*".join([matrix] * exponent)
    return _in_brackets(_inverse(lines)) if exponent == -1 and len(lines) <= MOST_ROWS else ""


def _inverse(lines: Cells) -> Cells:
    """The adjugate over the determinant, entry by entry."""
    places = range(len(lines))
    determinant = _determinant(lines)
    return [
        [f"({'-' if (i + j) % 2 else ''}({_determinant(_minor(lines, j, i))}))/({determinant})" for j in places]
        for i in places
    ]


def _determinant(lines: Cells) -> str:
    """The determinant by its first row; 1 of no rows."""
    if not lines:
        return "1"
    terms = (f"({entry})*({_determinant(_minor(lines, 0, j))})" for j, entry in enumerate(lines[0]))
    return " ".join(f"{'-' if j % 2 else '+'} {term}" for j, term in enumerate(terms)).removeprefix("+ ")


def _minor(lines: Cells, row: int, column: int) -> Cells:
    return [[entry for j, entry in enumerate(line) if j != column] for i, line in enumerate(lines) if i != row]


def _in_brackets(lines: Cells) -> str:
    return f"[{'; '.join(', '.join(line) for line in lines)}]"
