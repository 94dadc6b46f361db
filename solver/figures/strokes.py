"""What schematics of mechanical systems are made of: lines, filled shapes, rings, hatching, zigzags. y points up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, ceil, cos, degrees, hypot, radians, sin

from solver.derivation.mechanisms import Place
from solver.figures.layout import Dot, Label
from solver.formula.terminal import flat

HATCH = 0.18
"""Length of the strokes of hatching, and nearly their distance."""
ANCHORS = ("right", "above right", "above", "above left", "left", "below left", "below", "below right")


@dataclass(frozen=True, slots=True)
class Line:
    """A line: "ink", "thin", "rod" or "dashed"; `arrow` is "", "end" or "both"."""

    points: tuple[Place, ...]
    style: str = "ink"
    arrow: str = ""


@dataclass(frozen=True, slots=True)
class Shape:
    """A filled polygon."""

    points: tuple[Place, ...]


@dataclass(frozen=True, slots=True)
class Ring:
    """A filled circle; a small one is a joint and filled with paper."""

    place: Place
    radius: float
    joint: bool = False


Stroke = Line | Shape | Ring | Label | Dot
Bounds = tuple[float, float, float, float]


def moved(place: Place, *steps: tuple[float, Place]) -> Place:
    """Return a place after steps, each so far along a direction."""
    x, y = place
    for size, (dx, dy) in steps:
        x, y = x + size * dx, y + size * dy
    return x, y


def middle(a: Place, b: Place, share: float = 0.5) -> Place:
    """Return a place between two others."""
    return a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])


def direction(a: Place, b: Place) -> Place:
    """Return the direction from one place to another."""
    length = hypot(b[0] - a[0], b[1] - a[1]) or 1.0
    return (b[0] - a[0]) / length, (b[1] - a[1]) / length


def along(angle: float) -> Place:
    """Return the direction at an angle in degrees."""
    return cos(radians(angle)), sin(radians(angle))


def label_beside(place: Place, toward: Place, text: str, gap: float = 0.0) -> Label:
    """Return a label that stands on one side of a place."""
    x, y = moved(place, (gap, toward))
    return Label(x, y, text, ANCHORS[round(degrees(atan2(toward[1], toward[0])) / 45) % 8])


def hatched(a: Place, b: Place, side: Place) -> list[Stroke]:
    """Return a line with hatching on one side."""
    u, length = direction(a, b), hypot(b[0] - a[0], b[1] - a[1])
    count = max(2, ceil(length / (1.15 * HATCH)))
    feet = [middle(a, b, (i + 1) / count) for i in range(count)]
    return [Line((a, b)), *(Line((p, moved(p, (-HATCH, u), (HATCH, side))), "thin") for p in feet)]


def zigzag(a: Place, b: Place) -> Line:
    """Return a spring between two places."""
    u, length = direction(a, b), hypot(b[0] - a[0], b[1] - a[1])
    n = (-u[1], u[0])
    turns = max(6, 2 * round(length / 0.36))
    stub = min(0.25, length / 6)
    step = (length - 2 * stub) / turns
    tips = [moved(a, (stub + step * (i + 0.5), u), (0.16 if i % 2 else -0.16, n)) for i in range(turns)]
    return Line((a, moved(a, (stub, u)), *tips, moved(b, (-stub, u)), b))


def arc(centre: Place, radius: float, start: float, stop: float) -> Line:
    """Return an arc with an arrowhead at its end; degrees."""
    angles = [start + (stop - start) * i / 24 for i in range(25)]
    return Line(tuple(moved(centre, (radius, along(each))) for each in angles), arrow="end")


def frame_of(label: Label) -> Bounds:
    """Return about what room a label takes: x_min, x_max, y_min, y_max."""
    width, height = 0.1 + 0.17 * len(flat(label.text)), 0.34
    x = label.x + (width / 2 if "right" in label.anchor else -width / 2 if "left" in label.anchor else 0)
    y = label.y + (height / 2 if "above" in label.anchor else -height / 2 if "below" in label.anchor else 0)
    return x - width / 2, x + width / 2, y - height / 2, y + height / 2


def bounds_of(strokes: Sequence[Stroke]) -> Bounds:
    """Return x_min, x_max, y_min, y_max of the drawing, with room for labels."""
    frames: list[Bounds] = []
    for each in strokes:
        if isinstance(each, Label):
            frames.append(frame_of(each))
        elif isinstance(each, Ring):
            (x, y), r = each.place, each.radius
            frames.append((x - r, x + r, y - r, y + r))
        elif isinstance(each, Dot):
            frames.append((each.x, each.x, each.y, each.y))
        else:
            xs, ys = zip(*each.points, strict=True)
            frames.append((min(xs), max(xs), min(ys), max(ys)))
    x_min, x_max, y_min, y_max = zip(*frames, strict=True)
    return min(x_min) - 0.25, max(x_max) + 0.25, min(y_min) - 0.25, max(y_max) + 0.25
