"""The bodies, links and grounds in the schematic of a mechanical system as strokes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import atan2, degrees, hypot

from solver.derivation.mechanisms import Joint, Link, Mechanism, Place, Turn
from solver.figures.chains import width_of
from solver.figures.layout import Label
from solver.figures.strokes import (
    Line,
    Ring,
    Shape,
    Stroke,
    along,
    direction,
    hatched,
    label_beside,
    middle,
    moved,
    zigzag,
)

UNIT = 2.4
"""Centimetres of the longest rod."""
WIDTH, HEIGHT, DISC, HINGE = 1.5, 0.9, 0.3, 0.09
LEAST = 0.6
"""So much of a spring or a rod is seen at least, and half of it between bodies."""
UPRIGHT = 0.99
GROUND, WALL, FOOT, BEAM = 0.8, 0.55, 0.42, 0.07
"""How far a ground goes on, half of a wall, the height of a support, half of a beam."""


@dataclass
class Parts:
    """A drawing with the places of its joints."""

    mechanism: Mechanism

    @cached_property
    def places(self) -> list[Place]:
        """Where the joints are."""
        return [(x * UNIT, y * UNIT) for x, y in (each.place for each in self.mechanism.joints)]

    @cached_property
    def hinges(self) -> list[int]:
        """The joints on which rods and beams turn, and no disc hides it."""
        turning = {self.mechanism.links[each.link].ends[0] for each in self.mechanism.turns}
        return sorted(i for i in turning if self.mechanism.joints[i].shape != "disc")

    @cached_property
    def turns(self) -> dict[int, Turn]:
        """The angles by the links that they are those of."""
        return {each.link: each for each in self.mechanism.turns}

    def axes(self, number: int) -> tuple[Place, Place, bool]:
        """The direction of a joint's line to the right, that across it and upward; and whether the line is upright."""
        u = self.mechanism.joints[number].direction or (1.0, 0.0)
        if abs(u[1]) > UPRIGHT:
            return (0.0, 1.0), (1.0, 0.0), True
        u = u if u[0] > 0 else (-u[0], -u[1])
        return u, (-u[1], u[0]), False

    def halves(self, number: int) -> tuple[float, float]:
        """Half of the size of a joint along its line and across it."""
        joint = self.mechanism.joints[number]
        if joint.shape == "box":
            wide = 2 * width_of(joint.label) if number in self.hinges else width_of(joint.label) + 0.3
            wide = max(WIDTH, wide) / 2
            return (HEIGHT / 2, wide) if self.axes(number)[2] else (wide, HEIGHT / 2)
        size = {"disc": (DISC, DISC), "pivot": (0.32, 0.16)}
        return size.get(joint.shape, (0.0, 0.0))

    def others(self, number: int) -> list[int]:
        """The other ends of the links at a joint."""
        return [sum(link.ends) - number for link in self.mechanism.links if number in link.ends]

    def gap(self, i: int, j: int) -> float:
        """Return how far two joints are apart, about."""
        room = []
        for number in (i, j):
            (half, across), (u, n, _) = self.halves(number), self.axes(number)
            room.append((half * abs(u[0]) + across * abs(n[0]), half * abs(u[1]) + across * abs(n[1])))
        (x0, y0), (x1, y1) = self.places[i], self.places[j]
        return max(abs(x1 - x0) - room[0][0] - room[1][0], abs(y1 - y0) - room[0][1] - room[1][1])

    def seen(self, link: Link) -> float:
        """Return the length of a link that is seen; below zero where bodies lie over all of it."""
        a, b = self.edges(link)
        (p, q) = (self.places[end] for end in link.ends)
        u, v = direction(p, q), direction(a, b)
        return hypot(b[0] - a[0], b[1] - a[1]) * (1 if u[0] * v[0] + u[1] * v[1] > 0 else -1)

    def edges(self, link: Link) -> tuple[Place, Place]:
        """Return where a link comes out of what it joins."""
        first, second = link.ends
        u = direction(self.places[first], self.places[second])
        back = (-u[0], -u[1])
        reach = HINGE if first in self.hinges else self._reach(first, u)
        return (moved(self.places[first], (reach, u)),
                moved(self.places[second], (self._reach(second, u), back)))  # fmt: skip

    def _reach(self, number: int, u: Place) -> float:
        """How far a body reaches in a direction."""
        if self.mechanism.joints[number].shape == "disc":
            return DISC
        (half, across), (w, n, _) = self.halves(number), self.axes(number)
        shares = [(half, abs(u[0] * w[0] + u[1] * w[1])), (across, abs(u[0] * n[0] + u[1] * n[1]))]
        return min((size / share for size, share in shares if share > 1e-6), default=0.0)

    def strokes(self) -> Iterator[Stroke]:
        """Yield the supports, the links and the bodies, what lies behind first."""
        joints, links = self.mechanism.joints, self.mechanism.links
        for i, joint in enumerate(joints):
            if joint.shape == "support":
                yield from self._support(i)
        for i, joint in enumerate(joints):
            if joint.shape in ("box", "pivot"):
                yield from self._box(i, joint)
        for number, link in enumerate(links):
            yield from self._link(number, link)
        yield from (Ring(self.places[i], HINGE, joint=True) for i in self.hinges)
        for i, joint in enumerate(joints):
            if joint.shape == "disc":
                yield Ring(self.places[i], DISC)
                yield label_beside(self.places[i], along(self._free(i)), joint.label, DISC)

    def _support(self, number: int) -> Iterator[Stroke]:
        """A triangle on the side where no link is, and the hatched line that it stands on."""
        place = self.places[number]
        rise = sum(self.places[other][1] - place[1] for other in self.others(number))
        side = (0.0, 1.0 if rise < 0 else -1.0)
        a, b = (moved(place, (FOOT, side), (way * 0.28, (1.0, 0.0))) for way in (-1, 1))
        yield Shape((place, a, b))
        yield from hatched(moved(a, (-0.25, (1.0, 0.0))), moved(b, (0.25, (1.0, 0.0))), side)

    def _box(self, number: int, joint: Joint) -> Iterator[Stroke]:
        """A box along its line, its label on the side where no rod is."""
        (half, across), (u, n, _), place = self.halves(number), self.axes(number), self.places[number]
        yield Shape(
            tuple(moved(place, (a * half, u), (b * across, n)) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
        )
        if number in self.hinges:
            lean = sum(self.places[other][0] - place[0] for other in self.others(number))
            width = max(half, across)
            place = moved(place, (-0.52 * width if lean > 0 else 0.52 * width, u if half >= across else n))
        yield Label(*place, joint.label, "")

    def _free(self, number: int) -> float:
        """The direction out of a disc, of eight, that is farthest from all lines at it."""
        place, taken = self.places[number], []
        for other in self.others(number):
            u = direction(place, self.places[other])
            taken.append(degrees(atan2(u[1], u[0])))
        for link in self.mechanism.links:
            if link.ends[1] == number and link.kind in ("beam", "guide"):
                u = direction(self.places[link.ends[0]], place)
                taken += [degrees(atan2(u[1], u[0])) + way for way in (-60, 0, 90)]
        if self.mechanism.joints[number].direction is not None:
            taken += [0, 180, 270]
        for turn in self.mechanism.turns:
            if self.mechanism.links[turn.link].ends[0] == number:
                taken += [turn.start, (turn.start + turn.stop) / 2]
        for u in [each.direction for each in self.mechanism.pushes if each.joint == number]:
            taken += [degrees(atan2(u[1], u[0])), degrees(atan2(-u[1], -u[0]))]
        for each in self.mechanism.distances:
            if each.joint == number and each.link is None:
                u = direction(place, (each.start[0] * UNIT, each.start[1] * UNIT))
                taken.append(degrees(atan2(u[1], u[0])))
        ways = [0, 45, 315, 90, 270, 135, 225, 180]
        return max(ways, key=lambda way: min((abs((way - t + 180) % 360 - 180) for t in taken), default=0) // 10)

    def away(self, number: int) -> Place:
        """Return the direction across a link, away from the arc of its angle."""
        first, second = self.mechanism.links[number].ends
        u = direction(self.places[first], self.places[second])
        turn = self.turns.get(number)
        sign = 1 if turn is None or turn.stop > turn.start else -1
        if turn is None and abs(u[0]) > abs(u[1]):
            sign = 1 if u[0] > 0 else -1  # above
        elif turn is None:
            sign = -1 if u[1] > 0 else 1  # on the right
        return -sign * u[1], sign * u[0]

    def _link(self, number: int, link: Link) -> Iterator[Stroke]:
        """A rod, a spring, a beam or a guide with its label."""
        (p, q), (a, b) = (self.places[end] for end in link.ends), self.edges(link)
        u, side = direction(p, q), self.away(number)
        toward = (-side[0], -side[1])
        if link.kind == "rod":
            yield Line((p, q), "rod")
            yield label_beside(middle(p, q, 0.55), side, link.label, 0.06)
        elif link.kind == "spring":
            yield zigzag(a, b)
            measured = any(each.link == number for each in self.mechanism.distances)
            yield label_beside(middle(a, b, 0.68 if measured else 0.5), toward if measured else side, link.label, 0.2)
        else:
            start, end = moved(p, (-0.5 if link.kind == "beam" else 0.0, u)), moved(q, (1.1, u))
            if link.kind == "guide":
                yield Line((start, end))
                return
            yield Shape(
                tuple(moved(x, (way * BEAM, side)) for x, way in ((start, -1), (end, -1), (end, 1), (start, 1)))
            )
            yield label_beside(end, u, link.label, 0.02)

    def is_rail(self, number: int) -> bool:
        """Return whether something hangs from what moves along a line, so that no ground is below it."""
        _, n, _ = self.axes(number)
        place = self.places[number]
        return any(
            (self.places[other][0] - place[0]) * n[0] + (self.places[other][1] - place[1]) * n[1] < -1e-6
            for other in self.others(number)
        )

    def grounds(self) -> Iterator[Stroke]:
        """Yield the ground below each line that is not upright, as far as bodies move on it; walls beside it."""
        lines: dict[tuple[float, ...], list[int]] = {}
        for i, joint in enumerate(self.mechanism.joints):
            if joint.direction is not None:
                u, n, upright = self.axes(i)
                level = self.places[i][0] * n[0] + self.places[i][1] * n[1]
                if not upright:
                    lines.setdefault((round(u[0], 4), round(u[1], 4), round(level, 3)), []).append(i)
        for members in lines.values():
            yield from self._ground(members)
        for link in self.mechanism.links:
            if self.mechanism.joints[link.ends[0]].shape == "wall":
                yield from self._wall(link)

    def _ground(self, members: list[int]) -> Iterator[Stroke]:
        """The ground of the bodies on one line, from the wall if there is one."""
        u, n, _ = self.axes(members[0])
        depth = max(self.halves(i)[1] for i in members)
        place = self.places[members[0]]
        reach: list[float] = []
        for i in members:
            at = self._along(place, self.places[i], u)
            reach += [at - self.halves(i)[0] - GROUND, at + self.halves(i)[0] + GROUND]
        for each in self.mechanism.distances:
            if each.joint in members:
                reach.append(self._along(place, (each.start[0] * UNIT, each.start[1] * UNIT), u) - 0.2)
        low, high = min(reach), max(reach)
        for link in self.mechanism.links:
            if link.ends[1] in members and self.mechanism.joints[link.ends[0]].shape == "wall":
                at = self._along(place, self.places[link.ends[0]], u)
                low, high = (at, high) if at < 0 else (low, at)
        if any(map(self.is_rail, members)):
            yield Line((moved(place, (low, u)), moved(place, (high, u))))
        else:
            yield from hatched(moved(place, (low, u), (-depth, n)), moved(place, (high, u), (-depth, n)),
                               (-n[0], -n[1]))  # fmt: skip

    @staticmethod
    def _along(origin: Place, place: Place, u: Place) -> float:
        return (place[0] - origin[0]) * u[0] + (place[1] - origin[1]) * u[1]

    def _wall(self, link: Link) -> Iterator[Stroke]:
        """A hatched line across a spring, where it begins."""
        place, end = (self.places[each] for each in link.ends)
        u = direction(place, end)
        n = (-u[1], u[0])
        yield from hatched(moved(place, (-WALL, n)), moved(place, (WALL, n)), (-u[0], -u[1]))
