"""Matrices as programs print them, in our brackets: ⎡1 2⎤ of sympy, [1,] of R, 2×2 Matrix{Float64}: of Julia, | 1 2 |.

What a row holds is told by its spaces, of which some programs set two between entries ("- 1  2" has two), so the shape
that is asked for decides. Lines that YAML has joined are told apart by what stands between rows.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import are_numbers, by_spaces, enclosed, split

Shape = tuple[int, int]

_PROMPT = re.compile(
    r"^\s*(?:>>>?|julia>|R?>|sage:|octave:\d+>|In\s?\[\d+\]\s*:=?|Out\s?\[\d+\]\s*(?:/\w+=|[:=])|\(?%[io]\d+\)?)\s*"
)
_LABEL = re.compile(r"\s*[^\W\d]\w*\s*=\s*")
_SCALE = re.compile(r"\s*(\d(?:\.\d+)?e[-+]\d{2,3})\s*\*\s*(?=[^\s\[])")
"""The factor that MATLAB sets above a matrix."""
_ECHO = re.compile(r"[^\W\d]\w*;?|.*\(.*\);?")
"""What is typed at a prompt: a name or a call, whose value stands below."""
_JULIA = re.compile(
    r"^\s*(\d{1,2})(?:[×x](\d{1,2})|-element)\s+[\w.{}]*(?:Matrix|Array|Vector|Adjoint|Transpose|Symmetric)\b[^:\n]*:\s*"
)
_COLUMNS_OF_R = re.compile(r"^\s*(?:\[,\d{1,2}\]\s*)+")
_ROW_OF_R = re.compile(r"\[(\d{1,2}),\]\s*")
_VECTOR_OF_R = re.compile(r"^\s*\[1\]\s+(?=[-+.\d])")
_LEFT, _RIGHT = "⎡⎢⎣⎛⎜⎝⎧⎨⎩┌└", "⎤⎥⎦⎞⎟⎠⎫⎬⎭┐┘"
_BETWEEN = re.compile(rf"[{_RIGHT}]\s*[{_LEFT}]|│\s*\n?\s*│")
_BRACKETS = re.compile(rf"[{_LEFT}{_RIGHT}│⎪]")
_BARS = re.compile(r"\s*\|\s*([^|].*?)\s*\|\s*", re.DOTALL)
_RULE = re.compile(r"\|[ :|-]*-[ :|-]*\|[ \t]*(?:\n|$)")
_BETWEEN_BARS = re.compile(r"\|\s*\n\s*\||\|\s+\|")
_BAR = re.compile(r"\s*\|\s*")
_NAMED = re.compile(
    r"[,;.]?\s*(?:\b(row|zeile|line|column|col|spalte)\s*\(?\d\)?|\b(?:\d(?:st|nd|rd|th|\.|te)|first|second|third|fourth|"
    r"(?:erste|zweite|dritte|vierte)[nrs]?)[ ]*(row|zeile|line|column|spalte))\s*[:=]?\s*",
    re.IGNORECASE,
)
_OF_COLUMNS = ("column", "col", "spalte")
_TWO_SPACES = re.compile(r"\s{2,}")
MOST_CHARACTERS = 4000


def in_rows(text: str, shape: Shape) -> str:
    """Return a printed matrix of a shape as [a, b; c, d]; "" of any other text, or where its rows have not that shape.

    A vector may be printed as a row or as a column.
    """
    if len(text) > MOST_CHARACTERS:
        return ""
    bare = without_prompt(text)
    label = found[0] if (found := _LABEL.match(bare)) else ""
    if scale := _SCALE.match(bare, len(label)):
        return f"{label}{scale[1]}*[{bare[scale.end() :].strip()}]"
    for read in (_of_julia, _of_r, _of_brackets, _of_bars, _of_names, _of_lines, _between_bars, _of_one_line):
        if rows := read(bare.removeprefix(label), shape):
            return label + rows
    return "" if bare == text else bare


def without_prompt(text: str) -> str:
    """Return what a program answered, without its prompt and what was typed behind it."""
    lines = [line for line in text.split("\n") if line.strip()]
    if not lines or not _PROMPT.match(lines[0]):
        return text
    first = _PROMPT.sub("", lines[0], count=1)
    return "\n".join(lines[1:] if len(lines) > 1 and _ECHO.fullmatch(first.strip()) else [first, *lines[1:]])


def _of_julia(text: str, shape: Shape) -> str:
    found = _JULIA.match(text)
    if found is None:
        return ""
    own = (int(found[1]), int(found[2] or 1))
    lines = _lines(text[found.end() :])
    if len(lines) == 1:
        entries = by_spaces(lines[0])
        lines = [" ".join(entries[at : at + own[1]]) for at in range(0, len(entries), own[1])]
    return _joined(lines, own) if own in (shape, shape[::-1]) and (1 in own or own == shape) else ""


def _of_r(text: str, shape: Shape) -> str:
    """Rows that are numbered [1,], [2,] below the columns [,1] [,2]; a vector begins with [1]."""
    lines = _lines(text)
    if lines and _ECHO.fullmatch(lines[0]) and len(lines) > 1:
        text = "\n".join(lines[1:])
    if found := _COLUMNS_OF_R.match(text):
        pieces = _ROW_OF_R.split(text[found.end() :])
        return _joined([each.strip() for each in pieces[2::2]], shape)
    return _joined([text[found.end() :].strip()], shape) if (found := _VECTOR_OF_R.match(text)) else ""


def _of_brackets(text: str, shape: Shape) -> str:
    """Rows between brackets that are drawn over several lines."""
    if not _BRACKETS.search(text):
        return ""
    return _joined(_lines(_BRACKETS.sub(" ", _BETWEEN.sub("\n", text))), shape)


def _of_bars(text: str, shape: Shape) -> str:
    """Rows or one row between bars, with or without bars between their entries."""
    found = _BARS.fullmatch(_RULE.sub("", text))
    if found is None:
        return ""
    rows = [_BAR.sub(", ", row) for line in _BETWEEN_BARS.split(found[1]) for row in line.split(";")]
    return _joined(rows, shape) or _joined([", ".join(rows)], shape)


def _of_names(text: str, shape: Shape) -> str:
    """Row 1: (1, 2), row 2: (3, 4), or columns."""
    names = list(_NAMED.finditer(text))
    if not names or text[: names[0].start()].strip(" ,;[("):
        return ""
    kinds = {(each[1] or each[2]).lower() in _OF_COLUMNS for each in names}
    ends = [*(each.start() for each in names[1:]), len(text)]
    pieces = [text[each.end() : end].strip(" ,;.\n") for each, end in zip(names, ends, strict=True)]
    bare = [each[1:-1].replace(";", ", ") if enclosed(each, "()") or enclosed(each) else each for each in pieces]
    if kinds == {True}:
        columns = _joined(bare, shape[::-1])
        return f"{columns}'" if columns else ""
    return _joined(bare, shape) if kinds == {False} else ""


def _of_lines(text: str, shape: Shape) -> str:
    """Lines of which each holds a row, whose entries end with a semicolon, as in tables of numbers."""
    lines = [line.rstrip(";") for line in _lines(text)]
    if len(lines) < 2 or not all(";" in line for line in lines) or any(sign in text for sign in "[]{}="):
        return ""
    return _in_brackets([[each.strip() for each in line.split(";")] for line in lines], shape)


def _between_bars(text: str, shape: Shape) -> str:
    """Rows between bars within brackets, [1 2 | 3 4]."""
    text = text.strip()
    if "|" not in text or not (enclosed(text) or enclosed(text, "()")):
        return ""
    return _joined(text[1:-1].split("|"), shape)


def _of_one_line(text: str, shape: Shape) -> str:
    """The entries of all rows one behind the other, with nothing between the rows."""
    if 1 in shape or any(sign in text for sign in "[]{};=\n") or enclosed(text.strip(), "()"):
        return ""
    entries = split(text, ",") if "," in text else by_spaces(text)
    if len(entries) != shape[0] * shape[1] or len(entries) < 2:
        return ""
    return _joined([", ".join(entries[at : at + shape[1]]) for at in range(0, len(entries), shape[1])], shape)


def _lines(text: str) -> list[str]:
    return [line.strip() for line in text.split("\n") if line.strip()]


def _joined(lines: Sequence[str], shape: Shape) -> str:
    """The rows in our brackets, however their entries are told apart, if they have the shape; "" else."""
    ways = (_by_commas, lambda line: _TWO_SPACES.split(line.strip()), by_spaces)
    return next(filter(None, (_in_brackets(list(map(way, lines)), shape) for way in ways)), "")


def _by_commas(line: str) -> list[str]:
    """The entries between commas; none where numbers stand beside each other, and the commas are decimal ones."""
    pieces = [each.strip() for each in split(line, ",")]
    return [] if any(len(several := by_spaces(each)) > 1 and are_numbers(several) for each in pieces) else pieces


def _in_brackets(rows: Sequence[Sequence[str]], shape: Shape) -> str:
    """The rows in our brackets, if they have the shape, or are a row or a column of its length; "" else."""
    shapes = (shape, shape[::-1]) if 1 in shape else (shape,)
    whole = bool(rows) and all(len(row) == len(rows[0]) and all(row) for row in rows)
    if not whole or (len(rows), len(rows[0])) not in shapes or shape == (1, 1):
        return ""
    return f"[{'; '.join(', '.join(row) for row in rows)}]"
