"""Signal-flow graphs laid out: the longest path on a row, what leads on above it, what leads back below it.

A branch between neighbours of the row is straight, any other on it an arc; arcs over each other have heights of their
own, so that their gains stand apart. Nodes beside the row stand above all arcs below them, their branches are straight.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import atan2, cos, hypot, pi, sin

from solver.derivation.flow_figures import FlowGraph
from solver.figures.chains import width_of
from solver.figures.layout import Dot, Label, Layout, Point, Wire
from solver.figures.strokes import ANCHORS

APART, ROOM = 1.5, 0.55
"""The least distance of neighbours on the row, and the room beside a gain."""
LOW, LEVEL, OWN = 0.95, 0.8, 0.95
"""Height of the lowest arcs, of each further level, and of a loop at its node."""
ARC = 24
"""The number of pieces of an arc."""
GAP = 0.13
"""From a node to the name beside it."""


@dataclass
class Drawing:
    """A graph while it is laid out: places of nodes, and the directions in which lines leave them."""

    figure: FlowGraph
    layout: Layout = field(default_factory=Layout)
    at: dict[int, Point] = field(default_factory=dict)
    leaving: dict[int, list[float]] = field(default_factory=dict)
    own: list[int] = field(default_factory=list)

    def line(self, points: Sequence[Point], ends: tuple[int, int]) -> None:
        """Draw a branch along points, with an arrowhead in the middle."""
        half = len(points) // 2 + 1
        self.layout.add(Wire(tuple(points[:half])), Wire(tuple(points[half - 1 :]), arrow=False))
        for node, (here, there) in zip(ends, ((points[0], points[1]), (points[-1], points[-2])), strict=True):
            self.leaving.setdefault(node, []).append(atan2(there[1] - here[1], there[0] - here[0]))


def layout_of(figure: FlowGraph) -> Layout:
    """Return the drawing of a graph."""
    drawing = Drawing(figure)
    _on_the_row(drawing)
    place = {node: i for i, node in enumerate(figure.row)}
    arcs = [(a, b, gain) for a, b, gain in figure.branches if a in place and b in place and a != b]
    straight = [each for each in arcs if place[each[1]] == place[each[0]] + 1]
    tops = _arcs(drawing, [each for each in arcs if each not in straight], place)
    _beside_the_row(drawing, tops, place)
    for a, b, gain in figure.branches:
        if (a, b, gain) in straight or (a != b and not (a in place and b in place)):
            _straight(drawing, a, b, gain)
    for node in drawing.own:
        _loop(drawing, node)
    for node, (x, y) in drawing.at.items():
        drawing.layout.add(Dot(x, y), _name(drawing, node))
    return drawing.layout


def _on_the_row(drawing: Drawing) -> None:
    """Place the nodes of the row so far apart that the gains between them have room."""
    figure, x = drawing.figure, 0.0
    between = {(a, b): gain for a, b, gain in figure.branches}
    drawing.own = [a for a, b, _ in figure.branches if a == b]
    for i, node in enumerate(figure.row):
        if i:
            gain = between.get((figure.row[i - 1], node), "")
            x += max(APART, width_of(gain) + ROOM if gain else 0.0)
        drawing.at[node] = (x, 0.0)


def _arcs(drawing: Drawing, arcs: Sequence[tuple[int, int, str]], place: Mapping[int, int]) -> dict[int, float]:
    """Draw what leads on above the row and what leads back below it; return the height reached above each place."""
    tops = dict.fromkeys(range(len(place)), 0.0)
    for side in (1, -1):
        mine = [each for each in arcs if (place[each[1]] > place[each[0]]) == (side > 0)]
        mine.sort(key=lambda each: abs(place[each[1]] - place[each[0]]))
        taken: list[tuple[int, int, int]] = []
        for a, b, gain in mine:
            first, last = sorted((place[a], place[b]))
            owns = [i for i in range(first, last + 1) if side > 0 and drawing.figure.row[i] in drawing.own]
            meeting = [level for left, right, level in taken if left < last and first < right]
            level = max(meeting, default=-1) + 1
            level = max(level, 1) if any(first < i < last for i in owns) else level
            taken.append((first, last, level))
            height = LOW + LEVEL * level
            _arc(drawing, (a, b), gain, side * height)
            for i in range(first, last + 1):
                tops[i] = max(tops[i], height if side > 0 else 0.0)
    return tops


def _arc(drawing: Drawing, ends: tuple[int, int], gain: str, height: float) -> None:
    """An arc from one node of the row to another, flat in its middle."""
    (x, y), (u, _) = (drawing.at[node] for node in ends)
    steps = [i / ARC for i in range(ARC + 1)]
    points = [(x + (u - x) * _eased(w), y + height * (1 - (2 * w - 1) ** 4)) for w in steps]
    drawing.line(points, ends)
    beyond = 0.06 if height > 0 else -0.06
    drawing.layout.add(Label((x + u) / 2, y + height + beyond, gain, "above" if height > 0 else "below"))


def _eased(w: float) -> float:
    """Slow at both ends, so that an arc leaves its nodes steeply."""
    return w - 0.5 * sin(2 * pi * w) / (2 * pi)


def _beside_the_row(drawing: Drawing, tops: Mapping[int, float], place: Mapping[int, int]) -> None:
    """Place the other nodes above the row, between the nodes that they are joined with, apart from each other."""
    figure = drawing.figure
    others = [node for node in range(len(figure.nodes)) if node not in place]
    waiting = list(others)
    while waiting:
        node = next((n for n in waiting if _joined(drawing, n)), waiting[0])
        waiting.remove(node)
        joined = _joined(drawing, node)
        xs = [x for x, _ in joined] or [0.0]
        x = (min(xs) + max(xs)) / 2 if max(xs) > min(xs) else xs[0] + 0.75 * APART * _free_side(drawing, node)
        under = [tops[i] for n, i in place.items() if min(xs) - 0.1 <= drawing.at[n][0] <= max(xs) + 0.1]
        y = max(under, default=0.0) + 1.35
        while any(hypot(x - u, (y - v) * 1.2) < APART for n, (u, v) in drawing.at.items() if n not in place):
            y += 1.2
        drawing.at[node] = (x, y)


def _joined(drawing: Drawing, node: int) -> list[Point]:
    """The places of the nodes that share a branch with one, as far as they stand."""
    ends = {a if b == node else b for a, b, _ in drawing.figure.branches if node in (a, b)} - {node}
    return [drawing.at[each] for each in sorted(ends) if each in drawing.at]


def _free_side(drawing: Drawing, node: int) -> int:
    """On which side of the one node that it is joined with a node stands: a source to the left if no arc is there."""
    figure = drawing.figure
    others = {a if b == node else b for a, b, _ in figure.branches if node in (a, b)} - {node}
    source = all(b != node for _, b, _ in figure.branches)
    from_left = any(pi / 2 < angle < pi for other in others for angle in drawing.leaving.get(other, []))
    return -1 if source and not from_left else 1


def _straight(drawing: Drawing, a: int, b: int, gain: str) -> None:
    """A straight branch; one that another comes back along is bent to its right."""
    (x, y), (u, v) = drawing.at[a], drawing.at[b]
    length = hypot(u - x, v - y)
    back = any((p, q) == (b, a) for p, q, _ in drawing.figure.branches) and (y, v) != (0.0, 0.0)
    n = ((v - y) / length, -(u - x) / length)
    bend = 0.3 if back else 0.0
    steps = [i / ARC for i in range(ARC + 1)]
    points = [(x + (u - x) * w + n[0] * bend * sin(pi * w), y + (v - y) * w + n[1] * bend * sin(pi * w)) for w in steps]
    drawing.line(points, (a, b))
    middle = points[ARC // 2]
    if abs(v - y) < 0.05:
        low = back and n[1] < 0
        drawing.layout.add(Label(middle[0], middle[1] - (0.06 if low else -0.03), gain, "below" if low else "above"))
        return
    side = n if back or n[1] > 0 else (-n[0], -n[1])
    anchor = ANCHORS[round(atan2(side[1], side[0]) / (pi / 4)) % 8]
    drawing.layout.add(Label(middle[0], middle[1], gain, anchor))


def _loop(drawing: Drawing, node: int) -> None:
    """A loop above its node."""
    x, y = drawing.at[node]
    gain = next(gain for a, b, gain in drawing.figure.branches if a == b == node)
    steps = [i / ARC for i in range(ARC + 1)]
    points = [(x - 0.5 * sin(2 * pi * w) * sin(pi * w), y + OWN * sin(pi * w)) for w in steps]
    drawing.line(points, (node, node))
    drawing.layout.add(Label(x, y + OWN, gain, "above"))


def _name(drawing: Drawing, node: int) -> Label:
    """The name of a node, in the direction that is farthest from all lines; of several below before above."""
    x, y = drawing.at[node]
    lines = drawing.leaving.get(node, [])
    order = (6, 2, 5, 7, 3, 1, 4, 0)

    def free(i: int) -> float:
        return min((abs((i * pi / 4 - line + pi) % (2 * pi) - pi) for line in lines), default=pi)

    best = max(order, key=lambda i: (round(min(free(i), pi / 3), 3), -order.index(i)))
    angle = best * pi / 4
    return Label(x + GAP * cos(angle), y + GAP * sin(angle), drawing.figure.nodes[node], ANCHORS[best])
