"""The text of a file, places in it, and errors that show their place.

Lines and columns count from 1, columns in characters. Line 0 stands for the file as a whole.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cached_property
from unicodedata import combining, east_asian_width

SHOWN_AT_MOST = 20
WIDTH = 110  # characters of a source line that are shown


@dataclass(frozen=True)
class Source:
    """A text and the name it goes by in messages (a path as the user wrote it, or "<text>")."""

    name: str
    text: str

    @cached_property
    def lines(self) -> list[str]:
        """The lines without their ends."""
        return self.text.split("\n")

    def line(self, number: int) -> str:
        """Return the line of that number from 1; empty if there is none."""
        return self.lines[number - 1] if 1 <= number <= len(self.lines) else ""

    @property
    def has_lines(self) -> bool:
        """Whether errors show the line that they are in."""
        return True

    def where(self, line: int, column: int) -> str:
        """Return where a place is, in words."""
        return f"{self.name}:{line}:{column}"


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One error: what is wrong, where, and what may be meant.

    `length` characters are underlined. `suggestion` is the word probably meant; `note` is any other help.
    """

    message: str
    line: int = 0
    column: int = 0
    length: int = 1
    suggestion: str = ""
    note: str = ""

    def render(self, source: Source) -> str:
        """Return the message, the line of the source with a caret below, and what may be meant."""
        helps = [f"did you mean '{self.suggestion}'?"] if self.suggestion else []
        helps += [self.note] if self.note else []
        below = [f"{'':6} = {text}" for text in helps]
        if not self.line:
            return "\n".join([f"{source.name}: error: {self.message}", *below])
        head = f"{source.where(self.line, self.column)}: error: {self.message}"
        return "\n".join([head, *(self._excerpt(source.line(self.line)) if source.has_lines else ()), *below])

    def _excerpt(self, line: str) -> list[str]:
        """Return the line and the carets; of a long line the part around the place."""
        start = max(0, self.column - 1 - WIDTH // 2) if len(line) > WIDTH else 0
        shown = "".join(character if character.isprintable() else " " for character in line[start : start + WIDTH])
        before = shown[: self.column - 1 - start]
        under = shown[len(before) : len(before) + self.length]
        carets = "^" * max(1, _cells(under))
        return [f"{self.line:6} | {shown}".rstrip(), f"{'':6} | {' ' * _cells(before)}{carets}"]


def _cells(text: str) -> int:
    """Return the number of terminal cells a text takes."""
    return sum(0 if combining(c) else 2 if east_asian_width(c) in "WF" else 1 for c in text)


class Fault(Exception):  # noqa: N818 - reported to the user as an error, carried in the program as a list of them
    """Something in the input is wrong; it is reported together with what else is."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        super().__init__("; ".join(each.message for each in diagnostics))
        self.diagnostics = diagnostics


class InputError(Exception):
    """The input is at fault: everything that is wrong with one source, in the order of the file."""

    def __init__(self, source: Source, diagnostics: Iterable[Diagnostic]) -> None:
        unique = dict.fromkeys(diagnostics)
        self.source = source
        self.diagnostics = sorted(unique, key=lambda each: (each.line, each.column))
        super().__init__(self.render())

    def render(self) -> str:
        """Return all errors, each with its place; at most 20 are shown."""
        return self.first(SHOWN_AT_MOST)

    def first(self, at_most: int) -> str:
        """Return so many errors, each with its place, and how many more there are."""
        shown = [each.render(self.source) for each in self.diagnostics[:at_most]]
        hidden = len(self.diagnostics) - len(shown)
        return "\n".join([*shown, f"and {hidden} more"] if hidden else shown)


@dataclass
class Report:
    """Collects what is wrong so that all errors of a file are shown together."""

    diagnostics: list[Diagnostic] = field(default_factory=list)

    def __enter__(self) -> Report:
        return self

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> bool:
        """Keep the diagnostics of a fault and go on after the block; let everything else through."""
        if not isinstance(error, Fault):
            return False
        self.diagnostics.extend(error.diagnostics)
        return True

    def conclude(self) -> None:
        """Raise one fault with everything collected, if there is anything."""
        if self.diagnostics:
            raise Fault(*self.diagnostics)


def surplus(key: str, present: Sequence[str], own: Sequence[str], others: Collection[str] = ()) -> tuple[str, str]:
    """Return the message for a key of a mapping that is none of its `own`, and the key probably meant.

    `present` are all keys of the mapping; `others` are those of mappings that could stand in its place: strange to this
    one, they are told together.
    """
    tells = next((name for name in own if name in present), "")
    if tells and key in others:
        strangers = [f"'{each}'" for each in present if each in others and each not in own]
        return f"{' and '.join(strangers)} cannot stand beside '{tells}'", ""
    return f"unknown key '{key[:60]}'", did_you_mean(key, (name for name in own if name not in present))


def did_you_mean(word: str, candidates: Iterable[str]) -> str:
    """Return the candidate most like the word, or "" if none is like it. Case and `-` for `_` don't count."""
    known = {_plain(candidate): candidate for candidate in candidates}
    close = get_close_matches(_plain(word), known, n=1, cutoff=0.6)
    return known[close[0]] if close else ""


def _plain(word: str) -> str:
    return word.lower().replace("-", "_").replace(" ", "_")
