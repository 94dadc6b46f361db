"""A root locus as a plot: branches with arrows, poles, zeros, asymptotes, meeting points, crossings, and gains."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from math import cos, floor, log10, radians, sin
from typing import Any

import numpy as np

from solver.derivation.figures import DrawnCurve, DrawnPlot, Mark, Roots
from solver.derivation.parameter_figures import Locus
from solver.figures.alternatives import number_text, text_of, values_text
from solver.figures.branches import Branches
from solver.figures.planes import Placed, placed, unit_circle
from solver.figures.sampling import complex_number, number, plain
from solver.words import Phrase

Window = tuple[float, float, float, float]
Say = Callable[[str], str]

MARGIN = 0.28
"""What is shown around the points of interest, in parts of their extent."""

FAR = 6
"""A pole or zero so many times farther away than all others is told at the edge."""

SHIFTS = (0.0, -0.09, 0.06, -0.15, 0.12, -0.21, 0.18)
"""Where the name of a point may stand, above it or below, in parts of the window's side."""

WIDE, HIGH = 0.25, 0.058
"""How wide and how high a name is, in the same parts."""

CLOSE = 1e-9
"""Points that differ by less are one."""

SHORT = 0.1
"""A piece shorter than this part of the window has no arrow."""


def on_locus(locus: Locus) -> DrawnPlot:
    """Return a root locus as a plot."""
    poles, zeros = _roots(locus)
    meetings = [(complex_number(point), number(gain)) for point, gain in locus.meetings]
    crossings = [(complex_number(point), number(gain)) for point, gain in locus.crossings]
    centroid = [] if locus.centroid is None else [complex(number(locus.centroid))]
    points = [place for each in (poles, zeros) for place, _ in each.places]
    edge = [1 + 0j, 1j, -1 + 0j] if locus.discrete else [0j]
    special = [*(point for point, _ in meetings), *(point for point, _ in crossings), *centroid, *edge]
    shown, beyond = _near(points, special)
    window = _window([*shown, *special])
    curves = [
        *([unit_circle()] if locus.discrete else []),
        *_asymptotes(locus, window),
        *_branches(locus, window, meetings),
    ]
    for each in (poles, zeros):
        places = [place for place, _ in each.places if place not in beyond]
        if places:
            xs, ys = (tuple(getattr(place, side) for place in places) for side in ("real", "imag"))
            curves.append(DrawnCurve(rf"\text{{{each.name}}}", each.sign, xs, ys))
    dots = [*_dots(locus, meetings, crossings)]
    named = _apart([mark for mark in (*dots, *_several((poles, zeros), beyond)) if mark.label], window)
    marks = [*(replace(dot, label="") for dot in dots), *named, *_at_the_edge(beyond, window)]
    s = "z" if locus.discrete else "s"
    labels = (rf"\operatorname{{Re}} {s}", rf"\operatorname{{Im}} {s}")
    return DrawnPlot(locus.caption, *labels, tuple(curves), tuple(marks), equal=True, window=window)


def _roots(locus: Locus) -> tuple[Placed, Placed]:
    """Poles and zeros, each place once."""
    found = []
    for name, listed, sign in (("poles", locus.denominator, "cross"), ("zeros", locus.numerator, "ring")):
        values = _together(np.roots([number(c) for c in listed])) if len(listed) > 1 else []
        found.append(placed(Roots(name, tuple(values), sign)))
    return found[0], found[1]


def _together(roots: Any) -> list[complex]:
    """Roots that rounding has moved apart, in one place: multiple ones are known to about half of the digits."""
    left, found = [complex(root) for root in roots], []
    while left:
        first = left[0]
        near = [root for root in left if abs(root - first) < 1e-3 * (1e-3 + abs(first))]
        left = [root for root in left if root not in near]
        mean = sum(near) / len(near)
        mean = complex(mean.real, mean.imag if abs(mean.imag) > 1e-6 * (1 + abs(mean)) else 0.0)
        found += [complex(*(float(f"{part:.9g}") for part in (mean.real, mean.imag)))] * len(near)
    return found


