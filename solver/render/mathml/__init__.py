r"""MathML of our formulas: escaped, drawn by any browser, or refused.

`latex2mathml.converter.convert` lets markup through (`\text{<svg …>}`) and is not used. The tree it builds from
checked LaTeX is repaired, held against a list of elements and attributes, and written here, everything escaped.
"""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape
from itertools import zip_longest
from typing import NamedTuple
from xml.etree.ElementTree import Element

from latex2mathml.converter import convert_to_element

from solver.render.mathml.source import MathError, normalised
from solver.render.mathml.tree import repair

__all__ = ["Formula", "MathError", "formula", "mathml"]

CHILDREN = {
    **dict.fromkeys(("msub", "msup", "mfrac", "mroot", "munder", "mover"), 2),
    **dict.fromkeys(("msubsup", "munderover"), 3),
    **dict.fromkeys(("mi", "mn", "mo", "mtext", "mspace"), 0),
}
"""Elements with a fixed number of children."""

ELEMENTS = {*CHILDREN, "math", "mrow", "mstyle", "msqrt", "mpadded", "mphantom", "mtable", "mtr", "mtd"}

TRUTH = re.compile("true|false")
LENGTH = re.compile(r"[+-]?\d*\.?\d+(em|px)?")
ATTRIBUTES = {
    **dict.fromkeys(("stretchy", "fence", "movablelimits", "largeop", "accent", "accentunder", "displaystyle"), TRUTH),
    **dict.fromkeys(("lspace", "rspace", "minsize", "maxsize", "width", "height", "depth", "linethickness"), LENGTH),
    "form": re.compile("prefix|infix|postfix"),
    "mathvariant": re.compile("normal"),
    "scriptlevel": re.compile(r"\d"),
    "style": re.compile(r"[a-z]+(-[a-z]+)?:-?[a-z0-9. -]+(;[a-z]+(-[a-z]+)?:-?[a-z0-9. -]+)*"),
}


class Formula(NamedTuple):
    """A drawn formula: its markup, and roughly how wide it will be in em."""

    markup: str
    width: float


def mathml(latex: str, display: bool = False) -> str:
    """Return a `<math>` element; raises MathError if the LaTeX is not of our dialect."""
    return formula(latex, display).markup


@lru_cache(maxsize=8192)
def formula(latex: str, display: bool = False) -> Formula:
    """Return the drawn formula; raises MathError if the LaTeX is not of our dialect."""
    source = normalised(latex)
    try:
        math = convert_to_element(source, display="block" if display else "inline")
    except Exception as error:  # latex2mathml raises StopIteration, IndexError, RecursionError and a dozen of its own
        raise MathError(f"the formula cannot be read ({type(error).__name__})") from error
    repair(math)
    math.attrib = {"display": "block"} if display else {}
    alternative = " ".join(latex.split())
    return Formula(_written(math, f' alttext="{escape(alternative)}"'), _width(math))


def _written(element: Element, extra: str = "") -> str:
    """Serialise an element that is on the list; raises MathError for anything else."""
    tag = element.tag
    if tag not in ELEMENTS or CHILDREN.get(tag, len(element)) != len(element):
        raise MathError(f"the formula needs an element that is not drawn everywhere: {tag}")
    for name, value in element.attrib.items():
        if not (name == "display" and tag == "math") and not (name in ATTRIBUTES and ATTRIBUTES[name].fullmatch(value)):
            raise MathError(f"the formula needs an attribute that is not drawn everywhere: {name}={value!r}")
    attributes = "".join(f' {name}="{escape(value)}"' for name, value in element.attrib.items())
    content = escape(element.text or "", quote=False) + "".join(_written(child) for child in element)
    return f"<{tag}{attributes}{extra}>{content}</{tag}>"


def _width(element: Element) -> float:
    """Estimate the width in em: enough to know which formulas may not fit on a narrow screen."""
    widths = [_width(child) for child in element]
    match element.tag:
        case "mi" | "mn" | "mtext":
            width = 0.5 * len(element.text or "")
        case "mo":
            width = 0.4 if "stretchy" in element.attrib else 0.9
        case "mspace":
            width = float((element.get("width") or "0").rstrip("emx"))
        case "mfrac" | "munder" | "mover" | "munderover":
            width = max(widths) + 0.25
        case "msqrt":
            width = sum(widths) + 0.9
        case "msub" | "msup" | "mroot":
            width = widths[0] + 0.7 * widths[1]
        case "msubsup":
            width = widths[0] + 0.7 * max(widths[1:])
        case "mtable":
            columns = zip_longest(*([_width(cell) for cell in row] for row in element), fillvalue=0.0)
            width = sum(0.8 + max(column) for column in columns)
        case _:
            width = sum(widths)
    return width
