"""The drawing of a mechanical system, from the positions of its bodies at sample values of what they depend on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import atan2, degrees, radians
from typing import TYPE_CHECKING, Any

from solver.derivation.mechanisms import Distance, Joint, Link, Mechanism, Push, Turn
from solver.lazy import sympy as sp
from solver.tasks.modelling.mechanism_links import Mechanics, Undrawn
from solver.words import formula

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.derivation.mechanisms import Place
    from solver.systems import Lagrangian

ANGLES = (30.0, 52.0, 25.0, 60.0)
SLOPE = 20.0
"""Sample angles of coordinates, one after the other, and that of a parameter; degrees."""
LENGTHS = (1.0, 2.2, 3.4, 4.6)
GROWN = 1.25
"""Sample positions one after the other, and the length of what changes its length, in the longest rods."""
PARAMETERS = ((1.0,), (1.0, 1.3, 0.8, 1.15), (3.0,))
"""Sample values of parameters, in turns; the first that can be drawn decently are taken."""
MOST = 6
"""Systems with more bodies are not drawn."""
NEAR = 1e-9


def mechanism_of(system: Lagrangian) -> tuple[Mechanism, ...]:
    """Return the drawing; nothing where the rules do not tell how, or things would meet."""
    from solver.figures.mechanism_layout import is_decent  # noqa: PLC0415 - it is asked only whether there is a layout

    if not 0 < len(system.bodies) <= MOST or system.constraints or system.kinetic is not None:
        return ()
    if system.potential is not None:
        return ()
    try:
        mechanics = Mechanics(system)
        for values in PARAMETERS:
            drawing = _Sample(mechanics, values).drawing()
            if is_decent(drawing):
                return (drawing,)
    except Undrawn:
        pass
    return ()


@dataclass
class _Sample:
    """A system at sample values."""

    mechanics: Mechanics
    parameters: tuple[float, ...]

    @cached_property
    def fixed(self) -> dict[Any, float]:
        """The values of the parameters."""
        mechanics = self.mechanics
        inside = {
            each for b in mechanics.system.bodies for e in b.position for f in e.atoms(sp.sin, sp.cos)
            for each in f.args[0].free_symbols
        }  # fmt: skip
        values = self.parameters
        return {
            each: radians(SLOPE) if each in inside else values[i % len(values)]
            for i, each in enumerate(mechanics.system.parameters)
        }

    @cached_property
    def unit(self) -> float:
        """The longest rod."""
        rods = [self._number(link.length, self.fixed) for link in self.mechanics.links if link.grows is None]
        return max(map(abs, rods), default=1.0)

    @cached_property
    def values(self) -> dict[Any, float]:
        """The values of parameters and coordinates."""
        found = dict(self.fixed)
        mechanics = self.mechanics
        grown = {link.grows for link in mechanics.links}
        angles = [q for q in mechanics.moving if q in mechanics.angles]
        lengths = [q for q in mechanics.moving if q not in mechanics.angles and q not in grown]
        found |= {q: radians(ANGLES[i % len(ANGLES)]) for i, q in enumerate(angles)}
        found |= {q: self.unit * LENGTHS[i % len(LENGTHS)] for i, q in enumerate(lengths)}
        return found | {q: self.unit * GROWN for q in grown if q is not None}

    def _number(self, expression: Expr, values: dict[Any, float]) -> float:
        number = expression.xreplace({each: sp.Float(value) for each, value in values.items()})
        if not number.is_real or number.free_symbols:
            raise Undrawn
        return float(number)

    def _place(self, vector: Any) -> Place:
        """A position in units."""
        x, y = (round(self._number(each, self.values) / self.unit, 6) + 0.0 for each in vector)
        return x, y

    def _direction(self, vector: Any) -> Place:
        x, y = (round(self._number(each, self.values), 6) + 0.0 for each in vector)
        if abs(x * x + y * y - 1) > 1e-4:
            raise Undrawn
        return x, y

    @cached_property
    def places(self) -> list[Place]:
        """Where the joints are."""
        return [self._place(joint.position) for joint in self.mechanics.joints]

    def drawing(self) -> Mechanism:
        """Return everything that is drawn; raises Undrawn where a coordinate or an inertia has no place."""
        distances = list(self._distances())
        turns = list(self._turns())
        shown = {q for q, _ in (*distances, *turns)}
        if any(q not in shown for q in self.mechanics.moving):
            raise Undrawn
        gravity = self.mechanics.system.gravity
        return Mechanism(
            "The system", tuple(self._joints()), tuple(self._links()), tuple(each for _, each in distances),
            tuple(each for _, each in turns), tuple(self._pushes()), "" if gravity is None else formula(gravity),
        )  # fmt: skip

    def _joints(self) -> Iterator[Joint]:
        walls = {spring_ends[0] for _, spring_ends in self.mechanics.springs
                 if self.mechanics.joints[spring_ends[1]].line is not None}  # fmt: skip
        for number, joint in enumerate(self.mechanics.joints):
            direction = None if joint.line is None else self._direction(joint.line)
            label = ""
            if joint.body is None:
                shape = "wall" if number in walls else "support" if joint.line is None else "pivot"
            else:
                turns = joint.body.angle is not None and self._is_moving(joint.body.angle)
                shape = "disc" if joint.line is None or turns else "box"
                label = formula(joint.body.mass) + (rf",\;{formula(joint.body.inertia)}" if turns else "")
            yield Joint(shape, self.places[number], label, direction)

    def _is_moving(self, expression: Expr) -> bool:
        return not expression.free_symbols.isdisjoint(self.mechanics.moving)

    def _links(self) -> Iterator[Link]:
        """Rods with their lengths, springs with their stiffnesses, beams with their inertias."""
        springs = {ends: spring for spring, ends in self.mechanics.springs}
        inertias = self._inertias()
        for number, link in enumerate(self.mechanics.links):
            inertia = inertias.get(number)
            if link.ends in springs and inertia is None:
                yield Link("spring", link.ends, formula(springs.pop(link.ends).stiffness))
            elif link.ends in springs or (link.grows is None and inertia is not None and link.length.is_Number):
                raise Undrawn
            elif link.grows is not None:
                yield Link("guide" if inertia is None else "beam", link.ends, inertia or "")
            else:
                length = "" if sp.count_ops(link.length) > 2 else formula(link.length)
                yield Link("rod", link.ends, rf"{length},\;{inertia}" if inertia else length)
        for ends, spring in springs.items():
            yield Link("spring", ends, formula(spring.stiffness))

    def _inertias(self) -> dict[int, str]:
        """The inertias of bodies that have no position, by the link that they turn with."""
        found = {}
        for body in self.mechanics.system.bodies:
            if body.position or body.angle is None:
                continue
            turned = {q: sp.diff(body.angle, q) for q in self.mechanics.moving if body.angle.has(q)}
            number = next((i for i, link in enumerate(self.mechanics.links) if turned and link.turns == turned), None)
            if number is None or number in found:
                raise Undrawn
            found[number] = formula(body.inertia)
        return found

    def _distances(self) -> Iterator[tuple[Symbol, Distance]]:
        """The coordinates that are lengths, each where the first joint moves by as much."""
        mechanics = self.mechanics
        for q in mechanics.moving:
            if q in mechanics.angles:
                continue
            grown = next(((i, link) for i, link in enumerate(mechanics.links) if link.grows == q), None)
            number = grown[1].ends[1] if grown else self._owner(q)
            slope = dict(mechanics.slopes_of(mechanics.joints[number].position))[q]
            direction, (x, y) = self._direction(slope), self.places[number]
            size = self.values[q] / self.unit
            start = (round(x - size * direction[0], 6) + 0.0, round(y - size * direction[1], 6) + 0.0)
            yield q, Distance(formula(q), start, number, grown[0] if grown else None)

    def _owner(self, q: Symbol) -> int:
        """The first joint that moves with a coordinate, and with nothing that turns."""
        for number, joint in enumerate(self.mechanics.joints):
            slopes = dict(self.mechanics.slopes_of(joint.position))
            if q in slopes and not any(self._is_moving(e) for slope in slopes.values() for e in slope):
                return number
        raise Undrawn

    def _turns(self) -> Iterator[tuple[Symbol, Turn]]:
        """The angles, each at the first link that turns with it and no other that is not shown yet."""
        shown: set[Symbol] = set()
        turned: dict[int, dict[Any, int]] = {}
        for number, link in enumerate(self.mechanics.links):
            new = [q for q in link.turns if q not in shown]
            if len(new) > 1 or (not new and turned.get(link.ends[0], {}) != link.turns):
                raise Undrawn
            turned[link.ends[1]] = link.turns
            for q in new:
                shown.add(q)
                (x0, y0), (x1, y1) = (self.places[end] for end in link.ends)
                stop = degrees(atan2(y1 - y0, x1 - x0))
                start = stop - link.turns[q] * degrees(self.values[q])
                if len(link.turns) == 1 and abs(start / 90 - round(start / 90)) > 1e-4:
                    raise Undrawn
                yield q, Turn(formula(q), number, round(start, 3) + 0.0, round(stop, 3) + 0.0)

    def _pushes(self) -> Iterator[Push]:
        """The forces on coordinates that are lengths, without what depends on velocities."""
        system, mechanics = self.mechanics.system, self.mechanics
        owners = {q: each.joint for q, each in self._distances()}
        rest = dict.fromkeys(system.symbols(1), sp.S.Zero)
        for name, force in system.forces.items():
            q, pushed = system.symbol((name, 0)), force.xreplace(rest)
            if q in owners and pushed != 0:
                slope = dict(mechanics.slopes_of(mechanics.joints[owners[q]].position))[q]
                yield Push(formula(pushed), owners[q], self._direction(slope))
