"""Ticks, their numbers and the grid of axes, each kind drawn at once.

Matplotlib has five artists for each tick, which take half of the time of a figure; what is seen is the same.
"""

from __future__ import annotations

from typing import Any

from matplotlib import transforms
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path
from matplotlib.ticker import NullLocator

from solver.figures.palette import GRID, INK

LENGTH, PAD, LABEL = 3.5, 3.5, 4.0
"""Of a tick, between it and its number, and between the numbers and the name of the axis, in points."""
SIZE = 10.5
GRID_LINE: Any = {"color": GRID, "linewidth": 0.7, "zorder": 0.5}
TICK: Any = {"color": INK, "linewidth": 0.8, "zorder": 2.01, "clip_on": False}
TEXT_ORDER = 3
NEAR = 1e-10
"""What is so little beyond an end of the axis, in parts of its length, is on it."""


def numbers_of(axis: Any) -> tuple[list[float], list[str], str]:
    """Return where an axis has ticks, their numbers, and what is written beside all of them (a power of ten)."""
    low, high = sorted(axis.get_view_interval())
    beyond = NEAR * (high - low)
    locations = [float(x) for x in axis.get_majorticklocs()]
    formatter = axis.get_major_formatter()
    names = formatter.format_ticks(locations)
    there = [(x, name) for x, name in zip(locations, names, strict=True) if low - beyond <= x <= high + beyond]
    return [x for x, _ in there], [name for _, name in there], formatter.get_offset()


def text_size(text: str) -> tuple[float, float]:
    """Return how wide and high a text with formulas is, in points."""
    if not text:
        return 0.0, 0.0
    width, height, _ = text_to_path.get_text_width_height_descent(text, FontProperties(size=SIZE), ismath="$" in text)
    return float(width), float(height)


def mark(every: list[Any]) -> None:
    """Draw the marks of axes one below the other, which stand where they will be drawn; the last has the numbers."""
    for axes in every:
        axes.apply_aspect()
    found = [(numbers_of(axes.xaxis), numbers_of(axes.yaxis)) for axes in every]
    for axes, (across, up) in zip(every, found, strict=True):
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(NullLocator())
        _mark_abscissa(axes, across, numbered=axes is every[-1])
        _mark_ordinate(axes, up)


def _mark_abscissa(axes: Any, marks: tuple[list[float], list[str], str], *, numbered: bool) -> None:
    places, names, offset = marks
    along = axes.get_xaxis_transform()
    axes.vlines(places, 0, 1, transform=along, **GRID_LINE)
    points = transforms.blended_transform_factory(axes.transData, _corner(axes))
    axes.vlines(places, -LENGTH, 0, transform=points, **TICK)
    if not numbered:
        return
    below = along + transforms.Affine2D().translate(0, -LENGTH - PAD)
    for x, name in zip(places, names, strict=True):
        _number(axes, x, 0, name, below, "center", "top")
    height = max((text_size(name)[1] if "$" in name else SIZE for name in names), default=0.0)
    down = LENGTH + PAD + max(height, SIZE)
    if offset:
        corner = axes.transAxes + transforms.Affine2D().translate(0, -down - PAD)
        _number(axes, 1, 0, offset, corner, "right", "top")
    axes.xaxis.set_label_coords(
        0.5, -down - LABEL, transform=transforms.blended_transform_factory(axes.transAxes, _corner(axes))
    )


def _mark_ordinate(axes: Any, marks: tuple[list[float], list[str], str]) -> None:
    places, names, offset = marks
    up = axes.get_yaxis_transform()
    axes.hlines(places, 0, 1, transform=up, **GRID_LINE)
    points = transforms.blended_transform_factory(_corner(axes), axes.transData)
    axes.hlines(places, -LENGTH, 0, transform=points, **TICK)
    beside = up + transforms.Affine2D().translate(-LENGTH - PAD, 0)
    for y, name in zip(places, names, strict=True):
        _number(axes, 0, y, name, beside, "right", "center_baseline")
    if offset:
        above = axes.transAxes + transforms.Affine2D().translate(0, PAD)
        _number(axes, 0, 1, offset, above, "left", "baseline")
    width = max((text_size(name)[0] for name in names), default=0.0)
    axes.yaxis.set_label_coords(
        -LENGTH - PAD - width - LABEL,
        0.5,
        transform=transforms.blended_transform_factory(_corner(axes), axes.transAxes),
    )


def _number(axes: Any, x: float, y: float, text: str, transform: Any, across: str, up: str) -> None:
    if text:
        axes.text(x, y, text, transform=transform, ha=across, va=up, zorder=TEXT_ORDER)


def _corner(axes: Any) -> Any:
    """Points from the lower left corner of the axes."""
    return transforms.ScaledTranslation(0, 0, axes.transAxes)


__all__ = ["mark", "numbers_of", "text_size"]
