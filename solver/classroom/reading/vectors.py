"""Lists of vectors as text: v1 = (1, -1), v2 = (1, -2); span{(1, -1)}, span{(1, -2)}; (1, -1)^T, (1, -2)^T."""

from __future__ import annotations

import re
from collections.abc import Sequence

from solver.classroom.reading.brackets import enclosed, matching, split
from solver.classroom.reading.nodes import flat
from solver.problem.nodes import Node, ScalarNode, SequenceNode

_BETWEEN = re.compile(r"\s*[,;\n]\s*|(?<=[)\]}'ᵀT])\s+(?=[(\[sS])")
_NAMED = re.compile(r"\\?[^\W\d][\w^{}()]*\s*(?::=|=|:)\s*")
_FACTOR = re.compile(r"[-+−]?\s*(?:[\d./√]|sqrt\s*\(?\d+\)?)[\d./√\s]*(?:sqrt\s*\(?\d+\)?)?\s*[*·]?\s*(?=[(\[])")
_SPAN = re.compile(r"(?:span|Span|lin|LH)\s*(?=[({\[])")
_TURNED = re.compile(r"\s*(?:\.?['’′]|\^\(?\s*T\s*\)?|ᵀ|\^%T|\.T|\^⊤)$")


def pieces_of(text: str) -> tuple[list[str], bool] | None:
    """Return the vectors that a text lists, each in brackets of its own, and whether it can mean nothing else.

    What stands in square brackets without names may be the rows of a matrix as well. None of any other text.
    """
    text = text.strip()
    inside = text[1:-1].strip() if enclosed(text, "{}") or enclosed(text) else text
    pieces = [piece.strip() for piece in split(inside, _BETWEEN)]
    found = [_vector(piece) for piece in pieces]
    if len(pieces) < 2 or None in found:
        return None
    vectors = [each for each in found if each is not None]
    bare = any(not said for _, said in vectors)
    if bare and inside != text and not text.startswith("{"):
        return None  # [[1, 2], [3, 4]] and [(1, 2), (3, 4)] are matrices
    return [each for each, _ in vectors], not bare


def _vector(text: str) -> tuple[str, bool] | None:
    """The vector in a piece, and whether it says that it is one: by a name, round brackets, a span, a transposition."""
    bare = _NAMED.sub("", text, count=1) if _NAMED.match(text) else text
    said = bare != text
    while _SPAN.match(bare):
        bare, said = _SPAN.sub("", bare, count=1), True
        bare = bare[1:-1].strip() if bare.startswith("{") and enclosed(bare, "{}") else bare
    if turned := _TURNED.search(bare):
        bare, said = bare[: turned.start()].strip(), True
    factor = found[0].strip() if (found := _FACTOR.match(bare)) else ""
    bare = bare[found.end() :] if found else bare
    if bare[:1] not in ("(", "[", "{") or matching(bare, 0) != len(bare) - 1:
        return None
    scaled = f"{factor.rstrip('*·')}*[{bare[1:-1]}]" if factor else bare
    return scaled, said or bare.startswith("(")


def beside(vectors: Sequence[Node], *, in_rows: bool) -> SequenceNode | None:
    """Return the matrix of vectors, in its rows or its columns; None where they are none, or of different lengths."""
    entries = [flat(each.items) if isinstance(each, SequenceNode) else [] for each in vectors]
    plain = all(isinstance(entry, ScalarNode) for each in entries for entry in each)
    if not plain or len({len(each) for each in entries}) != 1 or len(entries[0]) < 2:
        return None
    lines = entries if in_rows else zip(*entries, strict=True)
    return SequenceNode(vectors[0].place, tuple(SequenceNode(vectors[0].place, tuple(line)) for line in lines))
