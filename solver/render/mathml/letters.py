"""Letters and operators: told apart by what they mean, and given the characters of their shape.

latex2mathml goes by blocks of Unicode, so that ∞ is an operator and ± a letter. MathML Core knows no shape of letter
but upright; bold, script and blackboard letters are characters of their own.
"""

from __future__ import annotations

import unicodedata
from xml.etree.ElementTree import Element

from solver.render.mathml.commands import LEFT_BAR, LEFT_DOUBLE_BAR, RIGHT_BAR, RIGHT_DOUBLE_BAR

ORDINARY = set("∞∅∂∇⊤⊥∠∘°†⊺ℵ¬∀∃")
"""Operators by their code points, letters by their use."""

DOTS = set("…⋯")

BARS = {
    LEFT_BAR: ("|", "prefix"),
    RIGHT_BAR: ("|", "postfix"),
    LEFT_DOUBLE_BAR: ("‖", "prefix"),
    RIGHT_DOUBLE_BAR: ("‖", "postfix"),
}

SHAPES = {
    "bold": "BOLD",
    "bold-italic": "BOLD ITALIC",
    "italic": "ITALIC",
    "script": "SCRIPT",
    "fraktur": "FRAKTUR",
    "double-struck": "DOUBLE-STRUCK",
    "sans-serif": "SANS-SERIF",
    "monospace": "MONOSPACE",
}
TEXT_SHAPES = {"bold": "font-weight:bold", "italic": "font-style:italic"}

THIN = "0.167em"


def shape_letters(element: Element) -> None:
    """Bold, script, blackboard … letters are characters of their own in MathML Core."""
    shape = element.attrib.get("mathvariant", "normal")
    text = element.text or ""
    if element.tag == "mtext":
        element.attrib.pop("mathvariant", None)
        if shape in TEXT_SHAPES:
            element.set("style", TEXT_SHAPES[shape])
    elif shape != "normal":
        del element.attrib["mathvariant"]
        element.text = "".join(_shaped(character, shape) for character in text)
    elif element.tag == "mi" and len(text) == 1 and "Α" <= text <= "Ω":
        element.set("mathvariant", "normal")  # capital Greek letters are upright, as in TeX


def _shaped(character: str, shape: str) -> str:
    """Return the character in that shape, or as it is if Unicode has none."""
    name = unicodedata.name(character, "")
    name = name.replace("LATIN ", "").replace("GREEK ", "").replace("LETTER ", "")
    style = "BOLD" if shape == "bold-italic" and "Α" <= character <= "Ω" else SHAPES.get(shape, "")
    names = (f"MATHEMATICAL {style} {name}", f"{style.replace('FRAKTUR', 'BLACK-LETTER')} {name}")
    for each in names:
        try:
            return unicodedata.lookup(each)
        except KeyError:
            continue
    return character


def join_upright_letters(element: Element) -> None:
    r"""`\mathrm{rank}` is a word, not a product."""
    letters = list(element)
    if element.tag == "mrow" and len(letters) > 1 and all(_is_upright(letter) for letter in letters):
        element.tag = "mi"
        element.text = "".join(letter.text or "" for letter in letters)
        element.set("mathvariant", "normal")
        for letter in letters:
            element.remove(letter)


def _is_upright(element: Element) -> bool:
    return element.tag in {"mi", "mn"} and element.get("mathvariant") == "normal" and len(element.text or "") == 1


def tell_operators_from_letters(element: Element) -> None:
    """Tell operators from letters by what they mean; latex2mathml goes by the block of Unicode."""
    text = element.text or ""
    if element.tag not in {"mi", "mo"} or len(text) != 1:
        return
    if text in ORDINARY:
        element.tag, element.attrib = "mi", {"mathvariant": "normal"}
    elif text in DOTS:
        element.tag, element.attrib = "mo", {"lspace": THIN, "rspace": THIN}
    elif text in BARS:
        bar, form = BARS[text]
        element.tag, element.text = "mo", bar
        element.attrib = {"stretchy": "false", "fence": "true", "form": form}
    elif element.tag == "mi" and unicodedata.category(text) in {"Sm", "Ps", "Pe"}:
        element.tag = "mo"
        if unicodedata.category(text) != "Sm":
            element.set("stretchy", "false")
    elif text == "/" and not element.attrib:
        element.attrib = {"lspace": "0em", "rspace": "0em"}
