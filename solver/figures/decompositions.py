"""The parts of a decomposed system as boxes, two by two, with the arrows between them."""

from __future__ import annotations

from collections.abc import Mapping

from solver.derivation.figures import Part, Parts
from solver.figures.layout import RADIUS, Block, Dot, Label, Layout, Point, Sum
from solver.formula.terminal import flat

TALL, APART, BETWEEN, BESIDE = 1.5, 1.3, 1.6, 0.45
"""Height of a box, room between rows and between columns, and how far wires at one side are from its middle."""


def layout_of(figure: Parts) -> Layout:
    """Return the diagram: the input comes from above, the output leaves to the left."""
    layout = Layout()
    width = max(map(_width, figure.parts))
    at = {
        i: (part.place[1] * (width + BETWEEN), -part.place[0] * (TALL + APART)) for i, part in enumerate(figure.parts)
    }
    for i, part in enumerate(figure.parts):
        x, y = at[i]
        layout.add(Block(x, y, "", width, TALL))
        layout.add(Label(x, y + 0.02, rf"\text{{{part.name}}}", "above"))
        layout.add(Label(x, y - 0.02, _modes(part), "below"))
        for other in part.acts_on:
            layout.wire(*_way(at[i], at[other], width))
    _input(layout, figure, at)
    _output(layout, figure, at, width)
    return layout


def _modes(part: Part) -> str:
    values = r",\ ".join(f"{{{mode}}}" for mode in part.modes)  # a minus after the comma is a sign
    return rf"\lambda = {values}"


def _width(part: Part) -> float:
    return max(2.4, 0.17 * len(part.name) + 0.4, 0.2 * len(flat(_modes(part))) + 0.4)


def _way(start: Point, end: Point, width: float) -> list[Point]:
    """Return the wire from one box to another: along a row, along a column, or through the middle."""
    (x, y), (u, v) = start, end
    right, up = (1 if u > x else -1), (1 if v > y else -1)
    if y == v:
        shift = -BESIDE if right > 0 else BESIDE
        return [(x + right * width / 2, y + shift), (u - right * width / 2, y + shift)]
    if x == u:
        shift = BESIDE if up > 0 else -BESIDE
        return [(x + shift, y + up * TALL / 2), (x + shift, v - up * TALL / 2)]
    middle = (x + u) / 2 + (0.3 if up > 0 else -0.3)
    return [(x + right * width / 2, y), (middle, y), (middle, v), (u - right * width / 2, v)]


def _input(layout: Layout, figure: Parts, at: Mapping[int, Point]) -> None:
    """Lead the input from above to the parts that it drives: past the upper row to a part of the lower one."""
    driven = sorted((at[i][0], at[i][1]) for i, part in enumerate(figure.parts) if part.driven)
    if not driven:
        return
    top = max(y for _, y in at.values()) + TALL / 2 + 0.7
    before = driven[0][0] - 1.6
    layout.add(Label(before + 0.3, top, "u", "above"))
    for i, (x, y) in enumerate(driven):
        layout.wire((before, top), (x, top), (x, y + TALL / 2))
        if i < len(driven) - 1:
            layout.add(Dot(x, top))
        before = x


def _output(layout: Layout, figure: Parts, at: Mapping[int, Point], width: float) -> None:
    """Add what the output shows, to the left."""
    seen = sorted((at[i] for i, part in enumerate(figure.parts) if part.seen), key=lambda place: -place[1])
    if not seen:
        return
    left = min(x for x, _ in at.values()) - width / 2
    bus = left - 0.9
    x, y = seen[0]
    if len(seen) == 1:
        layout.wire((x - width / 2, y), (bus - 0.9, y))
        layout.add(Label(bus - 0.5, y, "y", "above"))
        return
    last = seen[-1][1]
    layout.wire((x - width / 2, y), (bus, y), (bus, last + RADIUS))
    layout.add(Sum(bus, last))
    layout.wire((seen[-1][0] - width / 2, last), (bus + RADIUS, last))
    layout.wire((bus - RADIUS, last), (bus - 1.2, last))
    layout.add(Label(bus - 0.8, last, "y", "above"))
