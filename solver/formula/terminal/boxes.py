"""Blocks of text with a baseline, put side by side, above one another and between brackets: formulas on a terminal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from unicodedata import category, east_asian_width

TALL = {
    **{"(": "⎛⎜⎝", ")": "⎞⎟⎠", "[": "⎡⎢⎣", "]": "⎤⎥⎦", "|": "│││", "‖": "‖‖‖"},
    **{"⌊": "⎢⎢⎣", "⌋": "⎥⎥⎦", "⌈": "⎡⎢⎢", "⌉": "⎤⎥⎥"},
}
"""Top, middle and bottom of brackets that are higher than a line; braces have a point of their own."""

BRACES = {"{": "⎧⎪⎨⎩", "}": "⎫⎪⎬⎭"}


def cells(text: str) -> int:
    """Return the number of cells of a terminal that a text takes."""
    return len(text) if text.isascii() else _cells_of_all(text)


@lru_cache(maxsize=1024)  # a column is asked for its width again and again
def _cells_of_all(text: str) -> int:
    return sum(map(_cells_of, text))


@lru_cache(maxsize=1024)
def _cells_of(letter: str) -> int:
    return 0 if category(letter) in {"Mn", "Me"} else 2 if east_asian_width(letter) in "WF" else 1


def padded(text: str, width: int, align: str = "l") -> str:
    """Return the text with spaces to a width, by alignment l, c or r."""
    missing = max(0, width - cells(text))
    before = {"l": 0, "c": missing // 2, "r": missing}[align]
    return " " * before + text + " " * (missing - before)


@dataclass(frozen=True, slots=True)
class Box:
    """Lines of equal width; `baseline` is the index of the line that stands level with the neighbours'."""

    lines: tuple[str, ...]
    baseline: int = 0

    @property
    def width(self) -> int:
        """Cells of a line."""
        return cells(self.lines[0])

    @property
    def height(self) -> int:
        """Number of lines."""
        return len(self.lines)

    @property
    def flat(self) -> str:
        """The text of a box of one line."""
        return " ".join(self.lines)


@lru_cache(maxsize=1024)  # most are letters, numbers and signs
def text_box(text: str) -> Box:
    """Return a box of one line."""
    return Box((text,))


def stacked(boxes: Sequence[Box], baseline: int, align: str = "c") -> Box:
    """Put boxes above one another; `baseline` counts the lines of the whole."""
    width = max((box.width for box in boxes), default=0)
    return Box(tuple(padded(line, width, align) for box in boxes for line in box.lines), baseline)


def beside(boxes: Sequence[Box]) -> Box:
    """Put boxes side by side, baselines level."""
    if len(boxes) < 2:
        return boxes[0] if boxes else text_box("")
    if {len(box.lines) for box in boxes} == {1}:  # most are letters and numbers in a row
        return text_box("".join([box.lines[0] for box in boxes]))
    above, below = _around_baseline(boxes)
    columns = []
    for box in boxes:
        blank = " " * box.width
        start = above - box.baseline
        columns.append([blank] * start + list(box.lines) + [blank] * (above + below - start - box.height))
    return Box(tuple("".join(row) for row in zip(*columns, strict=True)), above)


def _around_baseline(boxes: Sequence[Box]) -> tuple[int, int]:
    """Return how many lines boxes side by side have above the baseline, and from it on."""
    return max(box.baseline for box in boxes), max(box.height - box.baseline for box in boxes)


def fraction(numerator: Box, denominator: Box) -> Box:
    """Return numerator over denominator with a bar between them."""
    bar = text_box("─" * max(numerator.width, denominator.width))
    return stacked([numerator, bar, denominator], numerator.height)


def scripted(base: Box, above: Box | None, below: Box | None) -> Box:
    """Put a superscript above and a subscript below at the right of a base."""
    width = max(box.width for box in (above, below) if box is not None)
    blank = Box((" " * width,) * base.height)
    column = stacked([box for box in (above, blank, below) if box is not None], 0, "l")
    return beside([base, Box(column.lines, base.baseline + (above.height if above else 0))])


def enclosed(box: Box, left: str, right: str) -> Box:
    """Put brackets around, as high as the box; "." and "" are none."""
    return beside([_bracket(left, box), box, _bracket(right, box)])


def _bracket(bracket: str, box: Box) -> Box:
    if bracket in {".", ""}:
        return text_box("")
    height = box.height
    if height == 1:
        return text_box(bracket)
    if bracket in BRACES:
        top, middle, point, bottom = tuple(BRACES[bracket])
        inner = [middle] * (height - 2)
        if height == 2:
            return Box((top, bottom), box.baseline)
        inner[(height - 2) // 2] = point
        return Box((top, *inner, bottom), box.baseline)
    top, middle, bottom = tuple(TALL.get(bracket, bracket * 3))
    return Box((top, *[middle] * (height - 2), bottom), box.baseline)


def grid(rows: Sequence[Sequence[Box]], aligns: str, gaps: Sequence[str], rules: Sequence[int] = ()) -> Box:
    """Put boxes in rows and columns; `aligns` has a letter and `gaps` the text before it for every column.

    A line is drawn before each of the rows `rules` (counted from 0; as many as there are rows: below the last).
    """
    widths = [max(row[j].width for row in rows) for j in range(len(rows[0]))]
    drawn = [_row([aligned(*each) for each in zip(row, widths, aligns, strict=True)], gaps) for row in rows]
    line = "".join(_crossed(gap) + "─" * width for gap, width in zip(gaps, widths, strict=True))
    for index in sorted(set(rules), reverse=True):
        drawn.insert(index, text_box(line))
    height = sum(row.height for row in drawn)
    return stacked(drawn, (height - 1) // 2)


def _crossed(gap: str) -> str:
    """Return a gap between columns as a line across goes through it."""
    return "".join("┼" if mark == "│" else "─" for mark in gap)


def aligned(box: Box, width: int, align: str) -> Box:
    """Return the box with all lines padded to a width."""
    missing = " " * (width - box.width)
    half = len(missing) // 2
    before, after = {"l": ("", missing), "c": (missing[:half], missing[half:]), "r": (missing, "")}[align]
    return Box(tuple(before + line + after for line in box.lines), box.baseline)


def _row(boxes: Sequence[Box], gaps: Sequence[str]) -> Box:
    """Put boxes side by side, each after its gap, which is as high as the highest of them."""
    above, below = _around_baseline(boxes)
    between = [Box((gap,) * (above + below), above) for gap in gaps]
    return beside([part for pair in zip(between, boxes, strict=True) for part in pair])
