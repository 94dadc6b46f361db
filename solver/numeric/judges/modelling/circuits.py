"""What a circuit does, by modified nodal analysis with numpy: node voltages and currents at random s, from rest.

The unknowns are the voltages of all nodes but the ground and the currents through everything that is no conductance,
capacitance or current source; each element adds its stamp (Ho, Ruehli and Brennan, The Modified Nodal Approach, 1975).
Nothing of the derivations is used: no tree, no loops, no elimination.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols

TRIALS = 3
GROUND = "0"
BRANCHES = "VEHOL"
"""Elements whose current is an unknown."""


class Stamped:
    """The nodal equations of a circuit at one s and one point of its parameters: M z = N u."""

    def __init__(self, circuit: Any, s: complex, point: Mapping[Any, complex]) -> None:
        self.circuit, self.s, self.point = circuit, s, point
        self.elements = {each.name: each for each in circuit.elements}
        nodes = dict.fromkeys(node for each in circuit.elements for node in (*each.nodes, *each.watched))
        names = [node for node in nodes if node != GROUND]
        names += [each.name for each in circuit.elements if each.letter in BRANCHES]
        self.place = {name: i for i, name in enumerate(names)}
        size = len(names)
        self.M = np.zeros((size, size), dtype=complex)
        self.N = np.zeros((size, len(circuit.inputs) + 1), dtype=complex)  # the last column is of constant sources
        for each in circuit.elements:
            self._stamp(each)

    def number(self, value: Any) -> complex:
        """The value of an element."""
        return complex(np.ravel(value_of(value, Environment.at([dict(self.point)])).value)[0])

    def voltage(self, first: str, second: str) -> Array:
        """The voltage between two nodes, as a row over the unknowns."""
        row = np.zeros(len(self.place), dtype=complex)
        for node, sign in ((first, 1), (second, -1)):
            if node != GROUND:
                row[self.place[node]] += sign
        return row

    def current(self, element: Any) -> tuple[Array, Array]:
        """The current of an element, as rows over the unknowns and over the inputs."""
        row, drive = np.zeros(len(self.place), dtype=complex), np.zeros(self.N.shape[1], dtype=complex)
        if element.letter in BRANCHES:
            row[self.place[element.name]] = 1
        elif element.letter in "RC":
            value = self.number(element.value)
            row = self.voltage(*element.nodes) * (1 / value if element.letter == "R" else self.s * value)
        elif element.letter == "G":
            row = self.number(element.value) * self.voltage(*element.controls)
        elif element.letter == "F":
            row, drive = (self.number(element.value) * each for each in self.current(self._control(element)))
        else:
            drive = self._drive(element)
        return row, drive

    def _control(self, element: Any) -> Any:
        return self.elements[element.controls[0]]

    def _drive(self, element: Any) -> Array:
        """What an independent source gives, over the inputs and 1."""
        drive = np.zeros(self.N.shape[1], dtype=complex)
        if element.source:
            drive[self.circuit.inputs.index(element.source)] = 1
        else:
            drive[-1] = self.number(element.value)
        return drive

    def _stamp(self, element: Any) -> None:
        """Add an element to the current law at its nodes, and its own law where its current is an unknown."""
        row, drive = self.current(element)
        for node, sign in zip(element.nodes, (1, -1), strict=True):
            if node != GROUND:
                self.M[self.place[node]] += sign * row
                self.N[self.place[node]] -= sign * drive
        if element.letter in BRANCHES:
            own, given = self._law(element)
            self.M[self.place[element.name]] += own
            self.N[self.place[element.name]] += given

    def _law(self, element: Any) -> tuple[Array, Array]:
        """The law of an element whose current is an unknown."""
        across, none = self.voltage(*element.nodes), np.zeros(self.N.shape[1], dtype=complex)
        if element.letter == "V":
            return across, self._drive(element)
        if element.letter == "O":
            return self.voltage(*element.controls), none
        if element.letter == "E":
            return across - self.number(element.value) * self.voltage(*element.controls), none
        if element.letter == "H":
            row, drive = self.current(self._control(element))
            return across - self.number(element.value) * row, self.number(element.value) * drive
        row, _ = self.current(element)
        return across - self.s * self.number(element.value) * row, none

    def signals(self) -> dict[str, Array]:
        """Every voltage and current over the inputs and 1."""
        z = np.linalg.solve(self.M, self.N)
        found = {f"v_{node}": z[i] for node, i in self.place.items() if node not in self.elements}
        for each in self.circuit.elements:
            row, drive = self.current(each)
            found[f"v_{each.name}"] = self.voltage(*each.nodes) @ z
            found[f"i_{each.name}"] = row @ z + drive
        for i, name in enumerate(self.circuit.inputs):
            found[name] = np.eye(self.N.shape[1], dtype=complex)[i]
        return found

    def determinant(self) -> complex:
        """A polynomial in s whose roots are the natural frequencies."""
        return complex(np.linalg.det(self.M))


def _points(circuit: Any) -> Iterator[dict[Any, complex]]:
    values = [each.value for each in circuit.elements if each.value is not None]
    signals = {f"{letter}_{each.name}" for each in circuit.elements for letter in "vi"}
    signals |= {f"v_{node}" for each in circuit.elements for node in (*each.nodes, *each.watched)} | {*circuit.inputs}
    symbols = {x for x in free_symbols([*values, *circuit.outputs]) if str(x) not in signals}
    source = PointSource(sorted(symbols, key=str))
    for _ in range(TRIALS):
        yield dict(source.draw())


def _random_s(random: Random) -> complex:
    return complex(random.uniform(0.5, 2.0), random.uniform(0.5, 2.0))


def outputs_at(stamped: Stamped) -> Array:
    """Return the outputs over the inputs: what is linear in voltages and currents, a row for each output."""
    signals = stamped.signals()
    rows = []
    for output in stamped.circuit.outputs:
        inside = [x for x in free_symbols([output]) if str(x) in signals]
        rest = {**stamped.point, **dict.fromkeys(inside, 0.0)}
        row = np.zeros(stamped.N.shape[1], dtype=complex)
        for x in inside:
            slope = np.ravel(value_of(output, Environment.at([{**rest, x: 1.0}])).value)[0]
            row = row + slope * signals[str(x)]
        rows.append(row)
    return np.array(rows)[:, :-1]


def transfer_residual(circuit: Any, G: Any, s: Any) -> float:
    """Return how far G, a matrix of functions of s, is from what the circuit does at random s."""
    random, worst = Random(SEED), 0.0  # noqa: S311 - nothing secret
    for point in _points(circuit):
        at = _random_s(random)
        wanted = outputs_at(Stamped(circuit, at, point))
        found = np.array([_number(entry, {**point, s: at}) for entry in G]).reshape(G.shape)
        worst = max(worst, _distance(found, wanted))
    return worst


def frequencies_residual(circuit: Any, chi: Any, s: Any) -> float:
    """Return how far a polynomial in s is from having the natural frequencies of the circuit as its roots."""
    random, worst = Random(SEED), 0.0  # noqa: S311 - nothing secret
    for point in _points(circuit):
        first, second = _random_s(random), _random_s(random)
        wanted = Stamped(circuit, first, point).determinant() / Stamped(circuit, second, point).determinant()
        found = _number(chi, {**point, s: first}) / _number(chi, {**point, s: second})
        worst = max(worst, _distance(np.array([found]), np.array([wanted])))
    return worst


Rows = Sequence[tuple[Any, Any]]


def state_residuals(circuit: Any, rates: Rows, outputs: Sequence[Any], states: Sequence[Any]) -> tuple[float, float]:
    """Return how far state equations are from the circuit: in the transfer to its outputs, in natural frequencies.

    `rates` are factor and right side of factor · x' = right side, in the order of the states.
    """
    random, worst = Random(SEED), [0.0, 0.0]  # noqa: S311 - nothing secret
    for point in _points(circuit):
        inputs = [
            x for name in circuit.inputs for x in free_symbols([*(r for _, r in rates), *outputs]) if str(x) == name
        ]
        E = np.diag([_number(factor, point) for factor, _ in rates])
        A, C = (_slopes(rows, states, point, [*states, *inputs]) for rows in ([r for _, r in rates], outputs))
        B, D = (_inputs(rows, circuit.inputs, point, [*states, *inputs]) for rows in ([r for _, r in rates], outputs))
        dets = []
        for _ in range(2):
            s = _random_s(random)
            stamped = Stamped(circuit, s, point)
            pencil = s * E - A
            dets.append((np.linalg.det(pencil), stamped.determinant()))
            if circuit.inputs:
                found = C @ np.linalg.solve(pencil, B) + D
                worst[0] = max(worst[0], _distance(found, outputs_at(stamped)))
        (p, P), (q, Q) = dets
        worst[1] = max(worst[1], _distance(np.array([p / q]), np.array([P / Q])))
    return worst[0], worst[1]


def _slopes(rows: Iterable[Any], symbols: Sequence[Any], point: Mapping[Any, complex], signals: Sequence[Any]) -> Array:
    """The coefficients of symbols in linear rows."""
    rest = {**point, **dict.fromkeys(signals, 0.0)}
    rows = list(rows)
    found = [[_number(row, {**rest, x: 1.0}) - _number(row, rest) for x in symbols] for row in rows]
    return np.array(found, dtype=complex).reshape(len(rows), len(symbols))


def _inputs(rows: Iterable[Any], names: Sequence[str], point: Mapping[Any, complex], signals: Sequence[Any]) -> Array:
    """The coefficients of inputs, by their names: one that occurs nowhere has a column of zeros."""
    rows, there = list(rows), {str(x): x for x in signals}
    columns = [
        _slopes(rows, [there[name]], point, signals) if name in there else np.zeros((len(rows), 1)) for name in names
    ]
    return np.hstack(columns) if columns else np.zeros((len(rows), 0))


def _number(value: Any, point: Mapping[Any, complex]) -> complex:
    return complex(np.ravel(value_of(value, Environment.at([dict(point)])).value)[0])


def _distance(found: Array, wanted: Array) -> float:
    if found.shape != wanted.shape:
        return np.inf
    size = max(1.0, float(np.max(np.abs(wanted), initial=0.0)))
    distance = float(np.max(np.abs(found - wanted), initial=0.0)) / size
    return distance if np.isfinite(distance) else np.inf
