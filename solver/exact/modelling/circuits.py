"""The equations of a circuit by Kirchhoff's laws along a normal tree, and what they say of its states and outputs.

The voltage of a link is the sum along its loop, the current of a branch of the tree the sum over its cut; elements add
their laws, ideal operational amplifiers that their inputs have one voltage and take no current.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from solver.exact.modelling.turns import Solved, solved_in_turn
from solver.jets import jet_symbol
from solver.systems.circuit import Circuit, current, symbol_of, voltage
from solver.systems.networks import GROUND, Element, Way

Side = tuple[sp.Expr, sp.Expr]


@dataclass(frozen=True)
class Law:
    """An equation with what it comes from: the name of an element or a node."""

    of: str
    left: sp.Expr
    right: sp.Expr

    @property
    def sides(self) -> Side:
        """Both sides."""
        return self.left, self.right


@dataclass(frozen=True)
class Rate:
    """factor · x' = `by` = `value`: of an inductor L i' = v, of a capacitor C v' = i; value in states and inputs."""

    state: sp.Symbol
    derivative: sp.Symbol
    factor: sp.Expr
    by: sp.Symbol
    value: sp.Expr


@dataclass(frozen=True)
class CircuitModel:
    """The equations of a circuit by their origin, how they were solved, and the state equations and outputs."""

    circuit: Circuit
    laws: tuple[Law, ...]
    shorts: tuple[Law, ...]
    loops: tuple[Law, ...]
    cuts: tuple[Law, ...]
    nodes: tuple[Law, ...]
    solved: Solved

    @property
    def equations(self) -> tuple[Law, ...]:
        """All of them, in the order of solving."""
        return (*self.shorts, *self.laws, *self.loops, *self.cuts, *self.nodes)

    @property
    def needed(self) -> tuple[Law, ...]:
        """Those that lead to the state equations and the outputs."""
        used = self.solved.used
        return tuple(law for i, law in enumerate(self.equations) if i in used)

    @cached_property
    def rates(self) -> tuple[Rate, ...]:
        """The state equations, in the order of the states."""
        elements = {state_of(each): each for each in self.circuit.elements if each.letter in "LC"}
        return tuple(self._rate(name, elements[name]) for name in self.circuit.states)

    def _rate(self, name: str, element: Element) -> Rate:
        by = voltage(element) if element.letter == "L" else current(element)
        assert element.value is not None  # noqa: S101 - of an inductor or a capacitor
        value = self.solved.values.get(by, by)
        return Rate(symbol_of(name), jet_symbol((name, 1)), element.value, by, value)

    @cached_property
    def outputs(self) -> tuple[sp.Expr, ...]:
        """The outputs in states and inputs."""
        values = self.solved.values
        return tuple(sp.expand(output.xreplace(values)) for output in self.circuit.outputs)


def state_of(element: Element) -> str:
    """Return the name of the state that an inductor or a capacitor has."""
    return f"{'i' if element.letter == 'L' else 'v'}_{element.name}"


def sum_along(way: Way, of: Callable[[Element], sp.Symbol] = voltage) -> sp.Expr:
    """Return the sum of the voltages along a way."""
    return sp.Add(*(sign * of(element) for element, sign in way))


def circuit_model(circuit: Circuit) -> CircuitModel:
    """Return the equations of a circuit without loops of capacitors or cuts of inductors, solved for what is asked."""
    groups = (
        tuple(_laws(circuit)), tuple(_shorts(circuit)), tuple(_loops(circuit)), tuple(_cuts(circuit)),
        tuple(_nodes(circuit)),
    )  # fmt: skip
    laws, shorts, loops, cuts, nodes = groups
    sides = [law.sides for law in (*shorts, *laws, *loops, *cuts, *nodes)]
    known = [symbol_of(name) for name in (*circuit.states, *circuit.inputs)]
    wanted = [*(_rate_of(each) for each in circuit.elements if each.letter in "LC"), *_seen(circuit)]
    solved = solved_in_turn(sides, known, _unknown(circuit, known, nodes), wanted)
    return CircuitModel(circuit, laws, shorts, loops, cuts, nodes, solved)


def _rate_of(element: Element) -> sp.Symbol:
    return voltage(element) if element.letter == "L" else current(element)


def _unknown(circuit: Circuit, known: Sequence[sp.Symbol], nodes: Iterable[Law]) -> list[sp.Symbol]:
    """Voltages and currents that are no states: of the branches of the tree first."""
    elements = (*circuit.tree.branches, *circuit.tree.links)
    every = [*(f(each) for f in (voltage, current) for each in elements), *(symbol_of(f"v_{law.of}") for law in nodes)]
    return [symbol for symbol in dict.fromkeys(every) if symbol not in known]


def _seen(circuit: Circuit) -> list[sp.Symbol]:
    """The symbols of the outputs."""
    inside: set[Any] = {symbol for output in circuit.outputs for symbol in output.free_symbols}
    return sorted(inside, key=str)


def _between(circuit: Circuit, first: str, second: str) -> sp.Expr:
    """The voltage between two nodes, by the voltages of the tree."""
    return sum_along(circuit.tree.forest.way(first, second) or ())


def _laws(circuit: Circuit) -> Iterator[Law]:
    """The law of each element that sets its voltage or its current by others; those with a state come last."""
    elements = {each.name: each for each in circuit.elements}
    for each in circuit.elements:
        v, i, value = voltage(each), current(each), each.value if each.given is None else each.given
        if value is None:  # an operational amplifier
            continue
        if each.letter in "VI":
            yield Law(each.name, v if each.letter == "V" else i, value)
        elif each.letter == "R":
            yield Law(each.name, v, value * i)
        elif each.letter in "EG":
            yield Law(each.name, v if each.letter == "E" else i, value * _between(circuit, *each.controls))
        elif each.letter in "FH":
            yield Law(each.name, v if each.letter == "H" else i, value * current(elements[each.controls[0]]))


def _shorts(circuit: Circuit) -> Iterator[Law]:
    """That the inputs of an ideal operational amplifier have one voltage."""
    for each in circuit.elements:
        if each.letter == "O":
            plus, minus = (_between(circuit, node, GROUND) for node in each.controls)
            yield Law(each.name, plus, minus)


def _loops(circuit: Circuit) -> Iterator[Law]:
    """The voltage law of the loop that each link closes."""
    for link in circuit.tree.links:
        yield Law(link.name, voltage(link), sum_along(circuit.tree.loop(link)))


def _cuts(circuit: Circuit) -> Iterator[Law]:
    """The current law of the cut through each branch of the tree."""
    for branch in circuit.tree.branches:
        yield Law(branch.name, current(branch), sum_along(circuit.tree.cut(branch), current))


def _nodes(circuit: Circuit) -> Iterator[Law]:
    """The voltages of the nodes that the outputs ask for."""
    own = {voltage(each) for each in circuit.elements} | {symbol_of(name) for name in circuit.inputs}
    for node in circuit.nodes:
        symbol = symbol_of(f"v_{node}")
        if node != GROUND and symbol in _seen(circuit) and symbol not in own:
            yield Law(node, symbol, _between(circuit, node, GROUND))


def degenerate(circuit: Circuit) -> tuple[str, tuple[Element, ...]] | None:
    """Return what ties states together: "loop" or "cut" and its elements; None where nothing does."""
    for link in circuit.tree.links:
        if link.letter == "C":
            return "loop", (*(element for element, _ in circuit.tree.loop(link)), link)
    for branch in circuit.tree.branches:
        if branch.letter == "L":
            return "cut", (branch, *(element for element, _ in circuit.tree.cut(branch)))
    return None
