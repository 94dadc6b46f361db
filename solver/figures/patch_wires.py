"""The wires of a patch diagram: upright in channels between columns, level in lanes between rows.

Each wire leaves its cell to the right into the channel there, runs in a lane to channels of other columns, and enters
inputs from the channel left of them. Symbols stand outside channels and lanes, so that no wire meets one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise, permutations
from typing import NamedTuple

from solver.figures.layout import Point
from solver.figures.patch_cells import BESIDE, START, Cells
from solver.figures.patch_places import Spot
from solver.figures.patch_tracks import ordered, tracks

STEP, MARGIN = 0.3, 0.22
"""Distance of wires in a channel, and beside the outer ones."""
NEAR = 0.12
"""Wires of two outputs are at least so far apart in height."""
HARD = 1000.0
"""What it costs that wires lie upon each other."""
ABOUT = 3.5
"""About the width of a column."""
ROUNDS = 2

Segment = tuple[Point, Point]


@dataclass(frozen=True)
class Plan:
    """What can be chosen: the spot of each cell, the order of its inputs from above, the lane of each wire."""

    cells: Cells
    spots: tuple[Spot, ...]
    orders: tuple[tuple[int, ...], ...]
    lanes: tuple[int, ...]


class Channel(NamedTuple):
    """What one wire has in one channel: it is upright from `low` to `high`.

    `left` and `right` are the heights at which it comes from a cell and goes to inputs; `leftward` and `rightward` are
    those of all that lies left and right of it there, its lane too.
    """

    left: tuple[float, ...]
    right: tuple[float, ...]
    leftward: tuple[float, ...]
    rightward: tuple[float, ...]
    low: float
    high: float

    @property
    def straight(self) -> bool:
        """Whether it only passes."""
        return self.high - self.low < NEAR / 2


class Wiring:
    """The wires of a plan with their heights, tracks and crossings."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.nets = plan.cells.nets
        self.rows = max((row for row, _ in plan.spots), default=0) + 1
        self.columns = max((column for _, column in plan.spots), default=0) + 1
        self.offsets = [cell.offsets(order) for cell, order in zip(plan.cells.cells, plan.orders, strict=True)]
        self.shifts = self._shifts()
        self.ranks: dict[int, list[int]] = {}
        for _ in range(ROUNDS):
            self.levels = self._levels()
            self.ys = self._heights()
            self.channels = self._channels()
            self.ranks = {channel: self._upright(channel) for channel in range(self.columns + 1)}

    # where each wire goes

    def column(self, cell: int) -> int:
        """The column of a cell, which is also the channel left of it."""
        return self.plan.spots[cell][1]

    @cached_property
    def spans(self) -> list[tuple[int, int]]:
        """The outer channels of each wire."""
        found = []
        for net in self.nets:
            used = [self.column(net.start) + 1, *(self.column(end) for end, _ in net.ends)]
            found.append((min(used), max(used)))
        return found

    def in_lane(self, number: int) -> bool:
        """Whether a wire runs in a lane."""
        low, high = self.spans[number]
        return low < high

    # heights

    def _shifts(self) -> list[float]:
        """How far the middle of each cell is above that of its row: an input is at the height of its neighbour."""
        at = {spot: cell for cell, spot in enumerate(self.plan.spots)}
        found = [0.0] * len(self.plan.spots)
        feeds = {net.start: dict(reversed(net.ends)) for net in self.nets}
        for (row, column), cell in sorted(at.items()):
            before = at.get((row, column - 1))
            if before is None:
                continue
            mine, out = self.offsets[cell], found[before]
            if cell in feeds.get(before, {}):
                found[cell] = out - mine[feeds[before][cell]]
                continue
            tries = (0.0, *(sign * 0.15 * k for k in range(1, 6) for sign in (1, -1)))
            found[cell] = next((s for s in tries if all(abs(s + y - out) > NEAR for y in mine)), 0.0)
        return found

    @cached_property
    def extents(self) -> list[tuple[float, float]]:
        """How far each row reaches below and above its middle."""
        found = [(0.0, 0.0)] * self.rows
        for number, ((row, _), cell) in enumerate(zip(self.plan.spots, self.plan.cells.cells, strict=True)):
            half = cell.half_height(self.offsets[number])
            tops = [y + port.above for y, port in zip(self.offsets[number], cell.ports, strict=True)]
            lows = [y - port.below for y, port in zip(self.offsets[number], cell.ports, strict=True)]
            top = max([half + (START if cell.starts else 0.0), BESIDE + 0.3, *tops]) + self.shifts[number]
            low = min([-half, *lows]) + self.shifts[number]
            found[row] = min(found[row][0], low), max(found[row][1], top)
        return found

    def _levels(self) -> dict[int, int]:
        """The track of each wire in its lane, from above."""
        found: dict[int, int] = {}
        for lane in range(self.rows + 1):
            mine = [n for n in range(len(self.nets)) if self.in_lane(n) and self.plan.lanes[n] == lane]
            order = ordered(mine, {(i, j): self._above(lane, i, j) for i, j in permutations(mine, 2)})
            found.update(tracks(order, lambda i, j: self.spans[i][1] < self.spans[j][0]
                                or self.spans[j][1] < self.spans[i][0]))  # fmt: skip
        return found

    def _above(self, lane: int, i: int, j: int) -> float:
        """How often wires cross if i runs above j in their lane."""
        return sum(self._inside(j, x) for x in self._stubs(lane, i, upward=False)) + sum(
            self._inside(i, x) for x in self._stubs(lane, j, upward=True)
        )

    def _stubs(self, lane: int, number: int, *, upward: bool) -> list[tuple[int, float]]:
        """The places (channel, rank) at which a wire leaves its lane upward or downward."""
        net, found = self.nets[number], []
        row, column = self.plan.spots[net.start]
        ends = [(column + 1, row), *((self.column(end), self.plan.spots[end][0]) for end, _ in net.ends)]
        for channel, at in ends:
            if (at < lane) == upward:
                found.append((channel, self._rank(channel, number)))
        return list(dict.fromkeys(found))

    def _rank(self, channel: int, number: int) -> float:
        ranks = self.ranks.get(channel, [])
        return float(ranks.index(number)) if number in ranks else 0.5

    def _inside(self, number: int, x: tuple[int, float]) -> float:
        """Whether a wire in its lane passes a place; a half where it is not known."""
        low, high = self.spans[number]
        first, last = (low, self._rank(low, number)), (high, self._rank(high, number))
        if x in (first, last):
            return 0.5
        return float(first < x < last)

    def _heights(self) -> list[float]:
        """The middle of each row."""
        counts = [0] * (self.rows + 1)
        for number, level in self.levels.items():
            counts[self.plan.lanes[number]] = max(counts[self.plan.lanes[number]], level + 1)
        self.tops, found, y = [], [], 0.0
        for row, (low, high) in enumerate(self.extents):
            self.tops.append(y - MARGIN)
            y -= 2 * MARGIN + STEP * max(counts[row] - 1, 0) if counts[row] else MARGIN
            found.append(y - high)
            y += low - high
        self.tops.append(y - MARGIN)
        return found

    def middle(self, cell: int) -> float:
        """The height of the middle of a cell."""
        return self.ys[self.plan.spots[cell][0]] + self.shifts[cell]

    def port(self, cell: int, port: int) -> float:
        """The height of an input."""
        return self.middle(cell) + self.offsets[cell][port]

    def lane(self, number: int) -> float:
        """The height of a wire in its lane."""
        return self.tops[self.plan.lanes[number]] - STEP * self.levels[number]

    # channels

    def _channels(self) -> dict[tuple[int, int], Channel]:
        """What each wire (by number) has in each channel."""
        found = {}
        for number, net in enumerate(self.nets):
            low, high = self.spans[number]
            first = self.column(net.start) + 1
            for channel in dict.fromkeys([first, *(self.column(end) for end, _ in net.ends)]):
                left = (self.middle(net.start),) if channel == first else ()
                right = tuple(self.port(*end) for end in net.ends if self.column(end[0]) == channel)
                lane = (self.lane(number),) if low < high else ()
                beside = lane * (channel > low), lane * (channel < high)
                ys = left + right + lane
                found[channel, number] = Channel(left, right, left + beside[0], right + beside[1], min(ys), max(ys))
        return found

    def _upright(self, channel: int) -> list[int]:
        """The wires that are upright in a channel, from left to right."""
        mine = [n for n in range(len(self.nets)) if (channel, n) in self.channels]
        mine = [n for n in mine if not self.channels[channel, n].straight]
        costs = {(i, j): self._left_of(channel, i, j) for i, j in permutations(mine, 2)}
        return ordered(mine, costs)

    @cached_property
    def tracks(self) -> dict[tuple[int, int], int]:
        """The track of each wire in each channel, from the left."""
        found = {}
        for channel, order in self.ranks.items():
            spans = {n: self.channels[channel, n][-2:] for n in order}
            mine = tracks(order, lambda i, j, s=spans: s[i][1] + MARGIN < s[j][0] or s[j][1] + MARGIN < s[i][0])  # type: ignore[misc]
            found.update({(channel, n): track for n, track in mine.items()})
        return found

    def segments(self, number: int, x: Callable[[int, int], float], ends: Callable[[int], tuple[float, float]]
                 ) -> list[Segment]:  # fmt: skip
        """Return the pieces of a wire; `x` is where a track of a channel is, `ends` where a cell begins and ends."""
        net, found = self.nets[number], []
        for channel in range(self.columns + 1):
            if (each := self.channels.get((channel, number))) is None:
                continue
            at = x(channel, self.tracks.get((channel, number), 0))
            if not each.straight:
                found.append(((at, each.low), (at, each.high)))
            if each.left:
                found.append(((ends(net.start)[1], each.left[0]), (at, each.left[0])))
            found += [((at, self.port(*end)), (ends(end[0])[0], self.port(*end)))
                      for end in net.ends if self.column(end[0]) == channel]  # fmt: skip
        if self.in_lane(number):
            used = sorted(channel for channel, n in self.channels if n == number)
            points = [(x(channel, self.tracks[channel, number]), self.lane(number)) for channel in used]
            found += pairwise(points)
        return found

    @cached_property
    def quality(self) -> tuple[int, float]:
        """How many wires cross, and about how long they are."""

        def x(channel: int, track: int) -> float:
            return ABOUT * channel + STEP * track

        def ends(cell: int) -> tuple[float, float]:
            return ABOUT * self.column(cell) + ABOUT / 2, ABOUT * (self.column(cell) + 1)

        wires = [self.segments(number, x, ends) for number in range(len(self.nets))]
        length = sum(abs(a[0] - b[0]) + abs(a[1] - b[1]) for wire in wires for a, b in wire)
        return crossings(wires), length

    def _left_of(self, channel: int, i: int, j: int) -> float:
        """How often wires cross if i is left of j."""
        one, other = self.channels[channel, i], self.channels[channel, j]
        total = 0.0
        for y in other.leftward:
            total += one.low - NEAR / 2 < y < one.high + NEAR / 2
            total += HARD * any(abs(y - v) < NEAR / 2 for v in one.rightward)
        for y in one.rightward:
            total += other.low - NEAR / 2 < y < other.high + NEAR / 2
        return total


def crossings(wires: Sequence[Sequence[Segment]]) -> int:
    """Return how often different wires cross."""
    level = [
        (n, a[1], min(a[0], b[0]), max(a[0], b[0])) for n, wire in enumerate(wires) for a, b in wire if a[1] == b[1]
    ]
    upright = [(n, a[0], a[1], b[1]) for n, wire in enumerate(wires) for a, b in wire if a[1] != b[1]]
    return sum(
        n != m and left < x < right and low < y < high for n, y, left, right in level for m, x, low, high in upright
    )
