"""What the drawing of a circuit is made of, and where its dots stand. Units are bodies of components; y points up."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

from solver.derivation.figures import Component

STRAIGHT = 2
"""As many directions has a wire that goes on."""

Point = tuple[float, float]


@dataclass(frozen=True)
class Placed:
    """A component with the places of its first and second node."""

    component: Component
    start: Point
    end: Point


@dataclass(frozen=True)
class Amplifier:
    """An operational amplifier: where its upper and its lower input and its output are, and which input is above."""

    component: Component
    upper: Point
    lower: Point
    output: Point
    minus_above: bool


@dataclass(frozen=True)
class Terminal:
    """An end at which a voltage is given or taken, with its label at the left or at the right of it."""

    place: Point
    label: str
    right: bool = False


@dataclass
class CircuitLayout:
    """A whole drawing."""

    placed: list[Placed] = field(default_factory=list)
    amplifiers: list[Amplifier] = field(default_factory=list)
    wires: list[tuple[Point, ...]] = field(default_factory=list)
    dots: list[Point] = field(default_factory=list)
    grounds: list[Point] = field(default_factory=list)
    names: list[tuple[Point, str]] = field(default_factory=list)
    terminals: list[Terminal] = field(default_factory=list)
    voltages: list[tuple[Point, str]] = field(default_factory=list)


def dots_of(layout: CircuitLayout) -> list[Point]:
    """Return where lines leave in three directions or more."""
    segments = [(each.start, each.end) for each in layout.placed]
    segments += [pair for wire in layout.wires for pair in pairwise(wire)]
    points = dict.fromkeys(p for segment in segments for p in segment)
    return [p for p in points if len({way for segment in segments for way in _ways(p, *segment)}) > STRAIGHT]


def _ways(p: Point, a: Point, b: Point) -> list[Point]:
    """The directions in which a segment along an axis leaves a point of it."""
    axis = 0 if a[1] == b[1] else 1
    low, high = sorted((a[axis], b[axis]))
    if p[1 - axis] != a[1 - axis] or not low <= p[axis] <= high:
        return []
    unit = (1.0, 0.0) if axis == 0 else (0.0, 1.0)
    forward = [unit] if p[axis] < high else []
    return forward + ([(-unit[0], -unit[1])] if p[axis] > low else [])
