"""Answers that are lists of points or conditions, on one line where they fit, else each value on a line of its own."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from solver.formula.building import row
from solver.formula.nodes import Row, Text
from solver.formula.width import LINE, width
from solver.render.displays import EQUALS, NOTHING, aligned

Show = Callable[[Any], Row]


def equations_that_are_zero(expressions: Sequence[Any], show: Show) -> Row:
    """Return each expression = 0, under each other where there are several."""
    lines = [(show(each), row(EQUALS, "0")) for each in expressions]
    return aligned(lines) if len(lines) > 1 else row(*lines[0]) if lines else NOTHING


def told_behind(word: str, value: Any, show: Show, *, narrow: bool = False) -> Row:
    """Return `word: value`; of what is wide, a point value by value, of several each on a line of its own.

    Values of unknowns are equations, which need no word before them.
    """
    if isinstance(value, Mapping) and value and not any(isinstance(name, str) for name in value):
        equations = [_named(name, each, show) for name, each in value.items()]
        return aligned(equations) if len(equations) > 1 else row(*equations[0])
    named = row(Text(f"{word}:"))
    whole = row(named, r"\quad", show(value))
    lines = _lines(value, show, narrow=narrow)
    if not lines or (width(whole) <= LINE and not narrow):
        return whole
    return aligned([(NOTHING, named), *lines])


def _lines(value: Any, show: Show, *, narrow: bool) -> list[tuple[Row, Row]]:
    points = value if isinstance(value, list | tuple) else [value]
    if not points or not all(isinstance(each, Mapping) for each in points):
        return [(NOTHING, show(each)) for each in points] if len(points) > 1 else []
    shown = [show(dict(each)) for each in points]
    if len(points) > 1 and not narrow and max(map(width, shown)) <= LINE:
        return [(NOTHING, each) for each in shown]
    lines = []
    for i, point in enumerate(points, 1):
        lines += [(NOTHING, row(Text(f"{i}.")))] if len(points) > 1 else []
        lines += [_named(x, each, show) for x, each in point.items()]
    return lines


def _named(name: Any, value: Any, show: Show) -> tuple[Row, Row]:
    """The sides of x = value, of a case in words `case: condition`."""
    if isinstance(name, str):
        return show(name.replace("_", " ")), row(Text(": "), show(value))
    return show(name), row(EQUALS, show(value))
