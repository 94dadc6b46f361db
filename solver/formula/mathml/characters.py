r"""The characters of commands, as latex2mathml knows them, and how they are set.

This is the one module that uses latex2mathml: its table of more than two thousand characters. Letters and operators
are told apart by our vocabulary, the shapes of letters (bold, script, blackboard) are characters of their own.
"""

from __future__ import annotations

import unicodedata
from functools import lru_cache

from latex2mathml.symbols_parser import convert_symbol

OURS = {
    **{r"\sim": "∼", r"\ast": "∗", r"\iff": "⇔", r"\implies": "⇒", r"\colon": ":", r"\backslash": "\\", "-": "−"},
    **{r"\{": "{", r"\}": "}", r"\lbrace": "{", r"\rbrace": "}", r"\lbrack": "[", r"\rbrack": "]", r"\|": "‖"},
    **{r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\lVert": "‖", r"\rVert": "‖", r"\Vert": "‖", r"\Im": "Im"},
    r"\Re": "Re",
}
r"""What is drawn otherwise than the table says: `\sim` there is a tilde, long arrows are longer than ours."""

SHAPES = {
    **{r"\mathbf": "BOLD", r"\boldsymbol": "BOLD ITALIC", r"\mathit": "ITALIC", r"\mathcal": "SCRIPT"},
    **{r"\mathbb": "DOUBLE-STRUCK", r"\mathfrak": "FRAKTUR", r"\mathsf": "SANS-SERIF", r"\mathtt": "MONOSPACE"},
}


@lru_cache(maxsize=1024)
def character(command: str) -> str:
    """Return what a command of the vocabulary is drawn as; a character is drawn as itself."""
    if command in OURS or command[0] != "\\":
        return OURS.get(command, command)
    code = convert_symbol(command)
    return command[1:] if code is None else chr(int(code, 16))


@lru_cache(maxsize=1024)
def shaped(letter: str, command: str) -> str:
    r"""Return a letter in the shape of a command (`\mathbf`), or as it is if Unicode has none."""
    name = unicodedata.name(letter, "")
    name = name.replace("LATIN ", "").replace("GREEK ", "").replace("LETTER ", "")
    style = SHAPES.get(command, "")
    if style == "BOLD ITALIC" and is_greek_capital(letter):
        style = "BOLD"
    for each in (f"MATHEMATICAL {style} {name}", f"{style.replace('FRAKTUR', 'BLACK-LETTER')} {name}"):
        try:
            return unicodedata.lookup(each)
        except KeyError:
            continue
    return letter


def is_greek_capital(letter: str) -> bool:
    """Whether it is one of the capitals that TeX sets upright."""
    return "Α" <= letter <= "Ω"
