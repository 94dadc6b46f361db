"""Matrices with numbers in the boxes of a diagram: their entries, and a layout that makes room for them."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

from solver.figures.layout import Block, Item, Layout, Wire
from solver.formula.terminal import flat

LINE, LETTER, MARGIN = 0.5, 0.17, 0.28
"""Height of a line, width of a letter, and what stands around an entry."""

MATRIX = re.compile(r"\\begin\{bmatrix\}(.*)\\end\{bmatrix\}")

Span = tuple[float, float, float]
"""From where to where a box reaches, and how long it must be."""


def entries_of(text: str) -> list[list[str]]:
    """Return the entries of a matrix in LaTeX, row by row; none where it is no matrix."""
    found = MATRIX.fullmatch(text)
    return [[entry.strip() for entry in row.split("&")] for row in found[1].split(r"\\")] if found else []


def widths_of(entries: Sequence[Sequence[str]]) -> list[float]:
    """Return the widths of the columns."""
    return [max(LETTER * len(flat(entry)) for entry in column) + MARGIN for column in zip(*entries, strict=True)]


def grown(layout: Layout) -> Layout:
    """Return the layout with each box as large as the matrix in it needs; what stands beside moves along."""
    needs = {i: _size(item) for i, item in enumerate(layout.items) if isinstance(item, Block) and entries_of(item.text)}
    if not needs:
        return layout
    blocks = [item for item in layout.items if isinstance(item, Block)]
    sizes = [_size(block) if entries_of(block.text) else (block.width, block.height) for block in blocks]
    across = _stretch([(b.x - b.width / 2, b.x + b.width / 2, size[0]) for b, size in zip(blocks, sizes, strict=True)])
    up = _stretch([(b.y - b.height / 2, b.y + b.height / 2, size[1]) for b, size in zip(blocks, sizes, strict=True)])
    return Layout([_moved(item, across, up) for item in layout.items])


def _size(block: Block) -> tuple[float, float]:
    entries = entries_of(block.text)
    return max(block.width, sum(widths_of(entries)) + MARGIN), max(block.height, LINE * len(entries) + MARGIN)


def _stretch(spans: Iterable[Span]) -> Callable[[float], float]:
    """Return a rising function of a coordinate by which each span becomes as long as it must be."""
    halves = [half for a, b, need in spans for half in ((a, (a + b) / 2, need / 2), ((a + b) / 2, b, need / 2))]
    ends = sorted({round(end, 6) for a, b, _ in halves for end in (a, b)})
    places = {end: i for i, end in enumerate(ends)}
    lengths = [b - a for a, b in pairwise(ends)]
    for a, b, need in sorted(halves, key=lambda half: half[1] - half[0]):
        inside = range(places[round(a, 6)], places[round(b, 6)])
        missing = need - sum(lengths[i] for i in inside)
        if missing > 0:
            for i in inside:
                lengths[i] += missing * (ends[i + 1] - ends[i]) / (b - a)
    moved = [ends[0]]
    for length in lengths:
        moved.append(moved[-1] + length)

    def at(x: float) -> float:
        if x <= ends[0] or x >= ends[-1]:
            return x + (moved[-1] - ends[-1] if x >= ends[-1] else 0.0)
        i = bisect_right(ends, x) - 1
        return moved[i] + (x - ends[i]) * (moved[i + 1] - moved[i]) / (ends[i + 1] - ends[i])

    return at


def _moved(item: Item, across: Callable[[float], float], up: Callable[[float], float]) -> Item:
    if isinstance(item, Wire):
        return replace(item, points=tuple((across(x), up(y)) for x, y in item.points))
    if isinstance(item, Block):
        left, right = across(item.x - item.width / 2), across(item.x + item.width / 2)
        low, high = up(item.y - item.height / 2), up(item.y + item.height / 2)
        return replace(item, x=(left + right) / 2, y=(low + high) / 2, width=right - left, height=high - low)
    return replace(item, x=across(item.x), y=up(item.y))
