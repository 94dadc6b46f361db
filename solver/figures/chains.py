"""Chains of integrators laid out: rows of integrators, what feeds back below them, what bypasses them above.

Each row is drawn from left to right. Every signal that joins a row gets a sum of its own, every signal that leaves it
a dot of its own, so that no wire meets a box; a lane below leads what is fed back, lanes above lead inputs and outputs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from solver.derivation.figures import Chains
from solver.figures.layout import RADIUS, Block, Dot, Label, Layout, Point, Sum
from solver.formula.terminal import flat

BUS, START, GAP = 0.6, 1.2, 0.45
BESIDE, LANE, STEP = 1.25, 2.35, 1.25
"""How far from a row gains on upright wires stand, the lane of many wires runs, and lanes of single ones are apart."""


def width_of(text: str) -> float:
    """Return how wide a block must be for a formula."""
    return max(0.9, 0.5 + 0.19 * len(flat(text)))


@dataclass(frozen=True, slots=True)
class Group:
    """What is fed back in one lane: (source, target, gain); one target collects, or one source distributes."""

    edges: tuple[tuple[int, int, str], ...]
    depth: float

    @property
    def targets(self) -> list[int]:
        """Where it ends, each once."""
        return list(dict.fromkeys(target for _, target, _ in self.edges))

    @property
    def sources(self) -> list[int]:
        """Where it begins, each once."""
        return list(dict.fromkeys(source for source, _, _ in self.edges))

    def gain_beside(self, state: int, *, entering: bool) -> str:
        """Return the gain on the upright wire at a state; "" where it stands in the lane, or is none."""
        if len(self.edges) == 1 or (len(self.targets) == 1) == entering:
            return ""
        return next(gain for source, target, gain in self.edges if state == (target if entering else source))


def groups_of(row: Sequence[int], A: Sequence[Sequence[str]]) -> list[Group]:
    """Return the lanes below a row: one for all where they share an end, else one for each; short ones come first."""
    place = {state: i for i, state in enumerate(row)}
    edges = [(q, p, A[p][q]) for q in row for p in row if A[p][q] and place[q] >= place[p]]
    if len(edges) > 1 and (len({p for _, p, _ in edges}) == 1 or len({q for q, _, _ in edges}) == 1):
        return [Group(tuple(edges), LANE)]
    edges.sort(key=lambda edge: place[edge[0]] - place[edge[1]])
    found: list[tuple[tuple[int, int, str], int]] = []
    for edge in edges:
        below = [level for other, level in found if _meet(place, edge, other)]
        found.append((edge, max(below, default=0) + 1))
    return [Group((edge,), STEP * level) for edge, level in sorted(found, key=lambda each: each[1])]


def _meet(place: Mapping[int, int], edge: tuple[int, int, str], other: tuple[int, int, str]) -> bool:
    """Whether two wires back run below one state."""
    return place[edge[1]] <= place[other[0]] and place[other[1]] <= place[edge[0]]


@dataclass
class Row:
    """One row while it is drawn: `x` is where drawing goes on, `pen` where the wire begins that ends there."""

    layout: Layout
    figure: Chains
    states: Sequence[int]
    y: float
    groups: list[Group]
    x: float = START
    pen: float | None = None
    into: dict[tuple[int, int], float] = field(default_factory=dict)
    out: dict[tuple[int, int], float] = field(default_factory=dict)
    middle: dict[int, float] = field(default_factory=dict)
    above: dict[int, float] = field(default_factory=dict)
    taps: dict[int, float] = field(default_factory=dict)

    def draw(self) -> None:
        """Draw the row and its lanes."""
        for i, state in enumerate(self.states):
            gain = self.figure.b[state] if i == 0 else self.figure.A[state][self.states[i - 1]]
            if gain:
                self.pen = BUS if i == 0 else self.pen
                self._gain(gain)
            self._joined(state, from_above=bool(i and self.figure.b[state]))
            self._integrator(state)
            self._left(state, last=i == len(self.states) - 1)
        for number, group in enumerate(self.groups):
            self._lane(number, group)

    def _to(self, x: float, *, arrow: bool = True) -> None:
        """Draw the wire to a place."""
        if self.pen is not None and x > self.pen:
            self.layout.wire((self.pen, self.y), (x, self.y), arrow=arrow)

    def _gain(self, gain: str) -> None:
        if gain != "1":
            width = width_of(gain)
            self._to(self.x + GAP)
            self.layout.add(Block(self.x + GAP + width / 2, self.y, gain, width))
            self.x += GAP + width
            self.pen = self.x

    def _joined(self, state: int, *, from_above: bool) -> None:
        """A sum for each lane that ends here, the longest first; the input from above shares the last one."""
        entering = [i for i, group in reversed(list(enumerate(self.groups))) if state in group.targets]
        count = max(len(entering), int(from_above))
        for k in range(count):
            below = self.groups[entering[k]].gain_beside(state, entering=True) if k < len(entering) else ""
            upper = self.figure.b[state] if from_above and k == count - 1 else ""
            room = max(GAP + RADIUS, *(width_of(text) / 2 + 0.2 for text in (below, upper) if text), 0)
            x = self.x + room
            self._to(x - RADIUS)
            self.layout.add(Sum(x, self.y))
            if k < len(entering):
                self.into[entering[k], state] = x
            if upper:
                self.above[state] = x
            self.x, self.pen = x + max(room - GAP, RADIUS), x + RADIUS

    def _integrator(self, state: int) -> None:
        lanes = [group.edges[0][2] for group in self.groups if len(group.edges) == 1 and state in group.targets]
        room = max([1.0, *(width_of(gain) for gain in lanes)])
        self.middle[state] = self.x + GAP + room / 2
        self._to(self.middle[state] - 0.5)
        self.layout.add(Block(self.middle[state], self.y, r"z^{-1}" if self.figure.discrete else "1/s", 1.0))
        self.x += GAP + room
        self.pen = self.middle[state] + 0.5
        self.layout.add(Label(self.x + 0.3, self.y, f"x_{{{state + 1}}}", "above"))
        self.x += 0.2

    def _left(self, state: int, *, last: bool) -> None:
        """A dot for each lane that begins here, the shortest first; the output's shares the first one."""
        leaving = [i for i, group in enumerate(self.groups) if state in group.sources]
        upper = self.figure.c[state] if not last else ""
        for k in range(max(len(leaving), int(bool(upper)))):
            below = self.groups[leaving[k]].gain_beside(state, entering=False) if k < len(leaving) else ""
            room = max(GAP, *(width_of(text) / 2 + 0.15 for text in (below, upper) if text and text != "1"), 0)
            x = self.x + room
            self.layout.add(Dot(x, self.y))
            if k < len(leaving):
                self.out[leaving[k], state] = x
            if upper and k == 0:
                self.taps[state] = x
            self.x = x + max(room - GAP, 0.0)

    def _lane(self, number: int, group: Group) -> None:
        """The wires below the row of one group."""
        low = self.y - group.depth
        begin = {q: self.out[number, q] for q in group.sources}
        end = {p: self.into[number, p] for p in group.targets}
        if len(group.edges) == 1:
            self._single(begin, end, group.edges[0], low)
        elif len(group.targets) == 1:
            signals = [(begin[q], gain) for q, _, gain in reversed(group.edges)]
            self.collected(signals, low, (next(iter(end.values())), self.y - RADIUS))
        else:
            ((_, source),) = begin.items()
            self.distributed((source, self.y), low, [(end[p], gain) for _, p, gain in reversed(group.edges)])

    def _single(self, begin: dict[int, float], end: dict[int, float], edge: tuple[int, int, str], low: float) -> None:
        """One wire back, its gain below the integrator of its target."""
        q, p, gain = edge
        last = (end[p], self.y - RADIUS)
        if gain == "1":
            self.layout.wire((begin[q], self.y), (begin[q], low), (end[p], low), last)
            return
        width = width_of(gain)
        left, right = self.middle[p] - width / 2, self.middle[p] + width / 2
        self.layout.add(Block(self.middle[p], low, gain, width))
        self.layout.wire((begin[q], self.y), (begin[q], low), (right, low))
        self.layout.wire((left, low), (end[p], low), last)

    def collected(self, signals: Sequence[tuple[float, str]], lane: float, *last: Point, arrow: bool = True) -> None:
        """Signals from the row led to a lane, each with its gain, added there one by one and led on."""
        toward = 1 if lane > self.y else -1
        onward = 1 if last[0][0] > signals[0][0] else -1
        pen: Point = (0.0, 0.0)
        for i, (x, gain) in enumerate(signals):
            self._upright((x, self.y), gain, lane - toward * (RADIUS if i else 0), arrow=bool(i))
            if i:
                self.layout.wire(pen, (x - onward * RADIUS, lane))
                self.layout.add(Sum(x, lane))
                pen = (x + onward * RADIUS, lane)
            else:
                pen = (x, lane)
        self.layout.wire(pen, (last[0][0], lane), *last, arrow=arrow)

    def _upright(self, start: Point, gain: str, stop: float, *, arrow: bool) -> None:
        """An upright wire from a point to a height, with its gain."""
        x, y = start
        toward = 1 if stop > y else -1
        if gain != "1":
            middle = y + toward * BESIDE
            self.layout.add(Block(x, middle, gain, width_of(gain)))
            self.layout.wire(start, (x, middle - toward * 0.45))
            start = (x, middle + toward * 0.45)
        self.layout.wire(start, (x, stop), arrow=arrow)

    def distributed(self, source: Point, lane: float, targets: Sequence[tuple[float, str]]) -> None:
        """A signal led to a lane and along it, and from it to sums of the row, each with its gain."""
        toward = 1 if lane > self.y else -1
        before: Point | None = None
        for i, (x, gain) in enumerate(targets):
            way = [source, (source[0], lane)] if before is None else [before]
            if i < len(targets) - 1:
                self.layout.add(Dot(x, lane))
            if gain == "1":
                self.layout.wire(*way, (x, lane), (x, self.y + toward * RADIUS))
            else:
                middle = self.y + toward * BESIDE
                self.layout.add(Block(x, middle, gain, width_of(gain)))
                self.layout.wire(*way, (x, lane), (x, middle + toward * 0.45))
                self.layout.wire((x, middle - toward * 0.45), (x, self.y + toward * RADIUS))
            before = (x, lane)