def _near(points: Sequence[complex], special: Sequence[complex]) -> tuple[list[complex], set[complex]]:
    """Points that one window can show, and those too far away on the real axis."""
    radius = max(map(abs, special), default=0.0)
    shown: list[complex] = []
    rising = sorted(points, key=abs)
    for i, point in enumerate(rising):
        reach = max([radius, *map(abs, shown)])
        if i > 1 and reach and abs(point) > FAR * reach and not point.imag:
            return shown, set(rising[i:])
        shown.append(point)
    return shown, set()


def _window(points: Sequence[complex]) -> Window:
    """A square about the points, as high above the real axis as below."""
    left, right = min(p.real for p in points), max(p.real for p in points)
    top = max(abs(p.imag) for p in points)
    side = max(right - left, 2 * top) * (1 + 2 * MARGIN) or 2.0
    middle = (left + right) / 2
    return (middle - side / 2, middle + side / 2, -side / 2, side / 2)


def _asymptotes(locus: Locus, window: Window) -> Iterator[DrawnCurve]:
    """Lines from the centroid to the edge of the window; those along the real axis are on it."""
    if locus.centroid is None:
        return
    x = number(locus.centroid)
    for each in map(number, locus.angles):
        c, s = cos(radians(each)), sin(radians(each))
        if abs(s) < 1e-12:
            continue
        ways = [(window[1] - x) / c if c > 1e-12 else (window[0] - x) / c if c < -1e-12 else np.inf, window[3] / abs(s)]
        reach = min(ways)
        yield DrawnCurve("", "guide", (x, x + reach * c), (0.0, reach * s))


def _branches(locus: Locus, window: Window, meetings: list[tuple[complex, float]]) -> Iterator[DrawnCurve]:
    """The branches inside of the window, simplified."""
    N, D = (np.array([number(c) for c in each], dtype=complex) for each in (locus.numerator, locus.denominator))
    side, middle = window[1] - window[0], complex((window[0] + window[1]) / 2)
    lead = (N[0] / D[0]).real
    infinite = -1 / lead if len(N) == len(D) and lead < 0 else None
    label = r"\text{branches}"
    for piece in Branches(N, D, middle, side).pieces(meetings, infinite):
        for run in _inside(piece, window):
            x, y = plain(run.real, run.imag)
            length = float(np.sum(np.hypot(np.diff(x), np.diff(y))))
            x, y = _halved(x, y) if len(x) == 2 else (x, y)
            yield DrawnCurve(label, "arrow" if length > SHORT * side else "line", tuple(x.tolist()), tuple(y.tolist()))


def _halved(x: Any, y: Any) -> tuple[Any, Any]:
    """A straight piece with a point in its middle, where its arrowhead stands."""
    return np.array([x[0], (x[0] + x[1]) / 2, x[1]]), np.array([y[0], (y[0] + y[1]) / 2, y[1]])


def _inside(piece: Any, window: Window) -> Iterator[Any]:
    """The stretches of a curve in the window, each with the point by which it leaves."""
    margin = 0.02 * (window[1] - window[0])
    inside = (
        (piece.real > window[0] - margin)
        & (piece.real < window[1] + margin)
        & (np.abs(piece.imag) < window[3] + margin)
    )
    start = None
    for i, within in enumerate([*inside, False]):
        if within and start is None:
            start = i
        elif not within and start is not None:
            if i - start > 1:
                yield piece[start:i]
            start = None


def _dots(
    locus: Locus, meetings: list[tuple[complex, float]], crossings: list[tuple[complex, float]]
) -> Iterator[Mark]:
    """Meeting points and crossings; of a pair the upper one has the gain as its name."""
    for point, gain in meetings:
        yield Mark(point.real, point.imag, "" if point.imag < 0 else _named(locus.gain, gain))
    for point, gain in crossings:
        if any(abs(point - other) < CLOSE * (1 + abs(point)) for other, _ in meetings):
            continue  # branches meet there: it has its name
        yield Mark(point.real, point.imag, _named(locus.gain, gain))
        if point.imag:
            yield Mark(point.real, -point.imag)


