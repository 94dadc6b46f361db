"""Plain text for typst: a literal string of its code, in which no sign means anything; a missing letter is named."""

from __future__ import annotations

import unicodedata

from solver.render.raised import levels, lowered

_LETTERS = ((0x20, 0x7E), (0xA0, 0x17F), (0x391, 0x3A1), (0x3A3, 0x3A9), (0x3B1, 0x3C9), (0x410, 0x44F))
_SIGNS = frozenset("–—‘’“”‚„†‡•…‰‹›€™≤≥≠≈→←↔⇒⇔−·×÷±∞√∈∫∑∏∂∇⋯ℒ⁻⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ₀₁₂₃₄₅₆₇₈₉′″ϕϑϵЁё✓✗")
"""What the fonts within typst have for certain; where one lacks a letter, a PDF cannot be read to the blind."""

_NEAR = {"ℒ": "L", "𝒵": "Z", "\t": " ", "\n": " ", "\u00ad": ""}


def quoted(text: str) -> str:
    """Return a text as a string of typst's code."""
    return '"' + _passed_on(text).replace("\\", "\\\\").replace('"', '\\"') + '"'


def heard(text: str) -> str:
    """Return words that stand for a picture or a formula, and are read aloud: no font needs their letters."""
    letters = "".join(each for each in unicodedata.normalize("NFC", text) if each.isprintable())
    return '"' + letters.replace("\\", "\\\\").replace('"', '\\"') + '"'


def shows(text: str) -> bool:
    """Whether the fonts within typst have all letters of a text."""
    return _passed_on(text) == unicodedata.normalize("NFC", text)


def bare(text: str) -> str:
    """Return a text in one line as typst's markup."""
    return f"#{quoted(' '.join(text.split()))}"


def _passed_on(text: str) -> str:
    """Return a text in letters that the fonts have."""
    return "".join(_standing(level, letters) for level, letters in levels(text))


def _standing(level: str, letters: str) -> str:
    """Return letters of one level, as in A^T and e^(−s) where the fonts lack one above or below the line."""
    known = "".join(map(_letter, letters))
    if not level or known == letters:
        return known
    shown = "".join(map(_letter, lowered(letters)))
    return level + (shown if len(shown) == 1 else f"({shown})")


def _letter(letter: str) -> str:
    if letter in _NEAR:
        return _NEAR[letter]
    if letter in _SIGNS or any(first <= ord(letter) <= last for first, last in _LETTERS):
        return letter
    base = "".join(each for each in unicodedata.normalize("NFKD", letter) if not unicodedata.combining(each))
    if base != letter and base.isascii() and base.isprintable():
        return base
    if unicodedata.category(letter)[0] in "CM":
        return ""
    return f"[{unicodedata.name(letter, f'U+{ord(letter):04X}').lower()}]"
