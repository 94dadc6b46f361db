"""Eigenvectors told with the eigenvalues they belong to: λ = -1: (1, -1); v(-1) = (1, -1); (1, -1) for λ = -1.

What a text says is a sequence of eigenvalues and vectors. Either each eigenvalue stands before its vectors, or behind
its one vector. The eigenvalues are kept: a vector that is told for another one than its own is wrong. What programs
print of both is in `printed_pairs`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from solver.classroom.reading.brackets import enclosed, matching, split
from solver.classroom.reading.linear_sums import coefficients, with_plain_indices
from solver.classroom.reading.printed_pairs import Pair, printed_pairs
from solver.classroom.reading.vectors_told import of_unit_vectors

_VALUE = r"[-+−±\d./√()*\sijI^πe]|sqrt"
_LAMBDA = r"(?:\\?lam(?:b?d)a|λ|μ|s|z|p)"
_INDEX = r"_?\{?-?[\d]*(?:\s*[,/]\s*\d)?\}?"
_SEPARATOR = re.compile(
    r"\s*(?P<told>:(?!=)|→|->|⇒|=>|⟹|↦|\|->)\s*|\s*[,;\n]\s*|\s+(?:and|und)\s+"
    r"|\s+(?P<says>gives|yields|is|has|liefert|ergibt|ist|hat)\s+(?:the\s+|den\s+)?"
    r"|(?<=[\s)\]}'ᵀT])(?P<of>for|für|zu|zum|bei|belongs to|gehört zu)\s+|(?<=[\s)\]}'ᵀT])(?:to|with|mit)\s+"
)
_WORDS = re.compile(
    r"^(?:(?:for|für|zu|zum|bei|to|with|mit|the|der|die|den|an|ein|eigen-?vectors?|eigen-?vektor(?:en)?|EV|vector|vektor"
    r"|eigen-?space|eigenraum|basis|generali[sz]ed|verallgemeinert\w*|hauptvektor)\b\.?\s*=?\s*)+",
    re.IGNORECASE,
)
_EIGENVALUE = re.compile(
    rf"(?:(?:eigenvalue|eigenwert|EW|root)\s*(?:({_LAMBDA}{_INDEX})\s*=)?|({_LAMBDA}{_INDEX})\s*=)"
    r"\s*([-+−±\d./√()*\sI^πa-zα-ω_]+)",
    re.IGNORECASE,
)
_WORD = re.compile(r"(?!sqrt)(?<![a-zα-ω])[a-zα-ω]{2,}", re.IGNORECASE)
_BARE = re.compile(rf"(?:{_VALUE})+")
_ARGUMENT = re.compile(
    rf"(?:v|w|x|u|q|E|V|N|Eig|eig|ker)\s*(?:_?\(\s*(?:A\s*[,;]\s*)?(?:{_LAMBDA}\s*=)?\s*((?:{_VALUE})+?)\s*\)"
    rf"|_\s*\{{\s*{_LAMBDA}\s*=\s*((?:{_VALUE})+?)\s*\}})\s*[:=]\s*"
)
_NAMED = re.compile(rf"\\?[^\W\d_]\w{{0,3}}?({_INDEX})\s*(?::=|=)\s*(?=\S)")
_NUMBER = re.compile(r"-?\d+")
_FACTOR = re.compile(r"^[a-zα-ω]_?\d?\s*[*·]?\s*(?=[(\[])")
_SPAN = re.compile(r"(?:span|lin|LH)\s*(?=[({\[<])", re.IGNORECASE)
_MAKER = re.compile(r"^(?:\w+\.)*(?:Immutable)?(?:Dense)?(?:[Mm]atrix|n?d?array)\s*\((.*)\)$", re.DOTALL)
_TURNED = re.compile(r"\s*(?:\.?['’′]|\^\{?\(?\s*(?:T|\\top)\s*\)?\}?|ᵀ|\.T|\^⊤)$")
_BEHIND = re.compile(
    rf"\s*\(\s*(?:(?:zu|zum|for|für|to|bei)\s+)?((?:{_LAMBDA}{_INDEX}\s*=|eigenvalue|eigenwert|EW)[^()]*)\)$",
    re.IGNORECASE,
)
_NEGATIVE = re.compile(r"_\{\s*([-−]\s*[\d.]+)\s*\}")
_BLANKS = re.compile(r"[^\S\n]+")
_SIGNS = re.compile(r"[±∓]|\\pm|\\mp")
MOST_VECTORS = 12
MOST_CHARACTERS = 2000


class Item(NamedTuple):
    """What a piece says: an eigenvalue ("value"), a vector, or "" for neither; with its name, or its index."""

    kind: str
    text: str
    name: str = ""


def with_plain_signs(text: str) -> str:
    """Return v(-1) for v_{-1}, whose sign is no part of an index of LaTeX."""
    return _NEGATIVE.sub(r"(\1)", text)


def eigenpairs(text: str) -> list[Pair]:
    """Return eigenvalues with their eigenvectors, as texts, an eigenvalue as often as it has vectors.

    Nothing of a text that holds anything else.
    """
    if len(text) > MOST_CHARACTERS:
        return []
    inside = _BLANKS.sub(" ", with_plain_indices(text)).strip()
    if printed := printed_pairs(inside):
        return printed if len(printed) <= MOST_VECTORS else []
    if enclosed(inside, "{}") or enclosed(inside):
        inside = inside[1:-1]
    items = list(_items(inside))
    if not items or any(each.kind == "" for each in items):
        return []
    told = _paired(_with_indices(items))
    pairs = [(value, _written_out(vector, len(told))) for value, vector in told]
    if not all(vector for _, vector in pairs):
        return []
    return [each for pair in pairs for each in _both(*pair)] if 0 < len(pairs) <= MOST_VECTORS else []


def _items(text: str) -> Iterator[Item]:
    """What the pieces of a text say; an item without a kind where one says neither."""
    pieces, at, before = list[tuple[str, bool]](), 0, False
    for end, start, told in _cuts(text):
        pieces.append((text[at:end], told or before))
        at, before = start, told
    for piece, told in [*pieces, (text[at:], before)]:
        if said := _WORDS.sub("", piece.strip(" .")):
            yield from _said(said, told=told)


def _cuts(text: str) -> Iterator[tuple[int, int, bool]]:
    """Where pieces end and begin outside of brackets, and whether a colon or an arrow stands there."""
    at = 0
    while at < len(text):
        if text[at] in "([{":
            at = matching(text, at) + 1
        elif found := _SEPARATOR.match(text, at):
            yield at, found.end(), any(found[each] for each in ("told", "says", "of"))
            at = max(found.end(), at + 1)
        else:
            at += 1


def _said(piece: str, *, told: bool) -> Iterator[Item]:
    """The eigenvalue or the vectors of a piece, or both."""
    if behind := _BEHIND.search(piece):
        yield from _said(piece[: behind.start()], told=False)
        piece = behind[1]
    if found := _ARGUMENT.match(piece):
        yield Item("value", (found[1] or found[2]).strip())
        piece = piece[found.end() :]
    bare = _NAMED.sub("", piece)
    unit = coefficients(bare, "e")
    if (found := _EIGENVALUE.fullmatch(piece)) and not _WORD.search(found[3]):
        yield Item("value", found[3].strip(), found[1] or found[2] or "")
    elif told and not unit and _is_number(piece):
        yield Item("value", piece.strip())
    else:
        name = found[1].strip("_{}") if (found := _NAMED.match(piece)) else ""
        vectors = vectors_of(piece)
        yield from (Item("vector" if vectors or unit else "", each, name) for each in vectors or [bare])


def _is_number(piece: str) -> bool:
    return _BARE.fullmatch(piece) is not None and not enclosed(piece, "()") and any(map(str.isdigit, piece))


def vectors_of(piece: str) -> list[str]:
    """Return the vectors of a piece, each in square brackets; nothing of anything else."""
    bare = piece.strip()
    if found := _NAMED.match(bare):
        bare = _WORDS.sub("", bare[found.end() :])
    bare = _FACTOR.sub("", bare)
    listed = _SPAN.match(bare)
    bare = _TURNED.sub("", bare[listed.end() :] if listed else bare).strip()
    if found := _MAKER.match(bare):
        bare = found[1].strip()
    if bare[:1] not in ("(", "[", "{") or matching(bare, 0) != len(bare) - 1:
        return []
    inside = bare[1:-1].strip()
    pieces = [each.strip() for each in split(inside, ",")]
    if all(each[:1] in ("(", "[", "{") or _MAKER.match(each) for each in pieces):
        columns = [each[1:-1] for each in pieces if enclosed(each)]
        if len(columns) == len(pieces) > 1 and all(len(split(each, re.compile(r"[,;\s]"))) == 1 for each in columns):
            return [f"[{'; '.join(columns)}]"]
        return [vector for each in pieces for vector in vectors_of(each)]
    inside = inside.replace("|", ",") if "," not in inside else inside
    several = len(split(inside, re.compile(r"[,;]|(?<=\S)\s+(?=\S)|\n"))) > 1
    return [f"[{inside}]"] if several else []


def _written_out(vector: str, most: int) -> str:
    """A vector by its entries, also of 2e1 + e3 among so many unit vectors; "" where it is none."""
    return vector if vector.startswith("[") else of_unit_vectors(vector, most)


def _paired(items: Sequence[Item]) -> list[Pair]:
    """Eigenvalues with their vectors: behind the eigenvalue, or before it where a vector comes first."""
    is_value = [each.kind == "value" for each in items]
    if not is_value[0]:  # (1, -1) for λ = -1
        both = zip(items[::2], items[1::2], strict=False)
        return [(value.text, vector.text) for vector, value in both] if _alternate(items) else []
    pairs, value, last = list[Pair](), Item("", ""), False
    for each, here in zip(items, is_value, strict=True):
        if here and last:
            return []  # an eigenvalue without a vector
        if here:
            value = each
        else:
            pairs.append((value.text, _with_value(each.text, value)))
        last = here
    return [] if last else pairs


def _alternate(items: Sequence[Item]) -> bool:
    """Whether each eigenvalue stands behind its one vector."""
    return len(items) % 2 == 0 and all((each.kind == "value") == (i % 2 == 1) for i, each in enumerate(items))


def _with_indices(items: Sequence[Item]) -> list[Item]:
    """Items with the eigenvalues that are indices, v_5 = (1, 1), v_{-2} = (1, -2), and not just numbers 1, 2, …."""
    if _alternate(items):
        return list(items)
    alone = [each for i, each in enumerate(items) if each.kind == "vector" and (i == 0 or items[i - 1].kind != "value")]
    indices = [each.name for each in alone]
    counted = any(sorted(indices) == [str(i) for i in range(first, len(items) + first)] for first in (0, 1))
    if counted or len(set(indices)) < len(indices) or not all(map(_NUMBER.fullmatch, indices)):
        return list(items)
    return [one for each in items for one in ((Item("value", each.name), each) if each in alone else (each,))]


def _with_value(vector: str, value: Item) -> str:
    """A vector with the eigenvalue in place of its name: (λ1, 1)."""
    if not value.name:
        return vector
    return re.sub(rf"(?<![^\W\d]){re.escape(value.name)}(?!\w)", f"({value.text})", vector)


def _both(value: str, vector: str) -> list[Pair]:
    """A pair; both of λ = -1 ± 2j: (1, -1 ± 2j)."""
    if not _SIGNS.search(value):
        return [(value, vector)]
    return [(_signed(value, upper=upper), _signed(vector, upper=upper)) for upper in (True, False)]


def _signed(text: str, *, upper: bool) -> str:
    return _SIGNS.sub(lambda found: "+-"[(found[0] in ("∓", "\\mp")) == upper], text)