def _named(name: str, gain: float) -> str:
    """A gain with three digits."""
    size = floor(log10(gain))
    if -4 < size < 5:
        digits = max(2 - size, 0)
        text = f"{gain:.{digits}f}"
        return f"{name} = {text.rstrip('0').rstrip('.') if '.' in text else text}"
    power = rf"{gain / 10.0**size:.3g}\cdot10^{{{size}}}"
    return f"{name} = {power}"


def _several(sets: Sequence[Placed], beyond: set[complex]) -> Iterator[Mark]:
    """How often a multiple root counts."""
    for each in sets:
        for place, times in each.places:
            if times > 1 and place not in beyond:
                yield Mark(place.real, place.imag, rf"{times}\times", "none")


def _apart(marks: Sequence[Mark], window: Window) -> list[Mark]:
    """Names without their dots, moved up or down until none covers another."""
    side = window[1] - window[0]
    taken: list[tuple[float, float]] = []
    found = []
    for mark in marks:
        height = next(
            (mark.y + shift * side for shift in SHIFTS if not _covered(mark.x, mark.y + shift * side, taken, side)),
            mark.y,
        )
        taken.append((mark.x, height))
        found.append(Mark(mark.x, height, mark.label, "none"))
    return found


def _covered(x: float, y: float, taken: Sequence[tuple[float, float]], side: float) -> bool:
    """Whether a name at this point would cover one of those that are there."""
    return any(abs(x - a) < WIDE * side and abs(y - b) < HIGH * side for a, b in taken)


def _at_the_edge(beyond: set[complex], window: Window) -> Iterator[Mark]:
    """Names of poles and zeros beyond the window, at its edge."""
    height = 0.04 * (window[3] - window[2])
    for i, each in enumerate(sorted(beyond, key=lambda point: abs(point.real))):
        right = each.real > 0
        arrow = rf"{each.real:.3g}\rightarrow" if right else rf"\leftarrow{each.real:.3g}"
        yield Mark(window[1] if right else window[0], height * (1 + 1.5 * i), arrow, "none")


def of_locus(locus: Locus, say: Say) -> str:
    """Tell where branches start, end, meet and cross."""
    poles, zeros = _roots(locus)
    K = text_of(locus.gain)
    told = [say("root locus in the z-plane" if locus.discrete else "root locus in the s-plane")]
    for each in (poles, zeros):
        values = ", ".join(values_text(each.places))
        told.append(say(Phrase("{name} ({count}): {values}", name=each.name, count=each.count, values=values))
                    if each.count else say(Phrase("{name}: none", name=each.name)))  # fmt: skip
    if locus.centroid is not None:
        angles = ", ".join(f"{number_text(number(angle))}°" for angle in locus.angles)
        told.append(say(Phrase("asymptotes from {x} in the directions {angles}",
                               x=number_text(number(locus.centroid)), angles=angles)))  # fmt: skip
    for point, gain in locus.meetings:
        at = complex_number(point)
        if at.imag >= 0:
            told.append(say(Phrase("branches meet at {point} for {K} = {gain}", point=_pair(at), K=K,
                                   gain=number_text(number(gain)))))  # fmt: skip
    crossing = (
        "branches cross the unit circle at {point} for {K} = {gain}"
        if locus.discrete
        else "branches cross the imaginary axis at {point} for {K} = {gain}"
    )
    for point, gain in locus.crossings:
        text = _pair(complex_number(point))
        told.append(say(Phrase(crossing, point=text, K=K, gain=number_text(number(gain)))))
    return ". ".join(text[:1].upper() + text[1:] for text in told) + "."


def _pair(point: complex) -> str:
    """A real point, or a pair by the one above the real axis."""
    listed = [(point.conjugate(), 1), (point, 1)] if point.imag else [(point, 1)]
    return next(iter(values_text(listed)))
