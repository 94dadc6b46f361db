"""Letters of plain text above and below the line, as in e⁻ˢ and xₖ: fonts for print have some of them only."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from itertools import groupby

_LEVELS = {"<super>": "^", "<sub>": "_"}


def level_of(letter: str) -> str:
    """Return "^" or "_" of a letter above or below the line; "" of any other, the ª and º of words among them."""
    kind, _, code = unicodedata.decomposition(letter).partition(" ")
    return "" if " " in code or unicodedata.category(letter) == "Lo" else _LEVELS.get(kind, "")


def levels(text: str) -> Iterator[tuple[str, str]]:
    """Yield what stands on one level together, with the level, in the order of the text, which is composed (NFC)."""
    for level, letters in groupby(unicodedata.normalize("NFC", text), level_of):
        yield level, "".join(letters)


def lowered(letters: str) -> str:
    """Return raised letters as they are on the line."""
    return unicodedata.normalize("NFKD", letters)
