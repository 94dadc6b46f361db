"""What stands in a row: signs, names of functions, bars, limits and accents, spaced as TeX does it."""

from __future__ import annotations

from xml.etree.ElementTree import Element

from solver.render.mathml.letters import DOTS, THIN

ROWS = {"math", "mrow", "mstyle", "mtd", "msqrt", "mphantom", "mpadded"}
"""Elements whose children stand in a line."""

SCRIPTS = {"msub", "msup", "msubsup", "munder", "mover", "munderover"}

SIGNS = set("−+±∓")
CLOSING = set(")]}⟩⌋⌉!′″‴")

LIMIT_NAMES = {"lim", "max", "min", "sup", "inf", "det", "gcd", "Pr"}
LARGE_OPERATORS = set("∑∏⋃⋂")

ACCENTS = {"^": "ˆ", "~": "˜", "⃛": "˙˙˙"}
"""Accents of one letter, in the shapes that sit right above it."""

DOTS_ABOVE = "˙¨⃛"
DOTLESS = {"i": "𝚤", "j": "𝚥"}

WIDE = {"^": "\u0302", "~": "\u0303", "―": "‾", "̲": "_"}
"""Accents of any width: math fonts have long shapes of these characters only."""


def pair_bars(row: Element) -> None:
    """Bare bars in a row, if their number is even, open and close in turn."""
    bars = [child for child in row if child.tag == "mo" and child.text in {"|", "‖"} and "form" not in child.attrib]
    if row.tag in ROWS and bars and len(bars) % 2 == 0:
        for index, bar in enumerate(bars):
            bar.attrib = {"stretchy": "false", "fence": "true", "form": "postfix" if index % 2 else "prefix"}


def keep_relations(row: Element) -> None:
    """Words beside one relation (verdict = stable) become letters: among mere text its own space would be left out."""
    if row.tag in ROWS and [child.tag for child in row if child.tag not in {"mtext", "mspace"}] == ["mo"]:
        for child in row:
            if child.tag == "mtext" and not child.attrib:
                child.tag, child.attrib = "mi", {"mathvariant": "normal"}


def set_signs(row: Element) -> None:
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


def space_function_names(row: Element) -> None:
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
    """Whether a function's name keeps its distance from it: not from a bracket, a sign or another space."""
    if _is_function(element) or element.find("mtable") is not None:
        return True
    if element.tag in {"mrow", *SCRIPTS} and len(element):
        return _takes_space(element[0])
    return element.tag not in {"mo", "mspace"}


def _ends_operand(element: Element) -> bool:
    return element.tag != "mspace" and not _is_function(element) and _is_operand(element)


def plain_names(parent: Element) -> None:
    """A name without limits is an identifier: as an operator it would be spaced like a sign."""
    for element in parent:
        if element.tag == "mo" and "lspace" not in element.attrib and _is_function(element):
            element.tag, element.attrib = "mi", {}


def set_limits(element: Element) -> None:
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


def set_accents(element: Element) -> None:
    """Accents sit close to their letter; bars, wide hats and braces stretch over it."""
    if element.tag not in {"mover", "munder"} or len(element) != 2 or element[1].tag != "mo":
        return
    mark = element[1]
    text = mark.text or ""
    if text in "⏞⏟→":
        mark.attrib = {"stretchy": "true"}
    elif text in "―̲" or (text in "^~" and element[0].tag == "mrow"):
        mark.text, mark.attrib = WIDE[text], {"stretchy": "true"}
    elif text in "^~¯˙¨⃛˘ˇ´`":
        mark.text, mark.attrib = ACCENTS.get(text, text), {"stretchy": "false"}
        if text in DOTS_ABOVE:
            mark.set("style", "padding-bottom:0.08em")  # else they touch the letter
        element[0].text = DOTLESS.get(element[0].text or "", element[0].text)
    else:
        return
    if text not in "⏞⏟":
        element.set("accent" if element.tag == "mover" else "accentunder", "true")


def tighten_scripts(element: Element) -> None:
    """No space around signs in exponents, indices and limits."""
    if element.tag in SCRIPTS and "accent" not in element.attrib:
        for script in element[1:]:
            for sign in script.iter("mo"):
                if "lspace" not in sign.attrib and "stretchy" not in sign.attrib:
                    sign.attrib |= {"lspace": "0em", "rspace": "0em"}
