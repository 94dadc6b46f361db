"""What joins the bodies of a mechanical system, found by exact distances: rods, lengths that change, springs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Lagrangian
    from solver.systems.bodies import Body, Spring

Vector = tuple["Expr", "Expr"]


class Undrawn(Exception):  # noqa: N818 - not an error of the program
    """The rules do not tell how to draw the system."""


@dataclass(frozen=True)
class Jointed:
    """A body, or a point without mass that others are joined to; `line` is the direction that it moves along."""

    position: Vector
    body: Body | None = None
    line: Vector | None = None


@dataclass(frozen=True)
class Linked:
    """A link from one joint to another: its length, and by which angles it turns, each once forward or backward."""

    ends: tuple[int, int]
    length: Expr
    turns: dict[Symbol, int]
    grows: Symbol | None = None
    """The coordinate that the length grows with."""


@dataclass
class Mechanics:
    """The joints, links and springs of a system; raises Undrawn where something has no place."""

    system: Lagrangian
    joints: list[Jointed] = field(default_factory=list)
    links: list[Linked] = field(default_factory=list)
    springs: list[tuple[Spring, tuple[int, int]]] = field(default_factory=list)

    def __post_init__(self) -> None:
        bodies = [body for body in self.system.bodies if body.position]
        onto = sorted(bodies, key=lambda body: self.line_of(body.position) is None)
        for body in onto:
            self.joints.append(Jointed((body.position[0], body.position[1]), body, self.line_of(body.position)))
        for number, joint in enumerate(tuple(self.joints)):
            self._link(number, joint)
        self._check_lines()
        for spring in self.system.springs:
            self.springs.append((spring, self._ends_of(spring)))

    @cached_property
    def moving(self) -> list[Symbol]:
        """The coordinates, and the inputs that move bodies."""
        inside = _symbols(e for b in self.system.bodies for e in (*b.position, *([b.angle] if b.angle else [])))
        moved = [self.system.symbol((name, 0)) for name in self.system.inputs]
        return [*self.system.symbols(), *(u for u in moved if u in inside)]

    @cached_property
    def angles(self) -> set[Any]:
        """Those among them that are angles: arguments of sines and cosines."""
        inside = [f.args[0] for b in self.system.bodies for e in b.position for f in e.atoms(sp.sin, sp.cos)]
        return _symbols(inside) & set(self.moving)

    def line_of(self, position: Sequence[Expr]) -> Vector | None:
        """Return the direction of the line that a position moves along, at one unit a unit; None for none."""
        slopes = [slope for _, slope in self.slopes_of(position)]
        if not slopes or any(not _symbols(slope).isdisjoint(self.moving) for slope in slopes):
            return None
        if any(not exact.is_zero(a[0] * b[1] - a[1] * b[0]) for a, b in pairwise(slopes)):
            return None
        return slopes[0]

    def slopes_of(self, position: Sequence[Expr]) -> Iterator[tuple[Symbol, Vector]]:
        """Yield the functions of time that a position depends on, with its derivatives."""
        for q in self.moving:
            slope = (exact.partial(position[0], q), exact.partial(position[1], q))
            if any(each != 0 for each in slope):
                yield q, slope

    def _link(self, number: int, joint: Jointed) -> None:
        """Join a body to one before it, to the origin, or to what its position is without its angles."""
        turned = not self.angles.isdisjoint(_symbols(joint.position))
        if joint.line is not None:
            return
        before = list(range(number - 1, -1, -1))
        found = self._found(number, ((j, self.joints[j].position) for j in before))
        if found is None and turned:
            zero = (sp.S.Zero, sp.S.Zero)
            centre = tuple(sp.Add(*(term for term in sp.Add.make_args(e) if not self.angles & term.free_symbols))
                           for e in joint.position)  # fmt: skip
            found = self._found(number, ((None, each) for each in dict.fromkeys((zero, centre))))
        if found is not None:
            self.links.append(found)
        elif turned or not any(True for _ in self.slopes_of(joint.position)):
            raise Undrawn

    def _found(self, number: int, candidates: Iterable[tuple[int | None, Any]]) -> Linked | None:
        """The link of a joint to one of the candidates, rods first."""
        listed, end = list(candidates), self.joints[number].position
        for measure in (self._constant, self._growing):
            for place, position in listed:
                d = (end[0] - position[0], end[1] - position[1])
                found = measure(d[0] ** 2 + d[1] ** 2)
                if found is not None:
                    turns = self._turns_of(d, found[0] ** 2)
                    return Linked((self._at(position) if place is None else place, number), found[0], turns, found[1])
        return None

    def _at(self, position: Vector) -> int:
        """The number of the point without mass at a position."""
        for number, joint in enumerate(self.joints):
            if joint.body is None and joint.position == position:
                return number
        line = self.line_of(position)
        if line is None and not _symbols(position).isdisjoint(self.moving):
            raise Undrawn
        self.joints.append(Jointed(position, None, line))
        return len(self.joints) - 1

    def _constant(self, square: Expr) -> tuple[Expr, None] | None:
        """The root of a squared distance that does not change."""
        if any(not exact.is_zero(exact.partial(square, q)) for q in self.moving if square.has(q)):
            return None
        square = exact.normal(square)
        positive = {each: sp.Dummy(str(each), positive=True) for each in square.free_symbols}
        length = sp.sqrt(square.xreplace(positive)).xreplace({new: old for old, new in positive.items()})
        return (length, None) if length != 0 else None

    def _growing(self, square: Expr) -> tuple[Expr, Symbol] | None:
        """A coordinate, maybe with a constant, whose square is a squared distance."""
        for q in self.moving:
            if q in self.angles or not square.has(q):
                continue
            length = exact.normal(exact.partial(square, q) / 2)
            alone = length.diff(q) == 1 and set(self.moving) & length.free_symbols == {q}
            if alone and exact.is_zero(square - length**2):
                return length, q
        return None

    def _turns_of(self, d: Vector, square: Expr) -> dict[Any, int]:
        """How a direction turns with each angle: by as much, or by as much backward."""
        found = {}
        for q in self.moving:
            swept = d[0] * exact.partial(d[1], q) - d[1] * exact.partial(d[0], q)
            if swept == 0 or exact.is_zero(swept):
                continue
            sign = next((s for s in (1, -1) if exact.is_zero(swept - s * square)), None)
            if sign is None or q not in self.angles:
                raise Undrawn
            found[q] = sign
        return found

    def _check_lines(self) -> None:
        """What moves along lines must move independently: otherwise something unseen joins it."""
        rows = [
            [exact.normal(sp.Add(*(s * s for s in dict(self.slopes_of(j.position)).get(q, ())))) for q in self.moving]
            for j in self.joints if j.line is not None
        ]  # fmt: skip
        if rows and sp.Matrix(rows).rank() < len(rows):
            raise Undrawn

    def _ends_of(self, spring: Spring) -> tuple[int, int]:
        """The joints between which a spring lies; a wall is made where it begins at one."""
        on_lines = [(i, joint, joint.line) for i, joint in enumerate(self.joints) if joint.line is not None]
        for i, joint, line in on_lines:
            for sign in (1, -1):
                start = [p - sign * spring.length * u for p, u in zip(joint.position, line, strict=True)]
                if self._at_rest(start):
                    return self._at((exact.normal(start[0]), exact.normal(start[1]))), i
            for j, other, _ in on_lines[:i]:
                gap = [p - p0 for p, p0 in zip(joint.position, other.position, strict=True)]
                along = gap[0] * line[0] + gap[1] * line[1]
                if any(self._at_rest([along - sign * spring.length]) for sign in (1, -1)):
                    return j, i
        for link in self.links:
            if link.grows is not None and self._at_rest([spring.length - link.length]):
                return link.ends
        raise Undrawn

    def _at_rest(self, expressions: Iterable[Expr]) -> bool:
        return all(exact.is_zero(exact.partial(e, q)) for e in expressions for q in self.moving if e.has(q))


def _symbols(expressions: Iterable[Expr]) -> set[Any]:
    return set().union(*(each.free_symbols for each in expressions))
