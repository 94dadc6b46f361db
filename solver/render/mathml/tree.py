"""Repairs of the tree that latex2mathml builds, so that browsers that know MathML Core draw what was meant.

MathML Core dropped lines and alignment of tables, boxes, and all letter shapes but upright; here they become CSS of
our own and the characters of those shapes. Spacing follows TeX: a sign is prefix or binary, a function's name
keeps a thin space, an ordinary symbol is no operator.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from xml.etree.ElementTree import Element

from solver.render.mathml.letters import join_upright_letters, shape_letters, tell_operators_from_letters
from solver.render.mathml.rows import (
    ROWS,
    keep_relations,
    pair_bars,
    plain_names,
    set_accents,
    set_limits,
    set_signs,
    space_function_names,
    tighten_scripts,
)
from solver.render.mathml.tables import style_table

REFERENCE = re.compile(r"&#x([0-9A-Fa-f]{1,6});")

SPACES = {"negativethinmathspace": "-0.167em", "thinmathspace": "0.167em", "thickmathspace": "0.278em"}
"""Names that MathML Core dropped."""

PRIMES = {"′", "″", "‴"}

BOX = "border:1px solid;padding:0.25em 0.4em"


def repair(math: Element) -> None:
    """Repair the tree of a formula in place."""
    for element in math.iter():
        if element.text:
            element.text = REFERENCE.sub(lambda match: chr(int(match[1], 16)), element.text)
    for visits, with_children in ((SHAPE, True), (LETTERS, False), (NEIGHBOURS, True)):
        for visit in visits:
            for element in [each for each in math.iter() if (len(each) > 0) is with_children]:
                visit(element)


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
    for index in range(len(parent)):
        while parent[index].tag == "mrow" and not parent[index].attrib and len(parent[index]) == 1:
            only = parent[index][0]
            if only.tag == "mo" and parent.tag in ROWS:
                only.attrib |= {"lspace": "0em", "rspace": "0em"}
            parent[index] = only


def _box(element: Element) -> None:
    if element.tag == "menclose":
        element.tag = "mrow"
        element.attrib = {"style": BOX}


def _primes(element: Element) -> None:
    """A prime stands after its letter: fonts draw it raised already, and too small in a superscript."""
    if element.tag in {"msup", "msubsup"} and (element[-1].text or "") in PRIMES:
        prime = element[-1]
        prime.tag, prime.attrib = "mo", {"form": "postfix", "lspace": "0em", "rspace": "0em"}
        if element.tag == "msubsup":
            base = Element("msub")
            base.extend(element[:2])
            element[:2] = [base]
        element.tag = "mrow"


def _labelled_arrows(element: Element) -> None:
    r"""`\xrightarrow{a}`: the arrow is as long as its label and a little more."""
    if element.tag == "mover" and len(element) > 1 and element[0].tag == "mstyle" and len(element[0]) == 1:
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


Visits = tuple[Callable[[Element], None], ...]

SHAPE: Visits = (
    style_table,
    _fence_matrices,
    _drop_empty_fences,
    _box,
    _primes,
    _labelled_arrows,
    join_upright_letters,
    _flatten,
)
LETTERS: Visits = (shape_letters, tell_operators_from_letters, _spaces)
NEIGHBOURS: Visits = (
    keep_relations,
    pair_bars,
    set_limits,
    plain_names,
    set_accents,
    set_signs,
    space_function_names,
    tighten_scripts,
)
"""In this order: the shape of the tree, then its leaves, then what depends on neighbours."""
