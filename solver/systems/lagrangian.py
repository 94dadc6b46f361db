"""A mechanical system by its energies: T and V as given, or of bodies and springs, forces, dissipation, constraints."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from solver.jets import Jet, jet_symbol
from solver.lazy import sympy as sp
from solver.systems.bodies import Body, Spring
from solver.systems.equations import check_outputs
from solver.systems.kind import Key, Keyed, Kind, ListOf, MappingTo, Reader, Value, Values

if TYPE_CHECKING:
    from sympy import Expr, Symbol


@dataclass(frozen=True)
class Lagrangian:
    """Energies in the `coordinates`, their velocities and, where they are moved, the `inputs`.

    `kinetic` and `potential` are those given as expressions, beside which bodies and springs add theirs; `dissipation`
    is Rayleigh's function, `forces` are the generalized ones by coordinate, `constraints` are zero. `states`, `outputs`
    and `initial` are those of its equations; `jets` has every derivative that occurs by its symbol; what is
    `assumed` of functions holds of its equations.
    """

    coordinates: tuple[str, ...]
    kinetic: Expr | None = None
    potential: Expr | None = None
    bodies: tuple[Body, ...] = ()
    gravity: Expr | None = None
    springs: tuple[Spring, ...] = ()
    dissipation: Expr | None = None
    forces: Mapping[str, Expr] = field(default_factory=dict)
    constraints: tuple[Expr, ...] = ()
    inputs: tuple[str, ...] = ()
    outputs: tuple[Expr, ...] = ()
    states: tuple[Jet, ...] = ()
    initial: Mapping[Jet, Expr] = field(default_factory=dict)
    jets: Mapping[Symbol, Jet] = field(default_factory=dict)
    discrete: bool = False
    sample_time: Expr | None = None
    assumed: Mapping[str, Symbol] = field(default_factory=dict)

    @property
    def kind(self) -> str:
        """The name of the kind that words it."""
        return "lagrangian"

    @cached_property
    def expressions(self) -> tuple[Expr, ...]:
        """Everything that is given."""
        of_bodies = [each for b in self.bodies for each in (b.mass, *b.position, b.inertia, b.angle)]
        of_springs = [each for s in self.springs for each in (s.stiffness, s.length, s.rest)]
        given = (self.kinetic, self.potential, *of_bodies, self.gravity, *of_springs, self.dissipation,
                 *self.forces.values(), *self.constraints, *self.outputs)  # fmt: skip
        return tuple(each for each in given if each is not None)

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The free symbols but the functions of time and their derivatives, sorted by name."""
        found: set[Any] = set().union(*(each.free_symbols for each in self.expressions)) - set(self.jets)
        return tuple(sorted(found, key=str))

    @property
    def provides(self) -> frozenset[str]:
        """The energies; "inputs" and "initial_state" tell what its equations will have."""
        return frozenset(
            {"lagrangian", *(["inputs"] if self.inputs else []), *(["initial_state"] if self.initial else [])}
        )

    @property
    def described(self) -> str:
        """What it is given by, in words."""
        return "the system is given by its energies" + ("" if self.inputs else ", without inputs")

    @cached_property
    def is_linear(self) -> bool:
        """Whether its equations are linear, as far as the file shows it: energies are sums of squares and products."""
        of_springs = [s.stiffness * (s.length - s.rest) ** 2 / 2 for s in self.springs]
        heights = [
            b.mass * self.gravity * b.position[1] for b in self.bodies if b.position and self.gravity is not None
        ]
        energies = [
            self.kinetic or sp.S.Zero,
            self.dissipation or sp.S.Zero,
            sp.Add(self.potential or 0, *of_springs, *heights),
        ]
        paths = [each for b in self.bodies for each in (*b.position, *([] if b.angle is None else [b.angle]))]
        linear = [*self.forces.values(), *self.constraints, *self.outputs]
        masses = [each for b in self.bodies for each in (b.mass, b.inertia) if each is not None]
        kinds = ((energies, {0, 2}), (paths, {0, 1}), (linear, {1}), (masses, {0}))
        return all(self._degrees(each) <= allowed for listed, allowed in kinds for each in listed)

    def _degrees(self, expression: Expr) -> set[int]:
        """The degrees of the terms in the functions of time; -1 where it is no polynomial."""
        if not expression.is_polynomial(*self.jets):
            return {-1}
        poly = sp.Poly(expression, *self.jets)
        return {sum(powers) for powers in poly.monoms()} if not poly.is_zero else set()

    @cached_property
    def multipliers(self) -> tuple[str, ...]:
        """The names of the multipliers of the constraints."""
        return tuple(f"lambda{i}" for i in range(1, len(self.constraints) + 1))

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions of time: coordinates, multipliers and inputs."""
        return (*self.coordinates, *self.multipliers, *self.inputs)

    def symbol(self, jet: Jet) -> Symbol:
        """Return the symbol of a function of time, or of its derivative."""
        return jet_symbol(jet)

    def symbols(self, order: int = 0) -> list[Symbol]:
        """Return the symbols of the coordinates, or of their derivatives."""
        return [jet_symbol((name, order)) for name in self.coordinates]

    def size(self, of: str) -> int | None:
        """Return the number of inputs "m" and outputs "p"; that of states, where they are named."""
        return {"n": len(self.states) or None, "m": len(self.inputs), "p": len(self.outputs)}[of]

    def names(self, of: str) -> tuple[str, ...]:
        """Return the names of the "input"s."""
        return self.inputs if of == "input" else ()


def _read(reader: Reader) -> Lagrangian:
    """Return the system; what is beside the energies is as it is beside equations."""
    if reader.discrete:
        reader.complain("time", "energies are those of a system in continuous time")
    inner, inputs = reader.within("lagrangian"), reader.names("inputs")
    coordinates = inner.names("coordinates")
    for name in set(coordinates) & set(inputs):
        reader.complain("inputs", f"'{name}' is a coordinate already", item=inputs.index(name))
    energies = _Energies(inner, coordinates, inputs)
    found = energies.read()
    outputs, of_outputs = reader.formulas("outputs", energies.functions)
    initial, states = reader.initial("initial", energies.functions), reader.jets("states")
    for i, (name, order) in enumerate(states):
        if name not in coordinates or order > 1:
            like = coordinates if name not in coordinates else ()
            reader.complain("states", "states are the coordinates and their velocities", item=i, like=like)
    check_outputs(reader, outputs, of_outputs, energies.functions)
    assumed = reader.assumed(energies.functions)
    reader.conclude()
    first = jet_symbol((coordinates[0], 0))
    usual = {jet_symbol((name, k)): (name, k) for name in coordinates for k in (0, 1)}
    jets = {**usual, **energies.jets, **of_outputs}
    return Lagrangian(
        coordinates, inputs=inputs, outputs=outputs or (first,), states=states, initial=initial, jets=jets,
        assumed=assumed, **found,
    )  # fmt: skip


class _Energies:
    """Reads what stands under `lagrangian`, and keeps the derivatives that occur."""

    def __init__(self, reader: Reader, coordinates: tuple[str, ...], inputs: tuple[str, ...]) -> None:
        self.reader = reader
        self.coordinates = coordinates
        self.inputs = inputs
        self.functions = (*coordinates, *inputs)
        self.jets: dict[Any, Jet] = {}

    def read(self) -> dict[str, Any]:
        """Return the values by the names of the object's fields."""
        reader = self.reader
        if not (reader.gives("kinetic") or reader.gives("bodies")):
            reader.complain("coordinates", "a kinetic energy is missing: give 'kinetic' or 'bodies'", at_key=True)
        if reader.gives("gravity") and not reader.gives("bodies"):
            reader.complain("gravity", "gravity acts on 'bodies'; there are none", at_key=True)
        found: dict[str, Any] = {
            "kinetic": self._formula(reader, "kinetic", velocities=True),
            "potential": self._formula(reader, "potential"),
            "gravity": self._formula(reader, "gravity"),
            "dissipation": self._formula(reader, "dissipation", velocities=True),
            "bodies": tuple(self._body(each) for each in reader.each("bodies")),
            "springs": tuple(filter(None, (self._spring(each) for each in reader.each("springs")))),
            "forces": self._forces(reader.within("forces")),
            "constraints": self._formulas(reader, "constraints"),
        }
        self._check_names(found)
        return found

    def _formulas(self, reader: Reader, key: str, *, velocities: bool = False) -> tuple[Expr, ...]:
        """The expressions under a key; an equation stands for the difference of its sides."""
        sides, jets = reader.relations(key, self.functions)
        for i, pair in enumerate(sides):
            high = [jet for symbol, jet in jets.items() if any(side.has(symbol) for side in pair)]
            if any(order > velocities and name in self.coordinates for name, order in high):
                wanted = "coordinates and velocities" if velocities else "coordinates only"
                reader.complain(key, f"this is to be given in {wanted}", item=i)
        self.jets |= jets
        return tuple(left - right for left, right in sides)

    def _formula(self, reader: Reader, key: str, *, velocities: bool = False) -> Expr | None:
        return next(iter(self._formulas(reader, key, velocities=velocities)), None)

    def _body(self, reader: Reader) -> Body:
        for key, other in (("mass", "position"), ("position", "mass"), ("inertia", "angle"), ("angle", "inertia")):
            if reader.gives(key) and not reader.gives(other):
                reader.complain(key, f"'{key}' needs '{other}' beside it", at_key=True)
        position = self._formulas(reader, "position")
        if reader.gives("position") and len(position) != 2:
            reader.complain("position", 'a position is two expressions, as ["l sin(theta)", "-l cos(theta)"]')
        mass, inertia, angle = (self._formula(reader, key) for key in ("mass", "inertia", "angle"))
        return Body(mass, position, inertia, angle)

    def _spring(self, reader: Reader) -> Spring | None:
        stiffness, length, rest = (self._formula(reader, key) for key in ("stiffness", "length", "rest"))
        if stiffness is None or length is None:
            return None
        return Spring(stiffness, length, sp.S.Zero if rest is None else rest)

    def _forces(self, reader: Reader) -> dict[str, Expr]:
        """The generalized forces, each on a coordinate."""
        found = {}
        for key, name in reader.keys.items():
            force = self._formula(reader, key, velocities=True)
            if name not in self.coordinates:
                reader.complain(key, f"'{key}' is no coordinate", at_key=True, like=self.coordinates)
            elif force is not None:
                found[name] = force
        return found

    def _check_names(self, found: Mapping[str, Any]) -> None:
        """Each coordinate must occur; multipliers must not be named in the file."""
        inside = {name for name, _ in self.jets.values()}
        for i, name in enumerate(self.coordinates):
            if name not in inside:
                self.reader.complain("coordinates", f"'{name}' occurs nowhere", item=i, like=sorted(inside - {name}))
        named = {*self.functions, *(str(symbol) for each in _expressions(found) for symbol in each.free_symbols)}
        for i in range(1, len(found["constraints"]) + 1):
            if {f"lambda{i}", f"lamda{i}"} & named:
                message = f"'lambda{i}' is the multiplier of a constraint: call what it stands for by another name"
                self.reader.complain("constraints", message, at_key=True)


