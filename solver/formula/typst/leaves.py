"""What typst's formulas are written with: signs, strings, calls, and what makes them look as TeX's do."""

from __future__ import annotations

import re
from collections.abc import Iterable

ACCENTS = {
    **{r"\dot": "0307", r"\ddot": "0308", r"\dddot": "20db", r"\bar": "0304", r"\hat": "0302", r"\widehat": "0302"},
    **{r"\tilde": "0303", r"\widetilde": "0303", r"\vec": "20d7", r"\check": "030c"},
}
"""The code points of marks; what is missing here is a line."""

ALPHABETS = {
    **{r"\mathrm": "upright", r"\mathit": "italic", r"\mathsf": "sans", r"\mathtt": "mono", r"\mathbb": "bb"},
    **{r"\mathcal": "cal", r"\mathfrak": "frak", r"\boldsymbol": "bold"},
}

STYLES = {r"\displaystyle": "display", r"\textstyle": "inline", r"\dfrac": "display", r"\tfrac": "inline"}
CLASSES = {"/": "normal", ".": "normal", r"\colon": "punctuation"}
"""Signs that TeX spaces otherwise than Unicode says."""

LONG = {r"\iff": "⟺", r"\implies": "⟹"}
NOTHING = '""'


_MARKUP = re.compile(r"[!-/:-@\[-`{-~⟨⟩⌊⌋⌈⌉]")
"""Signs of ASCII, and brackets, of which typst looks for partners."""

THIN = "#h(0.167em)"


def escaped(letter: str) -> str:
    """Return a character as itself: what typst could read as its own markup, or pair, after a backslash."""
    return f"\\{letter}" if _MARKUP.match(letter) else letter


def quoted(words: str) -> str:
    """Return words as a string."""
    return '"' + words.replace("\\", "\\\\").replace('"', '\\"') + '"'


def operand(side: str) -> str:
    """Return the right side of an equation behind an empty operand, which gives its sign the space of a relation."""
    return classed("normal", NOTHING) + side


def call(name: str, *arguments: str) -> str:
    """Return a call of a function; an argument that is empty is written as such."""
    return f"{name}({', '.join(argument or NOTHING for argument in arguments)})"


def classed(kind: str, sign: str) -> str:
    """Return a sign that is spaced as one of this kind is."""
    return call("class", quoted(kind), sign)


def joined(pieces: Iterable[str]) -> str:
    """Put pieces side by side, with a blank only where they would become one name or number."""
    written = ""
    for piece in pieces:
        written += f" {piece}" if _in_a_name(written[-1:]) and _in_a_name(piece[:1]) else piece
    return written


def _in_a_name(sign: str) -> bool:
    """Whether a sign may be part of a name, as a letter and the dot of a product are."""
    return bool(sign) and f"x{sign}".isidentifier()
