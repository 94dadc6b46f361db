"""How parts are named in print: (a), (b2), (iii), (2f-full) as the file names them; a word alone gets a letter."""

from __future__ import annotations

import re
from collections.abc import Iterable
from string import ascii_lowercase

_PIECE = r"(?:\d{1,3}[A-Za-z]?|[A-Za-z]\d{0,3}|[ivx]{1,5})"
_PRINTED = re.compile(rf"{_PIECE}(?:[-.]{_PIECE})*|\d{{1,3}}[A-Za-z]?(?:-[A-Za-z]{{1,12}}){{1,2}}")


def labels_of(names: Iterable[str]) -> dict[str, str]:
    """Return what stands for each part in print: its key, or the next letter where the key is a word of the file."""
    bare = {name: name.strip("().") for name in names}
    taken = {name for name in bare.values() if _PRINTED.fullmatch(name)}
    found: dict[str, str] = {}
    last = ""
    for name, label in bare.items():
        free = label in taken and label not in found.values()
        found[name] = label if free else _next_letter(last, {*taken, *found.values()})
        last = max(last, found[name][:1].lower())
    return found


def _next_letter(last: str, taken: set[str]) -> str:
    """Return the first letter behind the last one that is free, else any that is, else a number."""
    behind = [letter for letter in ascii_lowercase if letter > last]
    numbers = map(str, range(1, len(taken) + 2))
    return next(each for each in [*behind, *ascii_lowercase, *numbers] if each not in taken)
