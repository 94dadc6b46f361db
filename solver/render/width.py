"""How wide a formula will be, roughly, and where a long one can be broken."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from string import ascii_letters

LINE = 76.0
"""Width, in letters, of what fits on a line of a page."""

_TOKEN = re.compile(r"\\(?:begin|end)\{\w+\*?\}|\\[A-Za-z]+|\\.|\S", re.DOTALL)  # without spaces
_DIGIT = re.compile(r"[0-9]")
_WORDS = {r"\text", r"\operatorname", r"\mathrm", r"\mathbf", r"\mathcal"}
_WIDTHS = {
    **dict.fromkeys((r"\left", r"\right", r"\displaystyle", r"\!", r"\hline", "}"), 0.0),
    **dict.fromkeys(("=", "+", "-", r"\approx", r"\le", r"\ge"), 2.0),
    **dict.fromkeys((r"\det", r"\cos", r"\sin", r"\tan", r"\exp"), 3.0),
    **{r"\quad": 2.0, r"\qquad": 4.0, r"\,": 0.3, r"\;": 0.6, r"\ ": 0.5},
    **dict.fromkeys(ascii_letters + "0()[]|,.", 1.0),
}
"""Of what is not listed and stands alone, 1."""

_SIGNS = re.compile(r"\\(?:begin|left|right|end)\b|\\[{}]|[{}()\[\]]| (?=[+-] )")


def width(tex: str) -> float:
    """Return the width of a formula in letters; the tallest part decides nothing."""
    return _width(_DIGIT.sub("0", tex))


@lru_cache(maxsize=8192)
def _width(tex: str) -> float:
    """Return the width of a formula; all digits are as wide as 0, so that formulas with other numbers are known."""
    return _row(iter(_TOKEN.findall(tex)), None)


def _row(tokens: Iterator[str], end: str | None) -> float:
    total = 0.0
    for piece in tokens:
        if piece == end:
            break
        total += _piece(piece, tokens)
    return total


def _piece(piece: str, tokens: Iterator[str]) -> float:
    known = _WIDTHS.get(piece)
    if known is not None:
        return known
    if piece.startswith(r"\begin{"):
        if piece == r"\begin{array}":
            _argument(tokens)  # its columns
        return _matrix(tokens)
    if piece == r"\frac":
        return max(_argument(tokens), _argument(tokens)) + 0.4
    if piece in {"^", "_"}:
        return 0.7 * _argument(tokens)
    if piece in _WORDS:
        return _argument(tokens)
    return _row(tokens, "}") if piece == "{" else 1.0


def _argument(tokens: Iterator[str]) -> float:
    piece = next(tokens, None)
    return 0.0 if piece is None else _piece(piece, tokens)


def _matrix(tokens: Iterator[str]) -> float:
    columns: list[float] = [0.0]
    column, cell = 0, 0.0
    for piece in tokens:
        known = _WIDTHS.get(piece)
        if known is not None:
            cell += known
        elif piece in {"&", r"\\"} or piece.startswith(r"\end{"):
            columns.extend([0.0] * (column + 1 - len(columns)))
            columns[column] = max(columns[column], cell)
            column, cell = (column + 1 if piece == "&" else 0), 0.0
            if piece.startswith(r"\end{"):
                break
        else:
            cell += _piece(piece, tokens)
    return sum(columns) + 1.6 * len(columns)


def broken(tex: str, room: float = LINE) -> list[str]:
    """Break a long sum before its signs, a long product of matrices before a matrix; a short formula is one line.

    The lines fit into `room` where they can. Each line but the first begins with the sign it was broken at.
    """
    if width(tex) <= room:
        return [tex]
    lines = _filled(_terms(tex), "", room)
    return [piece for line in lines for piece in _filled(line.split(_SEAM), _SEAM, room)]


_SEAM = r"\end{bmatrix}\begin{bmatrix}"


def _filled(pieces: list[str], seam: str, room: float) -> list[str]:
    """Put as many pieces on each line as fit; a seam is what stood between them."""
    end, begin = (r"\end{bmatrix}", r"\begin{bmatrix}") if seam else ("", "")
    lines = [pieces[0]]
    for piece in pieces[1:]:
        if width(lines[-1] + seam + piece) > room:
            lines[-1] += end
            lines.append((r"\cdot " if seam else "") + begin + piece.lstrip())
        else:
            lines[-1] += seam + piece
    return lines


def _terms(tex: str) -> list[str]:
    """Cut a formula before each sign that stands outside of all brackets."""
    depth, start, terms = 0, 0, []
    for match in _SIGNS.finditer(tex):
        piece = match[0]
        if piece == " ":
            if depth == 0:
                terms.append(tex[start : match.start()])
                start = match.start()
        elif piece in {r"\begin", r"\left", "{", "(", "[", r"\{"}:
            depth += 1
        else:
            depth -= 1
    return [*terms, tex[start:]]
