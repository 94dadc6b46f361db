"""Eigenvectors told with the eigenvalues they belong to: λ = -1: (1, -1); v(-1) = (1, -1); (1, -1) for λ = -1.

What a text says is a sequence of eigenvalues and vectors. Either each eigenvalue stands before its vectors, or behind
its one vector. The eigenvalues are kept: a vector that is told for another one than its own is wrong.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from solver.classroom.reading.brackets import enclosed, matching, split

_VALUE = r"[-+−±\d./√()*\sijI^πe]|sqrt"
_LAMBDA = r"(?:\\?lam(?:b?d)a|λ|μ|s|z|p)"
_INDEX = r"_?\{?[\d₁-₉]*(?:\s*[,/]\s*\d)?\}?"
_SEPARATOR = re.compile(
    r"\s*(?P<told>:(?!=)|→|->|⇒|=>|⟹|↦|\|->)\s*|\s*[,;\n]\s*|\s+(?:and|und)\s+"
    r"|(?<=[\s)\]}'ᵀT])(?:for|für|zu|zum|bei|to|with|mit|hat|has|belongs to|gehört zu)\s+"
)
_WORDS = re.compile(
    r"^(?:(?:for|für|zu|zum|bei|to|with|mit|the|der|die|hat|has|an|ein|eigen-?vectors?|eigen-?vektor(?:en)?|EV|vector|vektor"
    r"|eigen-?space|eigenraum|basis)\b\.?\s*(?:is|ist|=)?\s*)+",
    re.IGNORECASE,
)
_EIGENVALUE = re.compile(
    rf"(?:(?:eigenvalue|eigenwert|EW|root)\s*(?:{_LAMBDA}{_INDEX}\s*=)?|{_LAMBDA}{_INDEX}\s*=)\s*((?:{_VALUE})+)",
    re.IGNORECASE,
)
_BARE = re.compile(rf"(?:{_VALUE})+")
_ARGUMENT = re.compile(
    rf"(?:v|w|x|u|q|E|V|N|Eig|eig|ker)\s*_?\s*[({{]\s*(?:A\s*[,;]\s*)?(?:{_LAMBDA}\s*=)?\s*((?:{_VALUE})+?)\s*[)}}]\s*[:=]\s*"
)
_NAMED = re.compile(rf"\\?[^\W\d_]\w{{0,3}}?{_INDEX}\s*(?::=|=)\s*(?=\S)")
_SPAN = re.compile(r"(?:span|lin|LH)\s*(?=[({\[<])", re.IGNORECASE)
_MAKER = re.compile(r"^(?:\w+\.)*(?:Immutable)?(?:Dense)?(?:[Mm]atrix|n?d?array)\s*\((.*)\)$", re.DOTALL)
_TURNED = re.compile(r"\s*(?:\.?['’′]|\^\{?\(?\s*(?:T|\\top)\s*\)?\}?|ᵀ|\.T|\^⊤)$")
_BEHIND = re.compile(rf"\s*\(\s*((?:{_LAMBDA}{_INDEX}\s*=|eigenvalue|eigenwert|EW)[^()]*)\)$", re.IGNORECASE)
_SIGNS = re.compile(r"[±∓]|\\pm|\\mp")
MOST_VECTORS = 12
MAX_CHARACTERS = 2000

Item = tuple[str, str]
"""An eigenvalue ("value") or a vector ("vector") with its text."""


def eigenpairs(text: str) -> list[Item]:
    """Return eigenvalues with their eigenvectors, as texts, an eigenvalue as often as it has vectors.

    Nothing of a text that holds anything else.
    """
    if len(text) > MAX_CHARACTERS:
        return []
    inside = text.strip()
    if enclosed(inside, "{}") or enclosed(inside):
        inside = inside[1:-1]
    items = _triples(inside) or list(_items(inside))
    if not items or any(kind == "" for kind, _ in items):
        return []
    pairs = _paired(items)
    return [each for pair in pairs for each in _both(*pair)] if 0 < len(pairs) <= MOST_VECTORS else []


def _items(text: str) -> Iterator[Item]:
    """What the pieces of a text say; an item without a kind where one says neither."""
    pieces, at = list[tuple[str, bool]](), 0
    for end, start, told in _cuts(text):
        pieces.append((text[at:end], told))
        at = start
    for piece, told in [*pieces, (text[at:], False)]:
        if piece.strip(" ."):
            yield from _said(_WORDS.sub("", piece.strip(" .")), told=told)


def _cuts(text: str) -> Iterator[tuple[int, int, bool]]:
    """Where pieces end and begin outside of brackets, and whether a colon or an arrow stands there."""
    at = 0
    while at < len(text):
        if text[at] in "([{":
            at = matching(text, at) + 1
        elif found := _SEPARATOR.match(text, at):
            yield at, found.end(), found["told"] is not None
            at = max(found.end(), at + 1)
        else:
            at += 1


def _said(piece: str, *, told: bool) -> Iterator[Item]:
    """The eigenvalue or the vectors of a piece, or both."""
    if behind := _BEHIND.search(piece):
        yield from _said(piece[: behind.start()], told=False)
        piece = behind[1]
    if found := _ARGUMENT.match(piece):
        yield "value", found[1].strip()
        piece = piece[found.end() :]
    if found := _EIGENVALUE.fullmatch(piece):
        yield "value", found[1].strip()
    elif told and _BARE.fullmatch(piece) and any(map(str.isdigit, piece)):
        yield "value", piece.strip()
    else:
        vectors = _vectors(piece)
        yield from (("vector", each) for each in vectors) if vectors else [("", piece)]


def _vectors(piece: str) -> list[str]:
    """The vectors of a piece, each in square brackets; nothing of anything else."""
    bare = piece.strip()
    if found := _NAMED.match(bare):
        bare = _WORDS.sub("", bare[found.end() :])
    if found := _SPAN.match(bare):
        bare = bare[found.end() :].strip()
        inside = [each.strip() for each in split(bare[1:-1], ",")]
        if inside and all(each[:1] in ("(", "[", "{") for each in inside):
            return [vector for each in inside for vector in _vectors(each)]
    bare = _TURNED.sub("", bare)
    if found := _MAKER.match(bare):
        bare = found[1].strip()
    while enclosed(bare) and enclosed(bare[1:-1].strip()):
        bare = bare[1:-1].strip()
    if bare[:1] not in ("(", "[", "{") or matching(bare, 0) != len(bare) - 1:
        return []
    several = len(split(bare[1:-1], re.compile(r"[,;]|(?<=\S)\s+(?=\S)|\n"))) > 1
    return [f"[{bare[1:-1]}]"] if several else []


def _triples(text: str) -> list[Item]:
    """The items of (-1, 1, [Matrix([[1], [-1]])]), … as sympy lists eigenvalues, multiplicities and vectors."""
    found = list[Item]()
    for piece in split(text, ","):
        bare = piece.strip()
        parts = [each.strip() for each in split(bare[1:-1], ",")] if enclosed(bare, "()") else []
        if len(parts) != 3 or not parts[1].isdigit() or not enclosed(parts[2]):
            return []
        vectors = [vector for each in split(parts[2][1:-1], ",") for vector in _vectors(each)]
        found += [("value", parts[0]), *(("vector", each) for each in vectors)]
    return found


def _paired(items: Sequence[Item]) -> list[tuple[str, str]]:
    """Eigenvalues with their vectors: behind the eigenvalue, or before it where a vector comes first."""
    texts = [text for _, text in items]
    is_value = [kind == "value" for kind, _ in items]
    if not is_value[0]:  # (1, -1) for λ = -1
        alternating = len(items) % 2 == 0 and all(each == (i % 2 == 1) for i, each in enumerate(is_value))
        return list(zip(texts[1::2], texts[::2], strict=True)) if alternating else []
    pairs, value, last = list[tuple[str, str]](), "", True
    for text, here in zip(texts, is_value, strict=True):
        if here and last and value:
            return []  # an eigenvalue without a vector
        if here:
            value = text
        else:
            pairs.append((value, text))
        last = here
    return [] if last else pairs


def _both(value: str, vector: str) -> list[tuple[str, str]]:
    """A pair; both of λ = -1 ± 2j: (1, -1 ± 2j)."""
    if not _SIGNS.search(value):
        return [(value, vector)]
    return [(_signed(value, upper), _signed(vector, upper)) for upper in (True, False)]


def _signed(text: str, upper: bool) -> str:
    return _SIGNS.sub(lambda found: "+-"[(found[0] in ("∓", "\\mp")) == upper], text)
