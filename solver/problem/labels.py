"""How parts are named in print: (a), (b2), (iii) as the file names them; a key that is a word gets a letter.

A key that begins like this and ends in a word, `2f-wn`, is the next of the questions under 2f: (2f-i), (2f-ii).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from string import ascii_lowercase

_PIECE = r"(?:\d{1,3}[A-Za-z]?|[A-Za-z]\d{0,3}|[ivx]{1,5})"
_PRINTED = re.compile(rf"{_PIECE}(?:[-.]{_PIECE})*")
_UNDER = re.compile(rf"({_PIECE}(?:[-.]{_PIECE})*)-[A-Za-z_]\w*")
_ROMAN = ("i", "ii", "iii", "iv", "v", "vi", "vii", "viii", "ix", "x")


def labels_of(names: Iterable[str]) -> dict[str, str]:
    """Return what stands for each part in print: its key, or the next letter where the key is a word of the file."""
    bare = {name: name.strip("().") for name in names}
    taken = {name for name in bare.values() if _PRINTED.fullmatch(name)}
    found: dict[str, str] = {}
    last = ""
    for name, label in bare.items():
        free = label in taken and label not in found.values()
        under = "" if free else _next_under(label, taken, found)
        found[name] = label if free else under or _next_letter(last, {*taken, *found.values()})
        last = max(last, found[name][:1].lower())
    return found


def _next_under(name: str, taken: set[str], found: Mapping[str, str]) -> str:
    """Return the first free number under what the name begins with; empty where it does not begin like a label."""
    begins = _UNDER.fullmatch(name)
    numbered = (f"{begins[1]}-{number}" for number in _ROMAN) if begins else ()
    return next((each for each in numbered if each not in taken and each not in found.values()), "")


def _next_letter(last: str, taken: set[str]) -> str:
    """Return the first letter behind the last one that is free, else any that is, else a number."""
    behind = [letter for letter in ascii_lowercase if letter > last]
    numbers = map(str, range(1, len(taken) + 2))
    return next(each for each in [*behind, *ascii_lowercase, *numbers] if each not in taken)
