"""Paragraphs of Markdown by what they do: explain, remark, lead in; and what is done to rows."""

from __future__ import annotations

import re

LEAST_EXPLAINED = 60
"""Characters of an explanation that is not told again."""

LEAST_CONCLUDED = 150
"""Characters of what is said at the end of a step from which on it remarks more than it concludes."""

LEAST_LEADING = 40
"""Characters of an introduction under a title that is not told again."""

OPERATION = re.compile(r"\\left(right)?arrow ")
_NO_PARAGRAPH = re.compile(r"\s|[-*+>|#]\s|\d+[.)]\s|\|")
"""How lists, tables, quotations and headings begin."""


def explains(block: str) -> bool:
    """Whether a block of Markdown is a paragraph without a display that is complete in itself."""
    return (
        len(block) >= LEAST_EXPLAINED and block.endswith(".") and "$$" not in block and not _NO_PARAGRAPH.match(block)
    )


def remarks(block: str) -> bool:
    """Whether a block of Markdown explains at such length that it is no conclusion."""
    return len(block) >= LEAST_CONCLUDED and explains(block)


def leads_in(block: str) -> bool:
    """Whether a block of Markdown is a sentence of some length before a display, which does not say what is done."""
    spoken = "$$" not in block and not _NO_PARAGRAPH.match(block) and not OPERATION.search(block)
    return spoken and len(block) >= LEAST_LEADING
