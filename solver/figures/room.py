"""Where the axes of a plot stand in their figure: at once, from what is written around them.

Matplotlib's layout engines draw everything twice to find the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from solver.figures.axis_marks import numbers_of, text_size

POINTS, BETWEEN = 72, 0.1
EDGE, TICK, LINE, DIGIT = 4.0, 7.0, 15.0, 5.3
BELOW = 2
"""Columns of a legend below the axes."""
SAMPLE_OF_CURVE = 42.0
"""What stands in a legend beside its words."""


def give_room(canvas: Any, legends: Sequence[str]) -> None:
    """Place the axes of a figure, one below the other with one abscissa; each legend is "below", "beside" or "" within.

    The size of the figure stays; what is wide beside one of the axes narrows all.
    """
    rooms = [_room(axes, legend) for axes, legend in zip(canvas.axes, legends, strict=True)]
    width, height = (POINTS * side for side in canvas.get_size_inches())
    left, right = (max(room[side] for room in rooms) for side in (0, 2))
    bottom, top = rooms[-1][1], rooms[0][3]
    canvas.subplots_adjust(
        left=left / width, bottom=bottom / height, right=1 - right / width, top=1 - top / height, hspace=BETWEEN
    )


def _room(axes: Any, legend: str) -> tuple[float, float, float, float]:
    """What is needed left of the axes, below, right and above."""
    _, labels, offset = numbers_of(axes.yaxis)
    left = EDGE + TICK + DIGIT * max(map(len, labels), default=0) + LINE * bool(axes.get_ylabel())
    bottom = EDGE + TICK + LINE + LINE * bool(axes.get_xlabel())
    top = EDGE + LINE * bool(offset)
    right = EDGE + DIGIT
    names = [each.get_text() for each in axes.get_legend().get_texts()] if legend else []
    if legend == "beside":
        right += SAMPLE_OF_CURVE + max(map(text_width, names))
    elif legend == "below":
        bottom += LINE * -(-len(names) // BELOW)
    return left, bottom, right, top


def text_width(text: str) -> float:
    """Return how wide a text with formulas is, in points."""
    return text_size(text)[0]
