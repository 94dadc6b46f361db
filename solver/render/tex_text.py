"""Plain text for TeX: its own signs escaped, Unicode as far as the usual fonts have it, the rest named."""

from __future__ import annotations

import re
import unicodedata

from solver.formula import GREEK_LETTERS
from solver.render.raised import level_of, levels, lowered

SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': r"\textquotedbl{}",
    "\n": "\n",
    "\t": " ",
    "\u00a0": "~",
}

MATH = {
    **{letter: f"\\{name}" for letter, name in GREEK_LETTERS.items()},
    **{
        "≤": r"\le",
        "≥": r"\ge",
        "≠": r"\ne",
        "≈": r"\approx",
        "→": r"\to",
        "←": r"\leftarrow",
        "↔": r"\leftrightarrow",
    },
    **{"−": "-", "·": r"\cdot", "∞": r"\infty", "√": r"\surd", "∈": r"\in", "∫": r"\int", "Σ": r"\Sigma", "Π": r"\Pi"},
    **{"ℒ": r"\mathcal{L}", "𝒵": r"\mathcal{Z}", "′": "'", "∂": r"\partial", "⋯": r"\cdots"},
}

_WITHOUT_GLYPH = frozenset("\u00ad¸ĦħĸĿŀŉŦŧſ")
"""Letters up to U+017F that the encodings T1 and TS1 of TeX lack."""
_PUNCTUATION = frozenset("–—‘’“”‚„†‡•…‰‹›€™")

_JOINED = re.compile(r"""-(?=-)|,(?=,)|`(?=`)|'(?=')|[?!](?=`)""")
"""What the fonts would join with the sign after it: to a dash, a quotation mark, or one upside down."""


def escaped(text: str) -> str:
    """Return text that TeX prints as it stands; a character that its fonts lack is replaced by its name."""
    shown = "".join(_standing(level, letters) for level, letters in levels(text))
    return _JOINED.sub(r"\g<0>{}", shown)


def shows(text: str) -> bool:
    """Whether TeX prints all letters of a text, and names none."""
    return all(_is_known(letter) for letter in unicodedata.normalize("NFC", text))


def _is_known(letter: str) -> bool:
    known = letter in SPECIAL or letter in _PUNCTUATION or letter in MATH or " " <= letter <= "~"
    return known or level_of(letter) != "" or ("\u00a1" <= letter <= "\u017f" and letter not in _WITHOUT_GLYPH)


def _standing(level: str, letters: str) -> str:
    if not level:
        return "".join(map(_letter, letters))
    shown = "".join(MATH.get(letter, _letter(letter)) for letter in lowered(letters))
    return rf"\ensuremath{{{level}{{{shown}}}}}"


def _letter(letter: str) -> str:
    if letter in SPECIAL:
        return SPECIAL[letter]
    if letter in MATH:
        return f"\\ensuremath{{{MATH[letter]}}}"
    return letter if _is_known(letter) else _replacement(letter)


def _replacement(letter: str) -> str:
    base = unicodedata.normalize("NFKD", letter)[0]
    if base != letter and base.isascii() and base.isprintable():
        return SPECIAL.get(base, base)
    if unicodedata.category(letter)[0] in "CM":
        return ""
    name = unicodedata.name(letter, f"U+{ord(letter):04X}").lower()
    return f"[{name.replace('_', ' ')}]"
