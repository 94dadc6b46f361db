"""Names that are told beside a formula, and stand for what is told: C1 e^(-2t) + C2, C1 = 3, C2 = -2.

`1/(1 + sT) with T = RC`, `τ = t - 1: e^(-τ) u(τ)`, `g(t - 2) with g(t) = e^-t`. What is told may itself hold names that
are told, in any order. Only text is changed: each name gives way to what it stands for, in brackets.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction

from solver.classroom.reading.brackets import enclosed, matching, split
from solver.classroom.reading.general_forms import CONSTANT
from solver.classroom.reading.labels import SUBSCRIPTS, Labels
from solver.problem.expressions.notation import CONSTANTS, FUNCTIONS, GREEK, GREEK_NAMES, MAX_CHARACTERS
from solver.problem.expressions.vocabulary import pieces_of

_RAISED = "²³¹⁰⁴-⁹⁺⁻ⁿᵗᵏ"
_LETTER = rf"(?![{_RAISED}])[^\W\d_]"
_WORD = rf"{_LETTER}(?:(?![{_RAISED}])\w)*"
_NAMES = re.compile(rf"(?<![^\W_\d])\\?{_WORD}")
_TOLD = re.compile(
    rf"^\(?\s*(?P<name>\\?{_WORD})\s*(?:\(\s*(?P<argument>{_WORD})\s*\))?\s*(?P<squared>\^\s*2|²)?\s*(?::=|=(?![=>]))\s*"
    rf"(?:(?P<named>{_WORD}\s*\([\d+]*\)|[-+−]?\d+(?:\s*/\s*\d+)?)\s*=\s*)?(?P<value>[^=<>≤≥]+)$"
)
_HEAD = re.compile(rf"^(?:\s*{_WORD}\s*(?:\(\s*[\w∞]+[+⁺]?\s*\))?\s*(?:²|\^\s*2)?\s*=)?")
"""The label of a statement, where it has one."""
_FOUND_BY = re.compile(rf"^{_WORD}['′]*\s*\(\s*\d\s*\)\s*=")
"""The values at the beginning, x(0) = C1 + C2 = 2."""
_NAME_BEFORE = re.compile(rf"^\s*({_WORD})\s*(?:\(\s*\w\s*\))?\s*=")
_SHARED = re.compile(rf"^({_WORD})\s*=\s*(?={_WORD}\s*=)")
"""C1 = C2 = 1."""
_LABELLED = re.compile(rf"^\\?{_WORD}\s*(?:\(\s*[\w∞]+[+⁺]?\s*\))?\s*=(?![=>])")
_BETWEEN = re.compile(
    r"\s*(?:=>|⇒|⟹|→|->|\\Rightarrow|(?<!\d),|,(?!\d)|[;:\n](?!=)|\b(?:with|where|mit|wobei|and|und|hence|thus|so|also|damit|somit)\b)\s*"
)
_BEHIND = re.compile(r"^(.*\S)\s*[(\[]\s*(?:(?:with|where|mit|wobei)\s+)?([^()\[\]=]+=[^=]+)[)\]]\s*\.?$", re.DOTALL)
"""1/(1 + sT) (T = RC)."""
_JOINED = re.compile(r"^\s*(?:and|und|with|where|mit|wobei|so|also)\b|^[,;:]+|[,;:.]+$")
_QUANTITY = re.compile(r"^([-+−]?[\d./√π]+)\s*(?:sec\.?|rad(?:/s(?:ec)?)?|1/s|s\^-1|s⁻¹|s)$")
_NUMBER = re.compile(r"^[-+−]?[\d./√π()*\s·]+(?:\s*[ij])?$")
_DASHED = re.compile(r"\s*['′″’]|\s*_d*dot")
_TIGHT = re.compile(rf"(?:\^\s*[-+−]?|(?<![A-Za-z])(?:{'|'.join(FUNCTIONS)})\s+[-+−]?\s*)$")
"""What takes the next factor only, or more: e^- a t, cos ω t."""
_GOES_ON = re.compile(r"\s*[\w(√]")
_UNSIGNED = re.compile(r"\d+(?:\.\d+)?")
_BESIDE = re.compile(r"[\w.)]\s*$")
_BOUND = re.compile(r"[(.^²³]|\s*\d")
_BEGINS = re.compile(r"\[(?:[-+−]?\w+[\s,;]+)*$")
_ENDS = re.compile(r"(?:[\s,;]+[-+−]?\w+)*\s*\]")
_ENTRY = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:/\d+)?")
_INDICES = "0123456789₀₁₂₃₄₅₆₇₈₉"
_FIXED = frozenset({"t", *CONSTANTS})
"""Names that nobody can tell."""
MOST_NAMES = 10
MOST_PIECES = 16


@dataclass(frozen=True)
class Told:
    """What a name stands for; of a function with the argument it is told for."""

    value: str
    argument: str = ""


def _are_entries(pieces: list[str]) -> bool:
    """Whether pieces tell the entries of a row, k1 = 2a, k2 = 3 k1, each of which may hold those before it."""
    statements = [_TOLD.match(piece) for piece in pieces]
    letters = {each["name"].rstrip(_INDICES).rstrip("_") for each in statements if each}
    return all(statements) and len(letters) == 1


def with_told_names(text: str, own: Collection[str], known: Collection[str]) -> str:
    """Return what is said with what is told beside it in place of names; "" where nothing is told.

    `own` are the names that our answer is made of, which nobody can tell; `known` those that have a meaning in the
    problem.
    """
    if "=" not in text or len(text) > MAX_CHARACTERS:
        return ""
    pieces, known = _pieces(text), {*map(_key, known)}
    if not 1 < len(pieces) <= MOST_PIECES or _are_entries(pieces):
        return ""
    own, statements = {*map(_key, own)}, [_TOLD.match(piece) for piece in pieces]
    names = {_key(each["name"]) for each in statements if each}
    told: dict[str, Told] = {}
    said: list[str] = []
    for piece, found in zip(pieces, statements, strict=True):
        name = _key(found["name"]) if found else ""
        others = [each for each in pieces if each is not piece]
        if found is None or name in own or not any(name in _used(each, names, known) for each in others):
            said.append(piece)
        elif name in told or name in _FIXED:
            return ""
        else:
            told[name] = _told(found, own)
            if not told[name].value:
                return ""
    solved = not own and any("=" in _HEAD.sub("", piece) for piece in said)  # λ^2 = 4, λ = 2
    labels = {_key(found[1]) for piece in said if (found := _NAME_BEFORE.match(piece))}
    entries = {*map(_numbered, told)} & {*map(_numbered, labels)} - {""}  # k1 = 2, k2 = 3 k1
    if not told or not said or solved or entries or len(told) > MOST_NAMES:
        return ""
    said = [piece for piece in said if not _FOUND_BY.match(piece) and not _is_about(piece, told, known)]
    return ", ".join(filter(None, (_put(piece, told, known) for piece in _joined(said))))


def without_constants(text: str) -> str:
    """Return 2/(s + 1) + 1/(s + 3) of A = 2, B = 1: 2/(s + 1) + 1/(s + 3), whose constants are told too; else ""."""
    pieces = _pieces(text) if "=" in text else []
    found = [_TOLD.match(piece) for piece in pieces]
    named = [each for each in found if each and CONSTANT.match(_key(each["name"]))]
    constants = [each for each in named if _NUMBER.match(each["value"])]
    said = [piece for piece, each in zip(pieces, found, strict=True) if each not in constants]
    return said[0] if len(constants) > 1 and len(said) == 1 else ""


def own_statement(text: str, labels: Labels) -> str:
    """Return f = … of F(s) = …, f = …, where each statement says by its label what it is; "" of any other text."""
    pieces = _pieces(text) if "=" in text else []
    found = [_LABELLED.match(piece) for piece in pieces]
    own = [piece for piece, each in zip(pieces, found, strict=True) if each and not labels.before(piece)[0]]
    return own[0] if len(pieces) > 1 and all(found) and len(own) == 1 else ""


def _pieces(text: str) -> list[str]:
    """The statements of a text."""
    text = re.sub(r"_\{(\w+)\}", r"_\1", text)
    if found := _BEHIND.match(text):
        text = f"{found[1]}, {found[2]}"
    pieces = [each.strip() for each in split(text.rstrip(" ."), _BETWEEN) if each.strip()]
    return [each for piece in pieces for each in _each_told(piece)]


def _each_told(piece: str) -> list[str]:
    """A statement for each of the constants that are told to be equal, C1 = C2 = 1."""
    found = _SHARED.match(piece)
    if found is None or not CONSTANT.match(_key(found[1])):
        return [piece]
    rest = piece[found.end() :]
    return [f"{found[1]} = {rest.rpartition('=')[2].strip()}", *_each_told(rest)]


def _told(found: re.Match[str], own: Collection[str]) -> Told:
    """What a statement tells; a plain number without its unit, but for seconds beside functions of s."""
    value = _JOINED.sub("", found["value"]).strip()
    if found["named"] and found["named"][0] in "+-−0123456789":  # C2 = 6/3 = 2
        value = found["named"] if _number(found["named"]) == _number(value) else ""
    if (quantity := _QUANTITY.match(value)) and not ("s" in own and value.endswith("s")):
        value = quantity[1]
    return Told(f"sqrt({value})" if found["squared"] else value, _key(found["argument"] or ""))


def _number(text: str) -> Fraction | None:
    """The number that a text plainly is."""
    try:
        return Fraction(re.sub(r"\s", "", text.replace("−", "-")))
    except (ValueError, ZeroDivisionError):
        return None


def _is_about(piece: str, told: Collection[str], known: Collection[str]) -> bool:
    """Whether a statement is an equation for what is told and nothing else: A + B = 1."""
    words = [word for found in _NAMES.finditer(piece) for word in _cut(found[0], told, known)]
    return "=" in piece and bool(words) and all(word in told for word in words)


def _joined(said: list[str]) -> list[str]:
    """What is said, with remarks that are no statements of their own beside what they belong to."""
    whole: list[str] = []
    for piece in said:
        if whole and "=" not in re.sub(r"[<>]=", "", piece):
            whole[-1] += f", {piece}"
        else:
            whole.append(piece)
    return whole


def _put(text: str, told: Mapping[str, Told], known: Collection[str]) -> str:
    """A statement with what is told in place of names, behind its own label; "" where that has no end."""
    label = _HEAD.match(text)
    head, rest = (label[0], text[label.end() :]) if label else ("", text)
    for _ in range(len(told) + 1):
        before, rest = rest, _replaced(rest, told, known)
        if rest == before:
            return f"{head} {rest}".strip()
        if not rest or len(rest) > MAX_CHARACTERS:
            return ""
    return ""


def _replaced(text: str, told: Mapping[str, Told], known: Collection[str]) -> str:
    """A text with each name that is told once replaced; "" where it is not clear what a sign before it takes."""
    pieces, at, length = [], 0, 0
    for found in _NAMES.finditer(text):
        if length > MAX_CHARACTERS:
            return ""
        words = _cut(found[0], told, known)
        if found.start() < at or not any(word in told for word in words) or _DASHED.match(text, found.end()):
            continue
        before, end = text[: found.start()], found.end()
        values = [told[word].value if word in told else word for word in words]
        last = told.get(words[-1])
        if last and last.argument and text[end : end + 1] == "(":
            inside = {last.argument: Told(text[end + 1 : matching(text, end)])}
            values[-1] = _replaced(last.value, inside, known)
            end = matching(text, end) + 1
        if len(values) == 1 and _alone(before, values[0], text[end:]):
            product = values[0]
        elif _TIGHT.search(before) and len(values) == 1 and _GOES_ON.match(text, end):
            return ""
        else:
            product = " ".join(
                _in_brackets(value) if word in told else word for word, value in zip(words, values, strict=True)
            )
            product = (
                f"({product})" if len(values) > 1 and _TIGHT.search(before) else _apart(before, product, text[end:])
            )
        pieces += [text[at : found.start()], product]
        length += len(product)
        at = end
    return "".join([*pieces, text[at:]])


def _apart(before: str, product: str, after: str) -> str:
    """A product with spaces where it would else be one word or a call with what stands beside it."""
    left = " " if re.search(r"(?:[^\W\d]\w*|[)\]]|(?<![\w.])1)$", before) else ""
    right = " " if re.match(r"[\w(\[]", after) and not re.match(rf"[{_RAISED}]", after) else ""
    return f"{left}{product}{right}"


def _in_brackets(value: str) -> str:
    """A value in round brackets; a matrix in its own."""
    return value if enclosed(value) else f"({value})"


def _alone(before: str, value: str, after: str) -> bool:
    """Whether a value needs no brackets: between others, u(τ), as an entry, or as what begins a product, cos ω t."""
    if before.endswith("(") and after.startswith(")"):
        return True
    if _BEGINS.search(before) and _ENDS.match(after) and _ENTRY.fullmatch(value):
        return True
    bound = _BESIDE.search(before) is not None or _BOUND.match(after) is not None
    return _UNSIGNED.fullmatch(value) is not None and not bound


def _numbered(name: str) -> str:
    """The letter of a name with an index, k of k1; "" of any other name."""
    return name.rstrip("0123456789") if name[-1:].isdigit() else ""


def _used(text: str, names: Collection[str], known: Collection[str]) -> set[str]:
    """Those of some names that stand in a text, but in the label before it, or as a derivative."""
    label = _HEAD.match(text)
    found = [each for each in _NAMES.finditer(text, label.end() if label else 0) if not _DASHED.match(text, each.end())]
    return {word for each in found for word in _cut(each[0], names, known)} & {*names}


def _cut(word: str, told: Collection[str], known: Collection[str]) -> list[str]:
    """A word as the names it is made of where some of them are told, ωt of ω; else as it stands."""
    key = _key(word)
    if key in told or key in FUNCTIONS or key in GREEK_NAMES or key in known:
        return [key] if key in told else [word]
    letters = {*told, *CONSTANTS, *known, "s", "z", "t", "k", "i"}
    pieces = pieces_of(key, letters)
    return pieces if set(pieces) & set(told) else [word]


def _key(name: str) -> str:
    """A name as it is compared: ω₀, ω_0, omega0 are one."""
    bare = "".join(GREEK.get(sign, sign) for sign in name.translate(SUBSCRIPTS).lstrip("\\"))
    return bare.replace("lambda", "lamda").replace("_", "")
