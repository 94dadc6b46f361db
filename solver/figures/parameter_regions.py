"""Where conditions on two parameters hold together, as a plot: column by column, by the roots in the second parameter.

In a column the polynomials are those of one variable; between their real roots the conditions hold or fail. Columns lie
denser where the number of these stretches changes, so that corners are sharp.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import combinations, pairwise
from typing import Any

import numpy as np

from solver.derivation.figures import DrawnCurve, DrawnPlot
from solver.derivation.parameter_figures import ParameterRegion
from solver.figures.alternatives import number_text, text_of
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.words import Phrase

Point = tuple[float, float]
Window = tuple[float, float, float, float]
Stretch = tuple[float, float]

COLUMNS = 161
HALVINGS = 26
AROUND = 0.7
"""What is shown around the corners, in parts of their extent."""

NEAR = 1e-9
INSIDE = 1e-7
MOST_NAMED = 5


class _Column:
    """The polynomials in y at values of x, by their coefficients as functions of x."""

    def __init__(self, region: ParameterRegion) -> None:
        self.x, self.y = region.x, region.y
        self.polynomials = [sp.Poly(each, region.y) for each in region.conditions]
        self._coefficients = [each.all_coeffs() for each in self.polynomials]
        self._known: dict[tuple[int, float], tuple[list[float], list[float]]] = {}

    def roots(self, i: int, at: float) -> list[float]:
        """The real roots in y of one polynomial, rising."""
        return self._at(i, at)[1]

    def _at(self, i: int, at: float) -> tuple[list[float], list[float]]:
        """The coefficients of one polynomial in a column, and its real roots."""
        if (i, at) not in self._known:
            listed = [self._value(c, at) for c in self._coefficients[i]]
            self._known[i, at] = listed, _real_roots(np.array(listed))
        return self._known[i, at]

    def _value(self, c: Any, at: float) -> float:
        return float(numeric.evaluate(c, {self.x: complex(at)}).real)

    def holds(self, at: float, y: float) -> bool:
        """Whether all conditions hold at a point."""
        return all(np.polyval(self._at(i, at)[0], y) > 0 for i in range(len(self.polynomials)))

    def stretches(self, at: float, low: float, high: float) -> list[Stretch]:
        """Where in a column all conditions hold, from below."""
        every = (y for i in range(len(self.polynomials)) for y in self.roots(i, at))
        cuts = sorted({low, high, *(y for y in every if low < y < high)})
        found: list[Stretch] = []
        for a, b in pairwise(cuts):
            if b - a > NEAR * (high - low) and self.holds(at, (a + b) / 2):
                if found and abs(found[-1][1] - a) < NEAR * (high - low):
                    found[-1] = (found[-1][0], b)
                else:
                    found.append((a, b))
        return found


def _real_roots(listed: Any) -> list[float]:
    """The real roots of a polynomial by its coefficients, rising; leading ones that are nothing are left out."""
    size = np.max(np.abs(listed), initial=0.0)
    kept = np.trim_zeros(np.where(np.abs(listed) < 1e-14 * size, 0.0, listed), "f")
    found = np.roots(kept) if len(kept) > 1 else np.array([])
    return sorted(float(z.real) for z in found if abs(z.imag) < 1e-7 * (1 + abs(z)))


def on_parameters(region: ParameterRegion) -> DrawnPlot:
    """Return the region of two parameters as a plot: shaded, with the curves on which a condition turns."""
    column = _Column(region)
    window = _window([*corners_of(region), *_intercepts(region, column)])
    xs = _columns(window, lambda at: len(column.stretches(at, *window[2:])))
    areas = list(_areas(xs, [column.stretches(at, *window[2:]) for at in xs]))
    curves = [each for i, name in enumerate(region.names) for each in _edges(column, i, name, window)]
    labels = region.labels
    return DrawnPlot(region.caption, labels[0], labels[1], (*areas, *curves), (), equal=False, window=window)


def _factors(region: ParameterRegion) -> tuple[sp.Expr, ...]:
    """The irreducible factors of the conditions: curves with a part in common meet in its points everywhere."""
    found = (factor for each in region.conditions for factor, _ in sp.factor_list(each, region.x, region.y)[1])
    return tuple(dict.fromkeys(found))


def corners_of(region: ParameterRegion) -> list[Point]:
    """Return the points in which two of the curves meet at the edge of the region."""
    column = _Column(region)
    found: list[Point] = []
    for first, second in combinations(_factors(region), 2):
        for x, y in _meetings(first, second, region):
            slack = [
                float(numeric.evaluate(c, {region.x: complex(x), region.y: complex(y)}).real) for c in region.conditions
            ]
            if all(value > -INSIDE * (1 + abs(x) + abs(y)) for value in slack) and _beside(column, (x, y)):
                found += (
                    [] if any(abs(x - a) + abs(y - b) < 1e-6 * (1 + abs(x) + abs(y)) for a, b in found) else [(x, y)]
                )
    return sorted(found)


def _intercepts(region: ParameterRegion, column: _Column) -> Iterator[Point]:
    """Points of the axes at the edge of the region."""
    for each in _factors(region):
        for along, other in ((region.x, region.y), (region.y, region.x)):
            p = each.xreplace({other: sp.S.Zero})
            for value in _real(sp.Poly(p, along)) if p.has(along) else ():
                point = (value, 0.0) if along == region.x else (0.0, value)
                if _beside(column, point):
                    yield point


def _meetings(first: Any, second: Any, region: ParameterRegion) -> Iterator[Point]:
    """Common real zeros of two polynomials, by their resultant."""
    common = sp.resultant(first, second, region.y) if first.has(region.y) or second.has(region.y) else sp.S.Zero
    if common == 0 or not common.has(region.x):
        return
    for x in _real(sp.Poly(common, region.x)):
        for each in (first, second):
            p = sp.Poly(each, region.y)
            listed = [float(numeric.evaluate(c, {region.x: complex(x)}).real) for c in p.all_coeffs()]
            for y in np.roots(listed) if p.degree() > 0 else ():
                values = [
                    abs(numeric.evaluate(c, {region.x: complex(x), region.y: complex(y)})) for c in (first, second)
                ]
                if abs(y.imag) < 1e-7 * (1 + abs(y)) and max(values) < 1e-5 * (1 + abs(x) + abs(y)) ** 2:
                    yield x, float(y.real)


def _real(p: Any) -> list[float]:
    found = np.roots([float(c) for c in p.all_coeffs()])
    return sorted({float(z.real) for z in found if abs(z.imag) < 1e-6 * (1 + abs(z))})


def _beside(column: _Column, point: Point) -> bool:
    """Whether the region is next to a point."""
    size = 1e-4 * (1 + abs(point[0]) + abs(point[1]))
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    return any(column.holds(point[0] + size * np.cos(a), point[1] + size * np.sin(a)) for a in angles)


def _window(corners: Sequence[Point]) -> Window:
    """Around the corners and the origin, with room for what has no end."""
    ends: list[float] = []
    for i in (0, 1):
        values = [0.0, *(corner[i] for corner in corners)]
        low, high = min(values), max(values)
        extent = (high - low) or 2.0
        ends += [low - AROUND * extent, high + AROUND * extent]
    return ends[0], ends[1], ends[2], ends[3]


def _columns(window: Window, count: Callable[[float], int]) -> list[float]:
    """Values of x, with two next to each place where the number of stretches changes."""
    xs = [float(x) for x in np.linspace(window[0], window[1], COLUMNS)]
    more: list[float] = []
    counts = [count(x) for x in xs]
    for (a, first), (b, second) in pairwise(zip(xs, counts, strict=True)):
        if first != second:
            low, high = a, b
            for _ in range(HALVINGS):
                middle = (low + high) / 2
                low, high = (middle, high) if count(middle) == first else (low, middle)
            more += [low, high]
    return sorted({*xs, *more})


def _areas(xs: Sequence[float], stretches: Sequence[Sequence[Stretch]]) -> Iterator[DrawnCurve]:
    """Polygons over runs of columns with the same number of stretches."""
    start = 0
    for end in range(1, len(xs) + 1):
        if end < len(xs) and len(stretches[end]) == len(stretches[start]):
            continue
        for i in range(len(stretches[start])):
            lower, upper = ([stretches[k][i][side] for k in range(start, end)] for side in (0, 1))
            across = list(xs[start:end])
            yield DrawnCurve("", "area", (*across, *across[::-1]), (*lower, *upper[::-1]))
        start = end


def _edges(column: _Column, i: int, name: str, window: Window) -> Iterator[DrawnCurve]:
    """The curve on which a condition turns, in pieces that have one value in each column."""
    left, right, low, high = window
    p = column.polynomials[i]
    if p.degree() == 0:
        for x in _real(sp.Poly(p.as_expr(), column.x)):
            if left < x < right:
                yield DrawnCurve(name, "line", (x, x), (low, high))
        return
    xs = _columns(window, lambda at: len(column.roots(i, at)))
    listed = [column.roots(i, at) for at in xs]
    start = 0
    for end in range(1, len(xs) + 1):
        if end < len(xs) and len(listed[end]) == len(listed[start]):
            continue
        for k in range(len(listed[start])):
            points = [(xs[j], listed[j][k]) for j in range(start, end)]
            yield from (DrawnCurve(name, "line", *zip(*run, strict=True)) for run in _within(points, low, high))
        start = end


def _within(points: Sequence[Point], low: float, high: float) -> Iterator[list[Point]]:
    """The stretches of a curve between two heights, cut off there."""
    run: list[Point] = []
    for before, after in pairwise(points):
        inside = [low <= y <= high for _, y in (before, after)]
        if inside[0] and not run:
            run = [before]
        if inside == [True, True]:
            run.append(after)
        elif inside[0] != inside[1]:
            edge = _at_edge(before, after, high if max(before[1], after[1]) > high else low)
            if inside[0]:
                yield [*run, edge]
                run = []
            else:
                run = [edge, after]
    if len(run) > 1:
        yield run


def _at_edge(a: Point, b: Point, height: float) -> Point:
    part = (height - a[1]) / (b[1] - a[1])
    return a[0] + part * (b[0] - a[0]), height


def of_parameters(region: ParameterRegion, say: Callable[[str], str]) -> str:
    """Tell what is shaded, which curves bound it, and its corners."""
    x, y = map(text_of, region.labels)
    told = [
        say(Phrase("the plane of {x} and {y}", x=x, y=y)),
        say("shaded: where all roots lie in the left half plane"),
    ]
    told.append(say(Phrase("drawn: {curves}", curves=", ".join(text_of(name) for name in region.names))))
    corners = [f"({number_text(a)}, {number_text(b)})" for a, b in corners_of(region)]
    if corners:
        told.append(say(Phrase("corners of the region: {points}", points=", ".join(corners))))
    return ". ".join(text[:1].upper() + text[1:] for text in told) + "."
