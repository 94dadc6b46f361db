"""Repairs of the tree that latex2mathml builds, so that browsers that know MathML Core draw what was meant.

MathML Core dropped lines and alignment of tables, boxes, and all letter shapes but upright; here they become CSS of
our own and the characters of those shapes. Spacing follows TeX: a sign is prefix or binary, a function's name
keeps a thin space, an ordinary symbol is no operator.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from xml.etree.ElementTree import Element

from solver.render.mathml_source import (
    DISPLAY_STYLE,
    HORIZONTAL_LINE,
    LEFT_BAR,
    LEFT_DOUBLE_BAR,
    RIGHT_BAR,
    RIGHT_DOUBLE_BAR,
    VERTICAL_LINE,
)

ROWS = {"math", "mrow", "mstyle", "mtd", "msqrt", "mphantom", "mpadded"}
"""Elements whose children stand in a line."""

SCRIPTS = {"msub", "msup", "msubsup", "munder", "mover", "munderover"}

REFERENCE = re.compile(r"&#x([0-9A-Fa-f]{1,6});")

ORDINARY = set("∞∅∂∇⊤⊥∠∘°†⊺ℵ¬∀∃")
"""Operators by their code points, letters by their use."""

DOTS = set("…⋯")
SIGNS = set("−+±∓")
CLOSING = set(")]}⟩⌋⌉!′″‴") | {RIGHT_BAR, RIGHT_DOUBLE_BAR}
OPENING = set("([{⟨⌊⌈") | {LEFT_BAR, LEFT_DOUBLE_BAR}

LIMIT_NAMES = {"lim", "max", "min", "sup", "inf", "det", "gcd", "Pr", "liminf", "limsup"}
LARGE_OPERATORS = set("∑∏⋃⋂")

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

SPACES = {
    "negativethinmathspace": "-0.167em",
    "thinmathspace": "0.167em",
    "thickmathspace": "0.278em",
}
THIN = "0.167em"

ACCENTS = {"^": "ˆ", "~": "˜", "―": "¯", "¯": "¯", "→": "→", "‾": "¯"}
"""Shapes that sit right above a letter in place of those that do not."""

BOX = "border:1px solid;padding:0.25em 0.4em"
ALIGNMENTS = {"left": "text-align:left", "right": "text-align:right"}


def repair(math: Element) -> None:
    """Repair the tree of a formula in place."""
    for element in math.iter():
        element.text = REFERENCE.sub(lambda match: chr(int(match[1], 16)), element.text or "")
    for visit in VISITS:
        for element in list(math.iter()):
            visit(element)


# -- shape -------------------------------------------------------------------------------------------------------


def _fence_matrices(parent: Element) -> None:
    """Put a matrix and its brackets into a row of their own: brackets stretch with their row, an exponent needs one."""
    children = list(parent)
    for left, body, right in zip(children, children[1:], children[2:], strict=False):
        is_matrix = body.tag == "mtable" and left.tag == right.tag == "mo" and not left.attrib and not right.attrib
        is_binomial = body.tag == "mfrac" and "minsize" in left.attrib and "minsize" in right.attrib
        if is_matrix or is_binomial:
            row = Element("mrow")
            parent.insert(list(parent).index(left), row)
            for element, form in ((left, "prefix"), (body, ""), (right, "postfix")):
                parent.remove(element)
                row.append(element)
                if form:
                    element.attrib = {"stretchy": "true", "fence": "true", "form": form}


def _drop_empty_fences(parent: Element) -> None:
    r"""`\left.` draws nothing; an empty operator would still take its place."""
    for child in list(parent):
        if child.tag == "mo" and not child.text and len(child) == 0:
            parent.remove(child)


def _flatten(parent: Element) -> None:
    """A row of one element is that element; braces around an operator make it an ordinary symbol (`{,}`, `{=}`)."""
    for index, child in enumerate(list(parent)):
        while child.tag == "mrow" and not child.attrib and len(child) == 1 and child[0].tag != "mspace":
            only = child[0]
            if only.tag == "mo" and parent.tag in ROWS:
                only.attrib |= {"lspace": "0em", "rspace": "0em"}
            parent[index] = child = only


def _box(element: Element) -> None:
    if element.tag == "menclose":
        element.tag = "mrow"
        element.attrib = {"style": BOX}


# -- letters -----------------------------------------------------------------------------------------------------


def _letter_shapes(element: Element) -> None:
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


def _join_upright_letters(element: Element) -> None:
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


def _operators_and_letters(element: Element) -> None:
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


# -- rows --------------------------------------------------------------------------------------------------------


def _pair_bars(row: Element) -> None:
    """Bare bars in a row, if their number is even, open and close in turn."""
    bars = [child for child in row if child.tag == "mo" and child.text in {"|", "‖"} and "form" not in child.attrib]
    if row.tag in ROWS and bars and len(bars) % 2 == 0:
        for index, bar in enumerate(bars):
            bar.attrib = {"stretchy": "false", "fence": "true", "form": "postfix" if index % 2 else "prefix"}


def _signs(row: Element) -> None:
    """A sign is prefix at the start of a row and after an operator or an opening bracket."""
    if row.tag not in ROWS:
        return
    before: Element | None = None
    for child in row:
        if child.tag == "mo" and child.text in SIGNS and "form" not in child.attrib and not _is_operand(before):
            child.set("form", "prefix")
        if child.tag != "mspace":
            before = child


def _is_operand(element: Element | None) -> bool:
    """Whether a sign after it is binary."""
    if element is None or _is_function(element):
        return False
    if element.tag == "mo":
        return element.text in CLOSING | DOTS or element.get("form") == "postfix"
    return True


def _is_function(element: Element) -> bool:
    """Whether it is the name of a function or operator (sin, det, adj), perhaps with scripts."""
    if element.tag in SCRIPTS and len(element):
        return _is_function(element[0])
    text = (element.text or "").replace(" ", "").replace("\u2009", "").replace("\u2006", "")
    return element.tag in {"mi", "mo"} and len(text) > 1 and text.isalpha() and "mathvariant" not in element.attrib


def _function_names(row: Element) -> None:
    """Set a thin space between a function's name and an operand beside it, none before a bracket."""
    if row.tag not in ROWS:
        return
    children = list(row)
    for index in range(len(children) - 1, -1, -1):
        if not _is_function(children[index]):
            continue
        if index + 1 < len(children) and _takes_space(children[index + 1]):
            row.insert(index + 1, Element("mspace", {"width": THIN}))
        if index > 0 and _ends_operand(children[index - 1]):
            row.insert(index, Element("mspace", {"width": THIN}))


