"""Papers and keys of questions as they are held while a thousand variants are made: opened by who writes them.

As objects they would take ten times as much, and all variants are drawn before the first is written. They are packed in
the process in which they are made: the one that leads neither packs nor opens them.
"""

from __future__ import annotations

import json
import zlib

from solver.document.model import Document
from solver.papers.plain import NotPlain, as_plain, of_plain

FAST = 1
"""Whatever packs better takes longer than it is worth."""


def packed(paper: Document, key: Document) -> bytes | tuple[Document, Document]:
    """Return what a paper and a key tell, as a few kilobytes; as it is where it is no plain data."""
    try:
        text = json.dumps(as_plain([paper, key]), ensure_ascii=False, separators=(",", ":"))
    except NotPlain:
        return paper, key
    return zlib.compress(text.encode("utf-8", "surrogatepass"), FAST)


def opened(told: bytes | tuple[Document, Document]) -> tuple[Document, Document]:
    """Return the paper and the key that were packed."""
    if isinstance(told, tuple):
        return told
    paper, key = of_plain(json.loads(zlib.decompress(told).decode("utf-8", "surrogatepass")))
    return paper, key