def _expressions(found: Mapping[str, Any]) -> tuple[Expr, ...]:
    return Lagrangian((), **found).expressions


_BODIES = Keyed("bodies", (
    Key("mass", Value(), "its mass"),
    Key("position", Values(), 'the position of its centre, as ["x + l sin(theta)", "l cos(theta)"]; y is upward'),
    Key("inertia", Value(), "its moment of inertia about the centre"),
    Key("angle", Value(), "the angle by which it is turned"),
))  # fmt: skip
_SPRINGS = Keyed("springs", (
    Key("stiffness", Value(), "force by elongation", required=True),
    Key("length", Value(), "the length, or the elongation where there is no rest", required=True),
    Key("rest", Value(), "the length at rest; 0 if absent"),
))  # fmt: skip
_ENERGIES = Keyed("lagrangian", (
    Key("coordinates", Values(), "the generalized coordinates", required=True),
    Key("kinetic", Value(), "the kinetic energy, in the coordinates and velocities x'"),
    Key("potential", Value(), "the potential energy"),
    Key("bodies", ListOf(_BODIES), "bodies that have kinetic energy, and weight where there is gravity"),
    Key("gravity", Value(), "the acceleration of gravity, along -y"),
    Key("springs", ListOf(_SPRINGS), "springs"),
    Key("dissipation", Value(), "Rayleigh's function, as d x'^2/2"),
    Key("forces", MappingTo(Value()), "generalized forces by coordinate, as {x: u}"),
    Key("constraints", Values(), "expressions in the coordinates that are zero"),
))  # fmt: skip

LAGRANGIAN = Kind(
    "lagrangian",
    doc="A mechanical system by its energies, for the equations of Euler and Lagrange.",
    keys=(
        Key("lagrangian", _ENERGIES, "coordinates, energies or bodies, forces", required=True),
        Key("inputs", Values(), "names of the inputs"),
        Key("outputs", Values(), "expressions; the first coordinate if absent"),
        Key("states", Values(), "the states in their order, as [x, x']"),
        Key("initial", MappingTo(Value()), 'initial values, as {x: 0, "x\'": 1}'),
    ),
    read=_read,
    example=(
        (
            'lagrangian: {coordinates: [theta], bodies: [{mass: m, position: ["l sin(theta)", "-l cos(theta)"]}], '
            "gravity: g, forces: {theta: tau}}",
            "y is upward; or kinetic and potential",
        ),
        ("inputs: [tau]", "every other name is a parameter"),
    ),
)
