"""Texts of matrices and vectors put otherwise: factors of vectors, both of a pair, numbered entries, I for eye(n)."""

from __future__ import annotations

import re

import sympy as sp

from solver.classroom.reading.brackets import split

_FACTOR = re.compile(
    r"(?:(?<=[=,;])|^|(?<=\band))\s*(?:[αβγμσtsrabcdk]|lambda|alpha|beta)_?[1-9₁-₉]?\s*[*·]?\s*(?=[(\[]|\\begin)"
)
_VECTOR_OF = re.compile(r"^\s*[xv]\s*=\s*(?=\S*\s*[(\[])")
_TWO = re.compile(r"±|∓|\\pm|\\mp")
_BOTH = re.compile(r"^\s*v_?\{?1\s*[,/]\s*2\}?\s*=\s*")
_IDENTITY = re.compile(r"(?<![\w.)\]])I(?:_?\d)?(?=\s*(?:[-+−]\s*\S|\)|$))")
_OF_SIZE = re.compile(r"(?<![\w.)\]])(?:([IE𝟙𝕀])|(0))(?:_?\{?\(?|_)([1-9₁-₉])(?:\s*[x×,]\s*([1-9₁-₉]))?\)?\}?(?![\w.])")
_ALONE = re.compile(r"(?<![\w.)\]])[E𝟙𝕀]\s*$")
_IDENTITY_FIRST = re.compile(r"(?<![\w.)\]])I\s*[*·]?\s*((?:cos|sin)\s*\([^()]*\))")
_NUMBERED = re.compile(r"^\s*p_?([1-9₁-₉])\s*=\s*([^=]+)$", re.IGNORECASE)
_SUBSCRIPTS = str.maketrans("₁₂₃₄₅₆₇₈₉", "123456789")


def without_factors(text: str) -> str:
    """Return vectors without the letters that they may be multiplied by, x = α [1; 2]."""
    return _FACTOR.sub(" ", _VECTOR_OF.sub("", text))


def both_vectors(text: str) -> str:
    """Return both vectors of v_1,2 = [1; -1 ± 2j]; "" where there is no ±."""
    bare = _BOTH.sub("", text)
    return ", ".join(_signed(bare, upper=upper) for upper in (True, False)) if _TWO.search(text) else ""


def _signed(text: str, *, upper: bool) -> str:
    """A text with the upper or with the lower of its double signs."""
    return _TWO.sub(lambda found: "+-"[(found[0] in ("∓", "\\mp")) == upper], text)


def alike(text: str, ours: sp.MatrixBase) -> str:
    """Return the entries of k1 = k2 = 2, where each has its number; "" of any other text."""
    *names, value = [each.strip() for each in text.translate(_SUBSCRIPTS).split("=")]
    found = [re.fullmatch(r"[A-Za-z]_?(\d)", name) for name in names]
    numbers = sorted(int(match[1]) for match in found if match)
    count = ours.rows * ours.cols
    whole = len(names) > 1 and numbers == list(range(1, count + 1)) and len(found) == count and "," not in value
    return f"[{', '.join([value] * count)}]" if whole else ""


def symmetric(text: str, ours: sp.MatrixBase) -> str:
    """Return the matrix of p1 = …, p2 = …, p3 = …, its entries on and above the diagonal, row by row; "" of others."""
    pieces = split(text.translate(_SUBSCRIPTS).strip(), re.compile(r"\s*[,;\n]\s*"))
    found = [_NUMBERED.match(piece) for piece in pieces]
    named = {int(match[1]): match[2].strip() for match in found if match}
    places = [(i, j) for i in range(ours.rows) for j in range(i, ours.rows)]
    if len(named) != len(pieces) or sorted(named) != list(range(1, len(places) + 1)) or ours.rows < 2:
        return ""
    entries = {place: named[k] for k, place in enumerate(places, 1)}
    rows = [", ".join(entries[min(i, j), max(i, j)] for j in range(ours.rows)) for i in range(ours.rows)]
    return f"[{'; '.join(rows)}]"


def with_named(text: str, ours: sp.MatrixBase) -> str:
    """Return zeros(2, 1) for 0_{2×1}, eye(2) for I_2 or E_2; the zero matrix of our size for 0; else the same text."""
    if text.strip() in ("0", "0.0", "zero", "null"):
        return f"zeros({ours.rows}, {ours.cols})"

    def named(found: re.Match[str]) -> str:
        rows, cols = (each.translate(_SUBSCRIPTS) for each in (found[3], found[4] or found[3]))
        if found[2] and found[0][1].isdigit():  # 02 is a number
            return found[0]
        return f"zeros({rows}, {cols})" if found[2] else f"eye({rows})" if rows == cols else found[0]

    return _OF_SIZE.sub(named, text)


def with_identities(text: str, ours: sp.MatrixBase) -> str:
    """Return a sum of matrices with eye(n) for I or E, of which I stands for j elsewhere."""
    text = _ALONE.sub("I", text)
    return _IDENTITY.sub(f"eye({ours.rows})", _IDENTITY_FIRST.sub(r"\1 I", text))
