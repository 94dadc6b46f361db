"""What stands beside the bodies of a schematic: dimensions of coordinates, arcs of angles, forces, gravity."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from solver.derivation.mechanisms import Distance, Mechanism, Place, Push, Turn
from solver.figures.mechanism_parts import DISC, UNIT, Parts
from solver.figures.strokes import Line, Stroke, along, arc, direction, label_beside, middle, moved

ROW, PUSH, RADIUS, BESIDE = 0.62, 0.95, 1.05, 0.5
"""Distance of dimensions from each other, length of forces, radius of arcs, distance of a dimension from its link."""
OVER = 0.12
"""How far the thin lines at a dimension go on."""


def marks_of(parts: Parts) -> Iterator[Stroke]:
    """Yield the marks of all coordinates and forces."""
    rows: dict[Place, int] = {}
    for each in parts.mechanism.distances:
        if each.link is not None:
            continue
        if parts.mechanism.joints[each.joint].direction is not None:
            n = parts.axes(each.joint)[1]
            rows[n] = rows.get(n, -1) + 1
            yield from _beside_line(parts, each, rows[n])
        else:
            yield from _in_the_plane(parts, each)
    for turn in parts.mechanism.turns:
        yield from _turn(parts, turn)
    for push in parts.mechanism.pushes:
        yield from _push(parts, push)


def lengths_of(parts: Parts) -> Iterator[Stroke]:
    """Yield the dimensions along links, which lie before the bodies."""
    for each in parts.mechanism.distances:
        if each.link is not None:
            yield from _beside_link(parts, each, each.link)


def _start(each: Distance) -> Place:
    return each.start[0] * UNIT, each.start[1] * UNIT


def _beside_line(parts: Parts, each: Distance, row: int) -> Iterator[Stroke]:
    """A dimension below the ground, above a rail, or on the right of an upright line."""
    start, end, (_, n, upright) = _start(each), parts.places[each.joint], parts.axes(each.joint)
    across = parts.halves(each.joint)[1]
    above = upright or parts.is_rail(each.joint)
    side = n if above else (-n[0], -n[1])
    offset = across + (0.35 if above else 0.55) + ROW * row
    first, last = moved(start, (offset, side)), moved(end, (offset, side))
    yield Line((moved(start, (across - 0.35 if not upright else 0.1, side)), moved(first, (OVER, side))), "thin")
    yield Line((moved(end, (across + (0.08 if above else 0.28), side)), moved(last, (OVER, side))), "thin")
    yield Line((first, last), arrow="end")
    yield label_beside(middle(first, last), side, each.label)


def _beside_link(parts: Parts, each: Distance, number: int) -> Iterator[Stroke]:
    """A dimension along a link, on the side where its angle is not."""
    start, end, side = _start(each), parts.places[each.joint], parts.away(number)
    first, last = moved(start, (BESIDE, side)), moved(end, (BESIDE, side))
    yield Line((moved(start, (0.2, side)), moved(first, (OVER, side))), "thin")
    yield Line((moved(end, (DISC + 0.05, side)), moved(last, (OVER, side))), "thin")
    yield Line((first, last), arrow="end")
    yield label_beside(middle(first, last), side, each.label)


def _in_the_plane(parts: Parts, each: Distance) -> Iterator[Stroke]:
    """A dimension from an axis to a free body."""
    start, end = _start(each), parts.places[each.joint]
    u = direction(start, end)
    n = (-u[1], u[0])
    yield Line((moved(start, (-0.6, n)), moved(start, (0.6, n))), "thin")
    last = moved(end, (-DISC, u))
    yield Line((start, last), arrow="end")
    yield label_beside(middle(start, last), n if n[1] >= abs(n[0]) else (-1.0, 0.0), each.label)


def _turn(parts: Parts, turn: Turn) -> Iterator[Stroke]:
    """The direction that an angle is measured from, and its arc."""
    first, second = parts.mechanism.links[turn.link].ends
    (x0, y0), (x1, y1) = parts.places[first], parts.places[second]
    radius = min(RADIUS, 0.55 * hypot(x1 - x0, y1 - y0))
    centre, start = (x0, y0), along(turn.start)
    yield Line((centre, moved(centre, (radius + 0.55, start))), "dashed")
    yield arc(centre, radius, turn.start, turn.stop)
    yield label_beside(centre, along((turn.start + turn.stop) / 2), turn.label, radius)


def _push(parts: Parts, push: Push) -> Iterator[Stroke]:
    """A force from behind, in front where a link is behind, or above where links are on both sides."""
    place, u = parts.places[push.joint], push.direction
    _, n, upright = parts.axes(push.joint)
    size = parts.halves(push.joint)[1 if upright != (abs(u[1]) > abs(u[0])) else 0]
    sides = [direction(place, parts.places[other]) for other in parts.others(push.joint)]
    cosines = [u[0] * v[0] + u[1] * v[1] for v in sides]
    behind, before = any(c < -0.9 for c in cosines), any(c > 0.9 for c in cosines)
    if behind and before:
        place, size = moved(place, (OVER + parts.halves(push.joint)[1], n)), -PUSH / 2
    tail = moved(place, (size if behind else -size - PUSH, u))
    tip = moved(tail, (PUSH, u))
    yield Line((tail, tip), "rod", arrow="end")
    yield label_beside(middle(tail, tip), n, push.label, 0.08)


def gravity_of(mechanism: Mechanism, bounds: tuple[float, float, float, float]) -> Iterator[Stroke]:
    """Yield the arrow of gravity, on the right of everything."""
    if mechanism.gravity:
        _, x, low, top = bounds
        y = min(top - 0.2, (low + top) / 2 + 0.9)
        yield Line(((x + 0.25, y), (x + 0.25, y - 1.0)), "rod", arrow="end")
        yield label_beside((x + 0.25, y - 0.5), (1.0, 0.0), mechanism.gravity, 0.06)
