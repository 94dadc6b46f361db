"""Vectors told by others: v2 = conj(v1), (1, j) and its conjugate, 2e1 + 3e2 of unit vectors."""

from __future__ import annotations

import re

from solver.classroom.reading.brackets import enclosed, matching, split
from solver.classroom.reading.linear_sums import coefficients, with_plain_indices

_VECTOR = re.compile(r"\s*(?:([^\W\d]\w*)\s*[=:]\s*)?(?=[\[(])")
_OTHER = re.compile(
    r"\s*[,;\n]\s*(?:and\s+|und\s+)?([^\W\d]\w*)\s*=\s*(?:(?:conj|konj|conjugate)\s*\(\s*(\w+)\s*\)|(\w+?)\s*(?:\^?\s*\{?\*\}?|\u0304|̄)"
    r"|\\(?:bar|overline)\s*\{?\s*(\w+?)\s*\}?|(\w+)\s+(?:conjugate(?:d)?|konjugiert))\s*\.?"
)
_BEHIND = re.compile(
    r"\s*,?\s*(?:and|und|plus|\+|,)\s*(?:(?:its|the|the corresponding|das|dazu|ihr|deren|der)\s+)?"
    r"(?:complex|komplex)?\s*"
    r"(?:conj(?:ugates?|\.)?|konjugierte?[rs]?|c\.\s?c\.|k\.\s?k\.)(?:\s+(?:vector|vektor|complex|komplex))?\s*\.?",
    re.IGNORECASE,
)
_TURNED = re.compile(r"\s*(?:\^\{?T\}?|ᵀ|'|\^\{\\top\})")
_UNIT = re.compile(r"(?<![A-Za-z\d])([-+(]?)(\d*)([ij])(?![A-Za-z])|(?<=\d)([ij])(?![A-Za-z])")
_NAMED = re.compile(r"^\s*[^\W\d_]_?\d?\s*[=:]\s*")
_SPAN = re.compile(r"^\s*(?:span|lin|LH)\s*(?=[({])", re.IGNORECASE)
_BETWEEN = re.compile(r"\s*[,;\n]\s*|\s+(?:and|und)\s+")
_KIND = re.compile(
    r"\s*\(\s*(?:generali[sz]ed|gen\.|verallgemeinert\w*|hauptvektor|chain|kette)(?:\s+(?:eigenvector|eigenvektor))?\s*\)"
    r"|\s*[,;(]\s*[a-zα-ω]_?\d?\s*(?:≠|!=|\\neq?)\s*0\s*\)?\s*$",
    re.IGNORECASE,
)
_OF_EIGENVALUE = re.compile(r"(?:(?:zu|for|für|to|bei)\s+)?(?:λ|\\lambda)_?\{?([1-9₁-₉])\}?\s*:\s*(?=[(\[])")
_BARRED = re.compile(r"\([^()|,;]+(?:\|[^()|,;]+)+\)")
_BOTH = re.compile(r"\s*(?:v\w*\s*=\s*)?([(\[][^()\[\]]*[)\]])\s*±\s*[ij]\s*[*·]?\s*([(\[][^()\[\]]*[)\]])\s*")
_ENTRIES = re.compile(r"\s*[,;]\s*|\s+")
_MARKED = re.compile(r"(\w)\u0304_?(\d?)")
MOST_ENTRIES = 9


def without_kinds(text: str) -> str:
    """Return vectors without what is said of their kind, e2 (generalized), or of their factors, c ≠ 0.

    Those that are told for λ1 and λ2, whose values stand elsewhere, are v1 and v2.
    """
    return _OF_EIGENVALUE.sub(lambda found: f"v{with_plain_indices(found[1])} = ", _KIND.sub("", text))


def with_commas(text: str) -> str:
    """Return vectors with commas for the bars between their entries, (1|-2)."""
    return _BARRED.sub(lambda found: found[0].replace("|", ","), text)


def with_conjugates(text: str) -> str:
    """Return v1 = [1, j], v2 = [1, -j] of v1 = [1, j], v2 = conj(v1), or of [1, j] and its conjugate; "" of others."""
    text = _MARKED.sub(r"conj(\1\2)", with_plain_indices(text))
    if both := _BOTH.fullmatch(text):
        parts = [[each for each in _ENTRIES.split(part[1:-1].strip()) if each] for part in both.groups()]
        return _of_parts(*parts) if len(parts[0]) == len(parts[1]) else ""
    first = _VECTOR.match(text)
    if first is None:
        return ""
    end = matching(text, first.end()) + 1
    vector = text[first.end() : end]
    if turned := _TURNED.match(text, end):
        end = turned.end()
    told = _BEHIND.fullmatch(text, end)
    if told is None:
        other = _OTHER.fullmatch(text, end)
        of = next((each for each in other.groups()[1:] if each), "") if other else ""
        if other is None or _plain(of) != _plain(first[1] or "") or _plain(other[1]) == _plain(of):
            return ""
    conjugated = _conjugated(vector)
    return f"v1 = {vector}, v2 = {conjugated}" if conjugated != vector else ""


def _of_parts(real: list[str], imaginary: list[str]) -> str:
    """Both vectors of (1, 0) ± j (0, 2)."""
    both = [
        ", ".join(f"({one}) {sign} j*({other})" for one, other in zip(real, imaginary, strict=True)) for sign in "+-"
    ]
    return f"v1 = [{both[0]}], v2 = [{both[1]}]"


def _plain(name: str) -> str:
    return name.replace("_", "")


def _conjugated(vector: str) -> str:
    """A vector of numbers with -j for j."""
    return _UNIT.sub(_opposite, vector)


def _opposite(found: re.Match[str]) -> str:
    if found[4]:
        return "*(-j)"
    return f"{found[1]}{found[2] + '*' if found[2] else ''}(-j)*1"


def of_unit_vectors(text: str, size: int) -> str:
    """Return v1 = [2, 3] of v1 = 2e1 + 3e2, and so of several or of their span; "" of any other text."""
    bare = with_plain_indices(text).strip()
    bare = _SPAN.sub("", bare)
    bare = bare[1:-1] if enclosed(bare, "{}") or enclosed(bare, "()") else bare
    found = [coefficients(_NAMED.sub("", piece), "e") for piece in split(bare, _BETWEEN)]
    vectors = [each for each in found if each]
    if not vectors or len(vectors) < len(found) or size > MOST_ENTRIES:
        return ""
    if any(not index or int(index) > size for each in vectors for _, index in each):
        return ""
    rows = [", ".join(each.get(("e", str(i)), "0") for i in range(1, size + 1)) for each in vectors]
    listed = ", ".join(f"v{i} = [{row}]" for i, row in enumerate(rows, 1))
    return listed if len(rows) > 1 else f"[{rows[0]}]"