def _takes_space(element: Element) -> bool:
    """Whether a function's name needs a space before it: not before a bracket, a sign or another space."""
    if element.tag in {"mrow", *SCRIPTS} and len(element):
        return _takes_space(element[0])
    return element.tag not in {"mo", "mspace"}


def _ends_operand(element: Element) -> bool:
    return element.tag != "mspace" and not _is_function(element) and _is_operand(element)


def _plain_names(element: Element) -> None:
    """A name without limits is an identifier: as an operator it would be spaced like a sign."""
    if element.tag == "mo" and "lspace" not in element.attrib and _is_function(element):
        element.tag, element.attrib = "mi", {}


def _limits(element: Element) -> None:
    """Limits of lim, max, det …, of sums and products stand below and above in display style."""
    if element.tag not in SCRIPTS or not len(element) or element[0].tag != "mo":
        return
    base = element[0]
    name = base.text or ""
    if name in LARGE_OPERATORS or name in LIMIT_NAMES or base.get("movablelimits"):
        element.tag = {"msub": "munder", "msup": "mover", "msubsup": "munderover"}.get(element.tag, element.tag)
        base.set("movablelimits", "true")
        if name not in LARGE_OPERATORS:
            base.attrib |= {"lspace": "0em", "rspace": "0em"}


