"""Eigenvalues with eigenvectors as programs print both: MATLAB's V and D, numpy's tuple of arrays, sympy, Mathematica.

MATLAB and numpy print the vectors as columns, Mathematica as rows, sympy one by one.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import by_spaces, cells, enclosed, split

_BLOCK = re.compile(r"(?<!\w)(?:\[\s*[A-Z]\s*,\s*[A-Z]\s*\]\s*=\s*eig\([^()]*\);?)?\s*([VDTΛJS])\s*=\s*")
_ARRAYS = re.compile(
    r"(?:EigResult)?\(\s*(?:eigenvalues=)?\s*(?:np\.)?array\(\s*(\[[^\[\]]*\])[^\[\]]*\)\s*,\s*(?:eigenvectors=)?"
    r"\s*(?:np\.)?(?:array|matrix)\(\s*(\[\s*\[.*\]\s*\])[^\[\]]*\)\s*\)",
    re.DOTALL,
)
_DIAGONAL = re.compile(r"diag\(\s*\[?(.*?)\]?\s*\)")
_MATRIX = re.compile(r"^(?:\w+\.)*(?:Immutable)?(?:Dense)?Matrix\s*\((.*)\)$", re.DOTALL)
_VALUES = "DΛJ"

Pair = tuple[str, str]
"""An eigenvalue and its vector, [1, 2]."""


def printed_pairs(text: str) -> list[Pair]:
    """Return eigenvalues with their vectors as a program printed both; nothing of any other text."""
    for read in (_of_blocks, _of_arrays, _of_triples, _of_lists):
        if pairs := read(text):
            return pairs
    return []


def _of_blocks(text: str) -> list[Pair]:
    """V = [1 1; 1 -2], D = diag(5, 2), or with lines."""
    found = list(_BLOCK.finditer(text))
    if len(found) != 2 or text[: found[0].start()].strip():
        return []
    ends = [found[1].start(), len(text)]
    blocks = {each[1]: text[each.end() : end].strip(" ,;\n") for each, end in zip(found, ends, strict=True)}
    values = [name for name in blocks if name in _VALUES]
    if len(values) != 1 or len(blocks) != 2:
        return []
    (vectors,) = (name for name in blocks if name not in _VALUES)
    return _columns(_diagonal(blocks[values[0]]), _grid(blocks[vectors]))


def _of_arrays(text: str) -> list[Pair]:
    found = _ARRAYS.fullmatch(text)
    return _columns([each.strip() for each in split(found[1][1:-1], ",")], cells(found[2])) if found else []


def _of_triples(text: str) -> list[Pair]:
    """[(-1, 1, [Matrix([[1], [-1]])]), …]: eigenvalues, multiplicities, vectors."""
    pairs = list[Pair]()
    for piece in split(text[1:-1] if enclosed(text) else text, ","):
        bare = piece.strip()
        parts = [each.strip() for each in split(bare[1:-1], ",")] if enclosed(bare, "()") else []
        if len(parts) != 3 or not parts[1].isdigit() or not enclosed(parts[2]):
            return []
        for each in split(parts[2][1:-1], ","):
            inside = found[1].strip() if (found := _MATRIX.match(each.strip())) else ""
            if not enclosed(inside):
                return []
            pairs.append((parts[0], f"[{'; '.join(entry for line in cells(inside) for entry in line)}]"))
    return pairs


def _of_lists(text: str) -> list[Pair]:
    """{{5, 2}, {{1, 1}, {-1, 2}}}: the eigenvalues, then their vectors one by one."""
    parts = [each.strip() for each in split(text[1:-1], ",")] if enclosed(text, "{}") else []
    if len(parts) != 2 or not all(enclosed(each, "{}") for each in parts):
        return []
    values, vectors = ([each.strip() for each in split(part[1:-1], ",")] for part in parts)
    whole = len(values) == len(vectors) and all(enclosed(each, "{}") for each in vectors)
    plain = not any("{" in each for each in values)
    return [(value, f"[{each[1:-1]}]") for value, each in zip(values, vectors, strict=True)] if whole and plain else []


def _columns(values: Sequence[str], grid: Sequence[Sequence[str]]) -> list[Pair]:
    """The columns of a square matrix with their eigenvalues."""
    if not values or len(grid) != len(values) or any(len(line) != len(values) for line in grid):
        return []
    return [(value, f"[{'; '.join(line[j] for line in grid)}]") for j, value in enumerate(values)]


def _grid(text: str) -> list[list[str]]:
    """The entries of a matrix in brackets, or in lines."""
    if enclosed(text):
        return cells(text)
    return [by_spaces(line) for line in text.split("\n") if line.strip()]


def _diagonal(text: str) -> list[str]:
    """What stands on the diagonal of a matrix; nothing where anything stands beside it."""
    if found := _DIAGONAL.fullmatch(text):
        return [each.strip() for each in split(found[1], ",")]
    grid = _grid(text)
    zero = all(
        entry in ("0", "-0", "0.0000", "0.") for i, line in enumerate(grid) for j, entry in enumerate(line) if i != j
    )
    square = all(len(line) == len(grid) for line in grid)
    return [line[i] for i, line in enumerate(grid)] if square and zero else []
