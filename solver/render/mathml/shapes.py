r"""Formulas drawn by their shape: `36e^{-7t} - 63e^{-8t}` is drawn as `9e^{-7t} - 5e^{-2t}` was, with other numbers.

latex2mathml is slow, and the formulas of a page differ in little but their numbers. So numbers and the entries of
matrices are taken out, the shape that is left is drawn once, and they are put into their places in the markup. Each
stands in the shape as a number that is found again; a shape in which one gets lost (`x^12`, digits in text) is not
used, and the formula is drawn as a whole, with the same markup.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple
from xml.etree.ElementTree import Element

from latex2mathml.converter import convert_to_element

from solver.render.mathml.source import MathError, normalised
from solver.render.mathml.tree import repair
from solver.render.mathml.writing import Extent, extent, width, written

FIRST = 90_000
"""The number that stands for the first piece taken out; the next ones follow, at most 9,999."""

SLOT = re.compile(r"<mn>(9\d{4})</mn>")

MATRIX = re.compile(r"(\\begin\{([bpvBV]?matrix)\})((?:[^\\]|\\(?!begin|end))*)(\\end\{\2\})")
"""A matrix that holds no other environment."""

BETWEEN_ENTRIES = re.compile(r"((?<!\\)&|\\\\(?:\s*\[[^\]]*\])?)")

ENTRY = "\ue020"
"""Stands for an entry until it gets its number; no formula may hold this character."""

OPEN = re.compile(rf"\\[a-z]*text[a-z]*\s*\{{[^{{}}]*\}}|\\\\\s*\[[^\]]*\]|(?P<open>{ENTRY}|(?<![\d.])\d+(?:\.\d+)?)")
"""What is passed over (words, gaps between rows), and what is taken out."""


class Piece(NamedTuple):
    """Markup to stand in a row, and roughly how wide it will be in em."""

    markup: str
    width: float


@dataclass(frozen=True, slots=True)
class Shape:
    """Markup around the slots, the number in each slot, how wide that will be, how many pieces it holds.

    It holds −1 pieces if their slots are not 0, 1, …, each once.
    """

    markup: tuple[str, ...]
    slots: tuple[int, ...]
    extent: Extent
    holds: int


@lru_cache(maxsize=8192)
def piece(latex: str, entry: bool = False) -> Piece:
    """Draw a formula, or an entry of a matrix, without private-use characters.

    Raises MathError if it is not of our dialect.
    """
    try:
        outline, contents = _taken_apart(latex)
        shape = _shape(outline, entry)
    except MathError:  # perhaps an entry that is none, as in \text{a & b}; the whole formula says what is wrong
        shape = None
    if shape is None or shape.holds != len(contents):
        return whole(latex, entry)
    filled = [shape.markup[0]]
    for slot, markup in zip(shape.slots, shape.markup[1:], strict=True):
        filled += (contents[slot].markup, markup)
    widths = {str(FIRST + slot): content.width for slot, content in enumerate(contents)}
    return Piece("".join(filled), width(shape.extent, widths))


def whole(latex: str, entry: bool = False) -> Piece:
    """Draw a formula, or an entry, without taking it apart; raises MathError."""
    tree = _tree(latex, entry)
    return Piece(written(tree), width(extent(tree), {}))


def _taken_apart(latex: str) -> tuple[str, list[Piece]]:
    """Return the formula with numbers in place of its numbers and of the entries of matrices, and what they were."""
    entries: list[Piece] = []

    def without_entries(matrix: re.Match[str]) -> str:
        return matrix[1] + "".join(map(without_entry, BETWEEN_ENTRIES.split(matrix[3]))) + matrix[4]

    def without_entry(entry: str) -> str:
        if not entry.strip() or BETWEEN_ENTRIES.fullmatch(entry):
            return entry
        entries.append(piece(entry.strip(), entry=True))
        return f" {ENTRY} "

    contents: list[Piece] = []
    rest = iter(entries)

    def opened(match: re.Match[str]) -> str:
        taken = match["open"]
        if taken is None:
            return match[0]
        contents.append(next(rest) if taken == ENTRY else Piece(f"<mn>{taken}</mn>", 0.5 * len(taken)))
        return str(FIRST + len(contents) - 1)

    outline = OPEN.sub(opened, MATRIX.sub(without_entries, latex))
    if next(rest, None) is not None:
        raise MathError("an entry of a matrix stands in words")
    return outline, contents


@lru_cache(maxsize=4096)
def _shape(outline: str, entry: bool) -> Shape:
    tree = _tree(outline, entry)
    markup = SLOT.split(written(tree))
    numbers = markup[1::2]
    slots = tuple(int(number) - FIRST for number in numbers)
    holds = len(slots) if sorted(slots) == list(range(len(slots))) else -1
    return Shape(tuple(markup[::2]), slots, extent(tree, numbers), holds)


def _tree(latex: str, entry: bool = False) -> Element:
    """Return the element that holds a formula, repaired; for an entry that is the cell of a matrix."""
    source = normalised(rf"\begin{{matrix}}{latex}\end{{matrix}}" if entry else latex)
    try:
        math = convert_to_element(source)
    except Exception as error:  # latex2mathml raises StopIteration, IndexError, RecursionError and a dozen of its own
        raise MathError(f"the formula cannot be read ({type(error).__name__})") from error
    repair(math)
    if not entry:
        return math
    cell = next(math.iter("mtd"), None)
    if cell is None or cell.attrib:
        raise MathError("the entry of a matrix is no formula")
    return cell
