"""What a macro displays is noted while it is worded: which values were printed, and which equalities.

While a macro runs, a character for private use stands for each value printed by `tex` and for each display. So the
values themselves are known, not only their digits on the page, wherever a template puts them; in the end the
characters give way to LaTeX.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from threading import local
from typing import Any, NamedTuple

from solver.derivation.displayed import FIRST_MARK, Displayed, Written

MARK = re.compile("[\U000f0000-\U000ffffd]")
_MARK_BEFORE_LETTER = re.compile("([\U000f0000-\U000ffffd])(?=([A-Za-z])?)")
_ENDS_IN_COMMAND = re.compile(r"\\[A-Za-z]+\Z")
_FORMULA = re.compile(r"([\U000f0000-\U000ffffd])|\$\$(.+?)\$\$|(?<!\\)\$(.+?)(?<!\\)\$", re.DOTALL)


class _Note(NamedTuple):
    """What a mark stands for: LaTeX of a value, or a display with the equalities in it."""

    text: str
    value: Any = None
    displayed: tuple[Displayed, ...] | None = None


class Recorder(local):
    """The notes of the macro that is being worded (each thread has its own)."""

    def __init__(self) -> None:
        self.notes: list[_Note] = []

    def begin(self) -> None:
        """Forget what the macro before has noted."""
        self.notes.clear()

    def value(self, value: Any, text: str) -> str:
        """Note that a value was printed; return its mark."""
        return self._mark(_Note(text, value))

    def display(self, displayed: Iterable[Displayed], text: str) -> str:
        """Note a display; return its mark."""
        return self._mark(_Note(text, None, tuple(displayed)))

    def _mark(self, note: _Note) -> str:
        self.notes.append(note)
        return chr(FIRST_MARK + len(self.notes) - 1)

    def written(self, text: str) -> Written:
        """Return a formula with marks as data: its own values, numbered from 0."""
        values: list[Any] = []

        def renumbered(match: re.Match[str]) -> str:
            values.append(self.notes[ord(match[0]) - FIRST_MARK].value)
            return chr(FIRST_MARK + len(values) - 1)

        return Written(MARK.sub(renumbered, text), tuple(values))

    def expanded(self, text: str) -> str:
        """Return a text with LaTeX in place of its marks; a command does not run into the letter after it."""

        def latex(match: re.Match[str]) -> str:
            number = ord(match[1]) - FIRST_MARK
            shown = self.notes[number].text if number < len(self.notes) else ""
            return f"{shown} " if match[2] and _ENDS_IN_COMMAND.search(shown) else shown

        return _MARK_BEFORE_LETTER.sub(latex, text)

    def displayed(self, text: str) -> Iterator[Displayed]:
        """Yield all that a text of Markdown with marks displays, in the order of reading."""
        for mark, block, inline in _FORMULA.findall(text):
            if not mark:
                yield Displayed((self.written(block or inline),))
            elif (known := self.notes[ord(mark) - FIRST_MARK].displayed) is not None:
                yield from known
