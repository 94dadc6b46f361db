"""Questions as they are held while a thousand variants are made: as a few kilobytes each, opened when they are written.

As objects they would take ten times as much, and all variants are drawn before the first is written.
"""

from __future__ import annotations

import json
import zlib
from dataclasses import dataclass

from solver.papers.exam.telling import QuestionMade
from solver.papers.plain import NotPlain, as_plain, of_plain

FAST = 1
"""Whatever packs better takes longer than it is worth."""


@dataclass(frozen=True, slots=True)
class Packed:
    """What was made of a question, as bytes; or itself, where it is no plain data."""

    content: bytes | QuestionMade

    @staticmethod
    def of(made: QuestionMade) -> Packed:
        """Pack what was made."""
        try:
            text = json.dumps(as_plain(made), ensure_ascii=False, separators=(",", ":"))
        except NotPlain:
            return Packed(made)
        return Packed(zlib.compress(text.encode("utf-8", "surrogatepass"), FAST))

    def opened(self) -> QuestionMade:
        """Return what was made."""
        if isinstance(self.content, QuestionMade):
            return self.content
        found = of_plain(json.loads(zlib.decompress(self.content).decode("utf-8", "surrogatepass")))
        if not isinstance(found, QuestionMade):
            raise AssertionError("only what was made is packed")
        return found