def _accents(element: Element) -> None:
    """Accents sit close to their letter; bars, wide hats and braces stretch over it."""
    if element.tag not in {"mover", "munder"} or len(element) != 2 or element[1].tag != "mo":
        return
    mark = element[1]
    text = mark.text or ""
    if text in "⏞⏟→" or (text in "_̲" and element.tag == "munder"):
        mark.attrib = {"stretchy": "true"}
        mark.text = "_" if text == "̲" else text
    elif text in "^~―¯˙¨⃛˘ˇ´`‾":
        wide = text == "―" or (text in "^~" and element[0].tag == "mrow")
        mark.attrib = {"stretchy": "true" if wide else "false"}
        mark.text = ACCENTS.get(text, text)
        element.set("accent", "true")


def _labelled_arrows(element: Element) -> None:
    r"""`\xrightarrow{a}`: the arrow is as long as its label and a little more."""
    if element.tag == "mover" and len(element) and element[0].tag == "mstyle" and len(element[0]) == 1:
        arrow, label = element[0][0], element[1]
        if arrow.tag == "mo" and arrow.text in {"→", "←"}:
            arrow.set("stretchy", "true")
            element[0] = arrow
            label.tag, label.attrib = "mrow", {}
            label[-1].attrib = {"width": "0.5em"}
            label.insert(0, Element("mspace", {"width": "0.5em"}))


def _spaces(element: Element) -> None:
    width = element.get("width", "")
    if element.tag == "mspace" and width in SPACES:
        element.set("width", SPACES[width])


# -- tables ------------------------------------------------------------------------------------------------------


def _table(table: Element) -> None:
    """Turn alignment and lines into styles of the cells."""
    if table.tag != "mtable":
        return
    display = table.get("displaystyle") == "true"
    aligned = table.get("columnspacing") == "0em"
    table.attrib = {"displaystyle": "true"} if display else {}
    styles: dict[Element, list[str]] = {}
    lines: set[int] = set()
    above: Element | None = None
    for row in list(table):
        marks = _take_marks(row)
        lines |= {ord(mark) - ord(VERTICAL_LINE) for mark in marks if mark >= VERTICAL_LINE}
        if DISPLAY_STYLE in marks:
            table.set("displaystyle", "true")
        bare = HORIZONTAL_LINE in marks and len(row) == 1 and len(row[0]) == 0 and above is not None
        if HORIZONTAL_LINE in marks:
            lined, side = (above, "bottom") if bare and above is not None else (row, "top")
            for cell in lined:
                styles.setdefault(cell, []).append(f"border-{side}:1px solid")
        if bare:
            table.remove(row)
        else:
            above = row
    for row in table:
        for column, cell in enumerate(row):
            _style_cell(cell, styles.get(cell, []), column, lines, aligned)


def _take_marks(row: Element) -> str:
    """Remove the marks at the start of a row and return them."""
    marks = ""
    while len(row) and len(row[0]) and (found := _marks(row[0][0])):
        marks += found
        row[0].remove(row[0][0])
    return marks


def _marks(element: Element) -> str:
    """Return the text of an element that holds nothing but marks, else nothing."""
    text = "".join(element.itertext())
    return text if all(HORIZONTAL_LINE <= character <= "\uf8ff" for character in text) else ""


def _style_cell(cell: Element, styles: list[str], column: int, lines: set[int], aligned: bool) -> None:
    alignment = ALIGNMENTS.get(cell.get("columnalign", ""))
    styles = [*([alignment] if alignment else []), *styles]
    if aligned:  # the two halves of an equation touch, pairs of columns stand apart
        styles.append("padding-left:0" if column % 2 else "padding-right:0")
        if column and column % 2 == 0:
            styles.append("padding-left:2em")
    if column + 1 in lines:
        styles.append("border-right:1px solid")
    if column == 0 and 0 in lines:
        styles.append("border-left:1px solid")
    cell.attrib = {"style": ";".join(styles)} if styles else {}


VISITS: tuple[Callable[[Element], None], ...] = (
    _table,
    _fence_matrices,
    _drop_empty_fences,
    _box,
    _labelled_arrows,
    _join_upright_letters,
    _flatten,
    _letter_shapes,
    _operators_and_letters,
    _pair_bars,
    _limits,
    _plain_names,
    _accents,
    _signs,
    _function_names,
    _spaces,
)
"""In this order: the shape of the tree first, then letters, then what depends on neighbours."""
