"""Poles and zeros in the s- or z-plane as a plot: the roots, the edge of stability, the region of specifications."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import cos, pi, sin, sqrt

from solver.derivation.figures import DrawnCurve, DrawnPlot, Mark, Plane, Region, Roots
from solver.figures.sampling import complex_number, number

Point = tuple[float, float]
Window = tuple[float, float, float, float]

MARGIN = 0.15
LONG = 3
"""A plane that is longer than this has a scale of its own for each axis."""

ARC = 120
ZETA = r"\sym{damping_ratio}"
DIGITS = 9
"""Roots that agree so far lie on each other."""


@dataclass(frozen=True, slots=True)
class Placed:
    """Roots as numbers: each place once, with the number of roots there."""

    name: str
    sign: str
    places: tuple[tuple[complex, int], ...]

    @property
    def count(self) -> int:
        """How many roots there are."""
        return sum(times for _, times in self.places)


def placed(roots: Roots) -> Placed:
    """Return some roots as numbers, from left to right and from below."""
    values = (complex_number(value) for value in roots.values)
    found = Counter(complex(_round(value.real), _round(value.imag)) for value in values)
    return Placed(roots.name, roots.sign, tuple(sorted(found.items(), key=lambda item: (item[0].real, item[0].imag))))


def _round(x: float) -> float:
    return float(f"{x:.{DIGITS}g}") + 0.0 if abs(x) > 1e-12 else 0.0


def on_plane(plane: Plane, say: Callable[[str], str] = str) -> DrawnPlot:
    """Return a plane as a plot; `say` spells the symbols of the notation."""
    sets = [placed(each) for each in plane.roots]
    limits = limits_of(plane.region)
    points = [(place.real, place.imag) for each in sets for place, _ in each.places]
    window, equal = _window([*points, *_needed(plane, limits)], equal=plane.region is not None)
    curves = [*_stable(plane, window), *_region(limits, window, say), *_edge(plane)]
    for each in sets:
        xs, ys = ([getattr(place, side) for place, _ in each.places] for side in ("real", "imag"))
        if xs:
            curves.append(DrawnCurve(rf"\text{{{each.name}}}", each.sign, tuple(xs), tuple(ys)))
    many = [
        Mark(place.real, place.imag, rf"{times}\times", "none")
        for each in sets
        for place, times in each.places
        if times > 1
    ]
    letter = "z" if plane.discrete else "s"
    labels = (rf"\operatorname{{Re}} {letter}", rf"\operatorname{{Im}} {letter}")
    return DrawnPlot(plane.caption, *labels, tuple(curves), tuple(many), equal, window)


def _stable(plane: Plane, window: Window) -> Iterator[DrawnCurve]:
    """The area where modes die out."""
    if plane.stable and plane.discrete:
        yield replace(_arc(1.0, 0.0, 2 * pi, ""), style="area")
    elif plane.stable:
        corners = _clipped(_corners(window), [(1.0, 0.0, 0.0)])
        yield DrawnCurve("", "area", tuple(x for x, _ in corners), tuple(y for _, y in corners))


def _edge(plane: Plane) -> Iterator[DrawnCurve]:
    """The unit circle; the imaginary axis is drawn as an axis."""
    if plane.discrete:
        yield unit_circle()


def unit_circle() -> DrawnCurve:
    """Return the edge of stability in discrete time."""
    return _arc(1.0, 0.0, 2 * pi, "")


def _arc(radius: float, start: float, stop: float, label: str) -> DrawnCurve:
    angles = [start + (stop - start) * i / ARC for i in range(ARC + 1)]
    xs, ys = tuple(radius * cos(a) for a in angles), tuple(radius * sin(a) for a in angles)
    return DrawnCurve(label, "guide", xs, ys)


@dataclass(frozen=True, slots=True)
class Limits:
    """A region as numbers; 0 asks for nothing."""

    damping: float = 0.0
    decay: float = 0.0
    radius: float = 0.0
    frequency: float = 0.0


def limits_of(region: Region | None) -> Limits | None:
    """Return a region as numbers; None for none."""
    if region is None:
        return None
    names = (region.damping, region.decay, region.radius, region.frequency)
    return Limits(*(0.0 if each is None else number(each) for each in names))


def _needed(plane: Plane, limits: Limits | None) -> list[Point]:
    """Points that the window must hold besides the roots."""
    found = [(0.0, 0.0)]
    if plane.discrete:
        found += [(-1.0, -1.0), (1.0, 1.0)]
    if limits is not None:
        found += [(-1.4 * max(limits.decay, limits.radius), 0.0), (0.0, 1.2 * max(limits.frequency, limits.radius))]
    return found


def _window(points: Sequence[Point], *, equal: bool) -> tuple[Window, bool]:
    """Return the window around some points, as high above the real axis as below, and whether scales are equal."""
    left, right = min(x for x, _ in points), max(x for x, _ in points)
    top = max(abs(y) for _, y in points)
    width, height = right - left, 2 * top
    equal = equal or (bool(width or height) and max(width, height) <= LONG * min(width, height))
    if equal:
        side = max(width, height) * (1 + 2 * MARGIN)
        middle = (left + right) / 2
        return (middle - side / 2, middle + side / 2, -side / 2, side / 2), True
    width, height = width or height or 2.0, height or width or 2.0
    if left == right:
        left, right = left - width / 2, right + width / 2
    return (left - MARGIN * width, right + MARGIN * width, -height * (0.5 + MARGIN), height * (0.5 + MARGIN)), False


def _region(limits: Limits | None, window: Window, say: Callable[[str], str]) -> Iterator[DrawnCurve]:
    """The area in which all specifications are met, and the lines that bound it, with what they stand for."""
    if limits is None:
        return
    for sign in (1, -1):
        corners = _clipped(_corners(window), [*_half_planes(limits, sign)])
        if len(corners) > 2:
            yield DrawnCurve("", "area", tuple(x for x, _ in corners), tuple(y for _, y in corners))
        if not limits.frequency:
            break
    left, _, low, high = window
    if limits.damping:
        slope = sqrt(1 - min(limits.damping, 1.0) ** 2) / limits.damping
        reach = min(-left, high / slope) if slope else -left
        label = rf"{say(ZETA)} = {limits.damping:.3g}"
        for sign in (1, -1):
            yield DrawnCurve("", "guide", (0.0, -reach), (0.0, sign * slope * reach))
        yield DrawnCurve(label, "guide", (-reach / 2,), (slope * reach / 2,))  # half way, clear of the other lines
    if limits.decay:
        yield DrawnCurve(rf"\sigma = {limits.decay:.3g}", "guide", (-limits.decay,) * 2, (high, low))
    if limits.radius:
        yield _arc(limits.radius, pi / 2, 3 * pi / 2, rf"\omega_n = {limits.radius:.3g}")
    if limits.frequency:
        for sign, text in ((1, rf"\omega_d = {limits.frequency:.3g}"), (-1, "")):
            yield DrawnCurve(text, "guide", (0.0, left), (sign * limits.frequency,) * 2)


def _corners(window: Window) -> list[Point]:
    left, right, low, high = window
    return [(left, low), (right, low), (right, high), (left, high)]


def _half_planes(limits: Limits, sign: int) -> Iterator[tuple[float, float, float]]:
    """Yield a, b, c of a x + b y ≤ c; of a region in two parts the one above the real axis, or below."""
    if limits.damping:
        slope = sqrt(1 - min(limits.damping, 1.0) ** 2) / limits.damping
        yield from ((slope, 1.0, 0.0), (slope, -1.0, 0.0))
    if limits.decay:
        yield 1.0, 0.0, -limits.decay
    if limits.frequency:
        yield 0.0, -float(sign), -limits.frequency


def _clipped(corners: list[Point], half_planes: Sequence[tuple[float, float, float]]) -> list[Point]:
    """Cut a convex polygon by half planes, by Sutherland and Hodgman; without any it is no region."""
    if not half_planes:
        return []
    for a, b, c in half_planes:
        kept: list[Point] = []
        for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1], strict=True):
            first, second = a * x0 + b * y0 - c, a * x1 + b * y1 - c
            if first <= 0:
                kept.append((x0, y0))
            if first * second < 0:
                part = first / (first - second)
                kept.append((x0 + (x1 - x0) * part, y0 + (y1 - y0) * part))
        corners = kept
    return corners
