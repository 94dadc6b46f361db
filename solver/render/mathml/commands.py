"""The dialect of LaTeX that is drawn: commands, environments, delimiters, and the marks that stand for some of them."""

from __future__ import annotations

import unicodedata

from latex2mathml.commands import CONVERSION_MAP, FUNCTIONS
from latex2mathml.symbols_parser import convert_symbol

# Marks that pass through latex2mathml as letters.
LEFT_BAR, RIGHT_BAR, LEFT_DOUBLE_BAR, RIGHT_DOUBLE_BAR = "\ue000", "\ue001", "\ue002", "\ue003"
HORIZONTAL_LINE, DISPLAY_STYLE = "\ue010", "\ue011"
VERTICAL_LINE = "\ue100"  # … and the following: a line before column 0, 1, 2, …

BARS = {r"\lvert": LEFT_BAR, r"\rvert": RIGHT_BAR, r"\lVert": LEFT_DOUBLE_BAR, r"\rVert": RIGHT_DOUBLE_BAR}

DELIMITERS = {
    **{character: character for character in "()[]|/."},
    **{r"\{": "{", r"\}": "}", r"\lbrace": "{", r"\rbrace": "}", r"\lbrack": "[", r"\rbrack": "]"},
    **{r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\|": "‖", r"\lVert": "‖", r"\rVert": "‖", r"\Vert": "‖"},
    **{r"\langle": "⟨", r"\rangle": "⟩", r"\lfloor": "⌊", r"\rfloor": "⌋", r"\lceil": "⌈", r"\rceil": "⌉"},
}
FENCED = {r"\left", r"\middle", r"\right"}
BIG = {rf"\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "m", "r")}

TEXTS = {r"\text", r"\textrm", r"\textup", r"\textnormal", r"\textbf", r"\textit", r"\mbox"}
FONTS = "mathrm mathbf mathit mathsf mathtt mathbb mathcal mathscr mathfrak mathnormal boldsymbol bm "
STRUCTURES = """
    frac dfrac tfrac cfrac binom sqrt overset underset stackrel boxed phantom hphantom vphantom displaystyle textstyle
    limits nolimits underbrace overbrace overline underline xrightarrow xleftarrow
    dot ddot dddot hat tilde bar vec check breve acute grave widehat widetilde overrightarrow
    quad qquad enspace thinspace space bmod pmod lim max min sup inf limsup liminf det gcd Pr
"""
ESCAPES = {"\\" + character for character in "{}|%_&#$ ,:;!>"}
COMMANDS = {"\\" + name for name in (FONTS + STRUCTURES).split()} | ESCAPES | set(FUNCTIONS)

SPELLED = {
    r"\arg": r"\operatorname{arg}",
    r"\sim": "∼",
    r"\iff": r"\Leftrightarrow",
    r"\implies": r"\Rightarrow",
    r"\thinspace": r"\,",
}
r"""Rewritten, since latex2mathml draws something else: `\sim` as a tilde, long arrows as letters."""

MATRICES = {"matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "smallmatrix", "cases"}
ENVIRONMENTS = {
    **{name: name for name in (*MATRICES, "array")},
    **dict.fromkeys(("aligned", "align", "align*", "split"), "split"),
    **dict.fromkeys(("gathered", "gather", "gather*"), "matrix"),
    "dcases": "cases",
}
IN_DISPLAY_STYLE = {"gathered", "gather", "gather*", "dcases"}


def is_known(command: str) -> bool:
    """Whether the command is of our list, an environment, an operator's name, or the name of a character."""
    if command in COMMANDS or (command.startswith(r"\operatorname") and command[-1] == "}"):
        return True
    code = convert_symbol(command)
    if code is None or command in CONVERSION_MAP:
        return False
    return unicodedata.category(chr(int(code, 16)))[0] not in "CMZ"  # no controls, accents or spaces
