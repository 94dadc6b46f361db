"""The tree of a formula as markup: only what is on the list, everything escaped; and how wide it will be."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from html import escape
from itertools import zip_longest
from typing import NamedTuple
from xml.etree.ElementTree import Element

from solver.render.mathml.source import MathError

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


def written(element: Element) -> str:
    """Serialise what stands in an element; raises MathError for what is not on the list."""
    return escape(element.text or "", quote=False) + "".join(map(_whole, element))


def _whole(element: Element) -> str:
    tag = element.tag
    if tag not in ELEMENTS or CHILDREN.get(tag, len(element)) != len(element):
        raise MathError(f"the formula needs an element that is not drawn everywhere: {tag}")
    attributes = ""
    for name, value in element.attrib.items():
        if not (name in ATTRIBUTES and ATTRIBUTES[name].fullmatch(value)):
            raise MathError(f"the formula needs an attribute that is not drawn everywhere: {name}={value!r}")
        attributes += f' {name}="{escape(value)}"'
    return f"<{tag}{attributes}>{written(element)}</{tag}>"


class Group(NamedTuple):
    """An element whose width depends on what stands in it."""

    tag: str
    parts: list[Extent]


class Table(NamedTuple):
    """The cells of a matrix, row by row."""

    rows: list[list[Extent]]


Extent = float | str | Group | Table
"""How wide something is: so many em, or as wide as what a number stands for, or as its parts make it."""


def extent(element: Element, slots: Collection[str] = ()) -> Extent:
    """Return how wide an element will be, roughly; `slots` are the numbers that stand for something else."""
    text = element.text or ""
    match element.tag:
        case "mi" | "mn" | "mtext":
            return text if element.tag == "mn" and text in slots else 0.5 * len(text)
        case "mo":
            return 0.4 if "stretchy" in element.attrib else 0.9
        case "mspace":
            return float((element.get("width") or "0").rstrip("emx"))
        case "mtable":
            return Table([[extent(cell, slots) for cell in row] for row in element])
    parts = [extent(child, slots) for child in element]
    known = [part for part in parts if isinstance(part, float)]
    return _around(element.tag, known) if len(known) == len(parts) else Group(element.tag, parts)


def width(extent: Extent, numbers: Mapping[str, float]) -> float:
    """Estimate the width in em: enough to know which formulas may not fit on a narrow screen."""
    if isinstance(extent, float):
        return extent
    if isinstance(extent, str):
        return numbers[extent]
    if isinstance(extent, Table):
        columns = zip_longest(*([width(cell, numbers) for cell in row] for row in extent.rows), fillvalue=0.0)
        return sum(0.8 + max(column) for column in columns)
    return _around(extent.tag, [width(part, numbers) for part in extent.parts])


def _around(tag: str, widths: list[float]) -> float:
    """Return the width of an element with children of these widths."""
    match tag:
        case "mfrac" | "munder" | "mover" | "munderover":
            return max(widths) + 0.25
        case "msqrt":
            return sum(widths) + 0.9
        case "msub" | "msup" | "mroot":
            return widths[0] + 0.7 * widths[1]
        case "msubsup":
            return widths[0] + 0.7 * max(widths[1:])
    return sum(widths, 0.0)
