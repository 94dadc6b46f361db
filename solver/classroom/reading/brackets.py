"""Texts with brackets: where one is closed, pieces between separators, entries of a row, rows of a matrix."""

from __future__ import annotations

import re
from collections.abc import Sequence

OPENING, CLOSING = "([{", ")]}"
_BINARY = "+-*/^±=<>,;&|·×⋅−"
_SIGNS = "+-−±"
_NUMBER = re.compile(r"[+−-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?(?:/\d+)?")
_GOES_ON = re.compile(
    r"(?:(?:±\s*|\S\s+[+−-]\s+)[ijI]|\bwith|multiplicity|vielfachheit|algebraic|(?<![a-z])(?:sin|cos|tan|exp|ln|log|sqrt|sinh|cosh))$",
    re.IGNORECASE,
)
_REMARK = re.compile(
    r"\(?(?:double|twice|triple|doppelt|dreifach|once|simple|einfach|with\b|alg|mult|vielf)|\(\d+\s*(?:x|×|times|fold)",
    re.IGNORECASE,
)
"""What ends without an entry of its own, j in -1 ± j 2, cos in cos 2t, and what belongs to the one before, (double)."""
_ROW = re.compile(r"[;\n]")
_BETWEEN_ROWS = re.compile(r"\s*,\s*|(?<=\])\s*(?=\[)")
_CONTINUED = re.compile(r"\.\.\.[ \t]*\n?|(?<=,)[ \t]*\n")


def matching(text: str, at: int) -> int:
    """Return where the bracket that opens at a place is closed; the end of the text if it never is."""
    depth = 0
    for i in range(at, len(text)):
        depth += (text[i] in OPENING) - (text[i] in CLOSING)
        if depth == 0:
            return i
    return len(text)


def split(text: str, separator: str | re.Pattern[str]) -> list[str]:
    """Return the pieces of a text between separators outside of brackets; none of an empty text."""
    pattern = re.compile(re.escape(separator)) if isinstance(separator, str) else separator
    pieces, start, at = [], 0, 0
    while at < len(text):
        if text[at] in OPENING:
            at = matching(text, at) + 1
        elif found := pattern.match(text, at):
            pieces.append(text[start:at])
            start = at = found.end() if found.end() > at else at + 1
        else:
            at += 1
    return [*pieces, text[start:]] if pieces or text.strip() else []


def enclosed(text: str, brackets: str = "[]") -> bool:
    """Whether the first bracket of a text is of this kind and closed at its end."""
    return text[:1] == brackets[0] and text[-1:] == brackets[1] and matching(text, 0) == len(text) - 1


def closed(text: str) -> str:
    """Return a text with the bracket that is missing at its end, or without the one too many there; "" of any other.

    In a formula a round one may be missing anywhere: 1/(s+1 has no one reading.
    """
    left = [sign for sign in text if sign in OPENING + CLOSING]
    kinds = dict(zip(OPENING, CLOSING, strict=True))
    still: list[str] = []
    for sign in left:
        if sign in OPENING:
            still.append(kinds[sign])
        elif still and still[-1] == sign:
            still.pop()
        else:
            return text.rstrip()[:-1] if not still and text.rstrip().endswith(sign) and sign == left[-1] else ""
    return text + still[0] if len(still) == 1 and still != [")"] else ""


def rows(text: str) -> list[str]:
    """Return what stands between ; and ends of lines, without blank rows; ... or a comma continues a line."""
    return [row for row in split(_CONTINUED.sub(" ", text), _ROW) if row.strip()]


def by_spaces(text: str) -> list[str]:
    """Return the entries of a row without commas, as MATLAB reads it: "1 -2" has two, "1 - 2" and "1 -2*3" one."""
    pieces, start, at = [], 0, 0
    text = text.strip()
    while at < len(text):
        if text[at] in OPENING:
            at = matching(text, at) + 1
        elif text[at].isspace():
            end = at + len(text[at:]) - len(text[at:].lstrip())
            if _separates(text, at, end):
                pieces.append(text[start:at])
                start = end
            at = end
        else:
            at += 1
    return [*pieces, text[start:]] if text else []


def cells(matrix: str) -> list[list[str]]:
    """Return the entries of a matrix in square brackets row by row, of [1 2; 3 4] or [[1, 2], [3, 4]]."""
    inside = matrix.strip()[1:-1].strip()
    lines = rows(inside)
    if len(lines) == 1:
        pieces = [each.strip() for each in split(inside, _BETWEEN_ROWS)]
        lines = [each[1:-1] for each in pieces if enclosed(each)] if all(map(enclosed, pieces)) else lines
    return [[each.strip() for each in (split(line, ",") if "," in line else by_spaces(line))] for line in lines]


def _separates(text: str, at: int, end: int) -> bool:
    """Whether spaces stand between two entries: after no operator, and before none but a sign that has no space."""
    after, following = text[end], text[end + 1 : end + 2]
    if text[at - 1] in _BINARY or _GOES_ON.search(text, max(0, at - 20), at) or _REMARK.match(text, end):
        return False
    if after in CLOSING or (after == "+" and following in "-−/"):
        return False
    return after not in _BINARY or (after in _SIGNS and after != "±" and not following.isspace())


def are_numbers(pieces: Sequence[str]) -> bool:
    """Whether pieces are plain numbers, or lists of their own, which spaces can only separate."""
    return all(_NUMBER.fullmatch(piece) or enclosed(piece) for piece in pieces)
