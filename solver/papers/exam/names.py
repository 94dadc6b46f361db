"""Names of students as names of files: safe everywhere, each once."""

from __future__ import annotations

from unicodedata import normalize

LONGEST = 80
"""Bytes of a name in UTF-8; file systems allow 255 for all."""


class Names:
    """Gives each text a name of a file of its own; those that differ in capitals only are one for some file systems."""

    def __init__(self) -> None:
        self.taken: set[str] = set()

    def of(self, text: str) -> str:
        """Return a name of letters, digits, `-`, `_` and dots inside: no path, no option, no hidden file."""
        name = safe_name(text)
        chosen, number = name, 1
        while normalize("NFKC", chosen).casefold() in self.taken:
            number += 1
            chosen = f"{name}-{number}"
        self.taken.add(normalize("NFKC", chosen).casefold())
        return chosen


def safe_name(text: str) -> str:
    """Return the letters and digits of a text with hyphens between them, "student" where it has none."""
    letters = [sign if sign.isalnum() or sign in "_." else "-" for sign in normalize("NFC", text)]
    words = "-".join(filter(None, "".join(letters).split("-")))
    short = words.encode()[:LONGEST].decode("utf-8", "ignore").strip("-.")
    while ".." in short:
        short = short.replace("..", ".")
    return short or "student"
