"""Symbols and operators as MathML: one element each, with the attributes that browsers need."""

from __future__ import annotations

from functools import lru_cache
from html import escape
from typing import NamedTuple

from solver.formula import vocabulary as v
from solver.formula.mathml.characters import SHAPES, character, is_greek_capital, shaped
from solver.formula.mathml.rows import DOTS
from solver.formula.nodes import Symbol


class Drawing(NamedTuple):
    """Markup, and roughly how wide it will be in em."""

    markup: str
    width: float


UPRIGHT = frozenset(
    (r"\infty", r"\emptyset", r"\varnothing", r"\partial", r"\nabla", r"\top", r"\bot", r"\angle", r"\neg", r"\lnot",
     r"\forall", r"\exists", r"\dagger", r"\Re", r"\Im")
)  # fmt: skip
"""Symbols that are not slanted as letters are."""

UPRIGHT_LETTERS = '<mi mathvariant="normal">'
TIGHT = ' lspace="0em" rspace="0em"'


@lru_cache(maxsize=1024)
def number_drawing(digits: str, shape: str) -> Drawing:
    r"""Draw a number, in the shape of a command such as `\mathbf` if there is one."""
    if shape in SHAPES:
        digits = "".join(shaped(digit, shape) for digit in digits)
    return Drawing(f"<mn>{digits}</mn>", 0.5 * len(digits))


@lru_cache(maxsize=1024)
def symbol_drawing(name: str, shape: str) -> Drawing:
    r"""Draw a symbol, in the shape of a command such as `\mathbf` if there is one."""
    letter = character(name)
    if Symbol(name) in DOTS:
        return Drawing(f'<mo lspace="0.167em" rspace="0.167em">{letter}</mo>', 0.9)
    if name in (r"\vdots", r"\ddots"):
        return Drawing(f"<mo>{letter}</mo>", 0.9)
    if shape in SHAPES:
        return Drawing(f"<mi>{shaped(letter, shape)}</mi>", 0.5)
    upright = name in UPRIGHT or is_greek_capital(letter) or shape == r"\mathrm"
    return Drawing(f"{UPRIGHT_LETTERS if upright else '<mi>'}{escape(letter)}</mi>", 0.5 * len(letter))


@lru_cache(maxsize=1024)
def operator_drawing(sign: str, form: str, tight: bool) -> Drawing:
    """Draw a sign; as a prefix or postfix where its neighbours make it one."""
    mark = escape(character(sign), quote=False)
    if sign in (":", r"\colon"):
        return Drawing(f"<mi>{mark}</mi>", 0.5)
    if sign in v.BRACKETS:
        return Drawing(f'<mo stretchy="false">{mark}</mo>', 0.4)
    if sign in v.BARS:
        form = f' stretchy="false" fence="true" form="{form}"' if form else f' stretchy="false"{TIGHT}'
        return Drawing(f"<mo{form}>{mark}</mo>", 0.4)
    attributes = f' form="{form}"' if form else ""
    if sign in (r"\sum", r"\prod"):
        attributes += ' movablelimits="true"'
    elif tight or sign in "/!":
        attributes += TIGHT
    return Drawing(f"<mo{attributes}>{mark}</mo>", 0.9)
