"""Nodal analysis of a circuit with impedances: the node voltages, and the outputs, as transforms, from rest.

Currents through voltage sources and amplifiers' outputs are unknowns beside the node voltages. Nothing is cancelled
against the characteristic polynomial χ, the determinant of the equations, whose roots are the natural frequencies.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.modelling.circuits import Law
from solver.exact.modelling.turns import Solved, solved_in_turn
from solver.systems.circuit import Circuit, current, symbol_of, voltage
from solver.systems.networks import GROUND, VOLTAGES, Element


@dataclass(frozen=True)
class NodalModel:
    """The equations by their origin, how they were solved, the outputs, and what they say of each input.

    `impedances` are those of the elements that have one; `matrix` is G in lowest terms, `numerators` stand over `chi`.
    """

    circuit: Circuit
    variable: sp.Symbol
    impedances: tuple[tuple[Element, sp.Expr], ...]
    sources: tuple[Law, ...]
    shorts: tuple[Law, ...]
    currents: tuple[Law, ...]
    outputs: tuple[Law, ...]
    solved: Solved
    found: tuple[sp.Expr, ...]
    matrix: sp.ImmutableMatrix
    numerators: tuple[tuple[sp.Expr, ...], ...]
    chi: sp.Expr

    @property
    def equations(self) -> tuple[Law, ...]:
        """All of them, in the order of solving."""
        return (*self.sources, *self.shorts, *self.currents, *self.outputs)

    @property
    def needed(self) -> tuple[Law, ...]:
        """Those that lead to the outputs."""
        return tuple(law for i, law in enumerate(self.equations) if i in self.solved.used)


def nodal_model(circuit: Circuit, s: sp.Symbol) -> NodalModel | None:
    """Return the nodal equations in s and what they say of the outputs; None where they determine no voltages."""
    network = _Network(circuit, s)
    sources, shorts, currents = tuple(network.sources()), tuple(network.shorts()), tuple(network.currents())
    outputs = tuple(network.outputs())
    laws = (*sources, *shorts, *currents, *outputs)
    inputs = [symbol_of(name) for name in circuit.inputs]
    unknown = [*network.unknown, *(law.left for law in outputs)]
    wanted = sorted({x for y in circuit.outputs for x in y.free_symbols} & set(unknown), key=str)
    chi = network.characteristic([*sources, *shorts, *currents])
    solved = solved_in_turn([(law.left, law.right) for law in laws], inputs, unknown, wanted)
    if chi is None or solved.lacking:
        return None
    values = dict(solved.values)
    entries = [[sp.cancel(sp.diff(y.xreplace(values), u)) for u in inputs] for y in circuit.outputs]
    found = tuple(sp.Add(*(entry * u for entry, u in zip(row, inputs, strict=True))) for row in entries)
    numerators = tuple(tuple(sp.cancel(entry * chi) for entry in row) for row in entries)
    matrix = sp.ImmutableMatrix(len(found), len(inputs), [entry for row in entries for entry in row])
    impedances = tuple((each, Z) for each in circuit.elements if (Z := network.impedance(each)) is not None)
    return NodalModel(
        circuit, s, impedances, sources, shorts, currents, outputs, solved, found, matrix, numerators, chi
    )


class _Network:
    """The equations of one circuit."""

    def __init__(self, circuit: Circuit, s: sp.Symbol) -> None:
        self.circuit, self.s = circuit, s
        self.elements = {each.name: each for each in circuit.elements}
        own = [current(each) for each in circuit.elements if each.letter in VOLTAGES]
        nodes = [self.node(node) for node in circuit.nodes if node != GROUND]
        self.unknown = [x for x in (*nodes, *own) if str(x) not in circuit.inputs]

    def node(self, node: str) -> sp.Expr:
        """The voltage of a node."""
        return sp.S.Zero if node == GROUND else symbol_of(f"v_{node}")

    def across(self, first: str, second: str) -> sp.Expr:
        """The voltage between two nodes."""
        return self.node(first) - self.node(second)

    def impedance(self, element: Element) -> sp.Expr | None:
        """R, s L or 1/(s C)."""
        of = {"R": lambda x: x, "L": lambda x: self.s * x, "C": lambda x: 1 / (self.s * x)}
        return of[element.letter](element.value) if element.letter in of else None

    def through(self, element: Element) -> sp.Expr:
        """The current of an element."""
        if element.letter in VOLTAGES:
            return current(element)
        if (Z := self.impedance(element)) is not None:
            return self.across(*element.nodes) / Z
        return self.given(element)

    def given(self, element: Element) -> sp.Expr:
        """What a source sets: its voltage, or its current."""
        if element.letter in "EG":
            return element.value * self.across(*element.controls)
        if element.letter in "FH":
            return element.value * self.through(self.elements[element.controls[0]])
        assert element.given is not None  # noqa: S101 - of a source
        return element.given

    def sources(self) -> Iterator[Law]:
        """The voltages that sources set."""
        for each in self.circuit.elements:
            if each.letter in "VEH" and self.across(*each.nodes) != self.given(each):
                yield Law(each.name, self.across(*each.nodes), self.given(each))

    def shorts(self) -> Iterator[Law]:
        """The virtual shorts."""
        for each in self.circuit.elements:
            if each.letter == "O":
                plus, minus = each.controls
                yield Law(each.name, self.node(plus), self.node(minus))

    def currents(self) -> Iterator[Law]:
        """The current law of each node but the ground: what flows away from it."""
        for node in self.circuit.nodes:
            terms = [
                sign * self.through(each)
                for each in self.circuit.elements
                for end, sign in zip(each.nodes, (1, -1), strict=True)
                if end == node
            ]
            if node != GROUND:
                yield Law(node, sp.Add(*terms), sp.S.Zero)

    def outputs(self) -> Iterator[Law]:
        """Voltages and currents of elements that the outputs ask for."""
        seen = {x for output in self.circuit.outputs for x in output.free_symbols}
        for each in self.circuit.elements:
            for symbol, value in ((voltage(each), self.across(*each.nodes)), (current(each), self.through(each))):
                if symbol in seen and symbol not in self.unknown and symbol != value:
                    yield Law(each.name, symbol, value)

    def characteristic(self, laws: Sequence[Law]) -> sp.Expr | None:
        """The determinant of the equations, freed of its denominators and monic; None where it is zero."""
        s = self.s
        rows = [[sp.together(sp.diff(law.left - law.right, x)) for x in self.unknown] for law in laws]
        if len(rows) != len(self.unknown):
            return None
        inductors = [each for each in self.circuit.elements if each.letter == "L"]
        determinant = _determinant(rows) * s ** len(inductors)
        above, below = sp.fraction(sp.cancel(determinant))
        if above == 0 or below.has(s):
            return None
        monic: sp.Expr = sp.Poly(above, s).monic().as_expr()
        return monic


def _determinant(rows: Sequence[Sequence[sp.Expr]]) -> sp.Expr:
    """The determinant over the field of the entries."""
    M = DomainMatrix.from_Matrix(sp.Matrix(rows), extension=True).to_field()
    found: sp.Expr = M.domain.to_sympy(M.det())
    return found
