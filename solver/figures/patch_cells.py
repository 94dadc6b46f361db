"""What is placed in a patch diagram: cells with rows of inputs, and the wires that join them, by number.

A potentiometer that feeds one amplifier stands in the row of that input, a source in front of each input that it
feeds, as a terminal under its name. So only amplifiers, and potentiometers of several inputs, have cells.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from solver.derivation.patch_figures import PatchDiagram, PatchElement

AMPLIFIERS = ("integrator", "summer", "inverter")

SYMBOL, BOX, TALL, RADIUS = 1.25, 0.26, 1.3, 0.3
"""Width of a triangle, of the box at an integrator's back, height of a triangle, radius of a potentiometer."""
BESIDE, WRITTEN = 0.36, 0.4
"""Half of the least height of a back beyond its outer inputs, and the height of a line of text."""
START = 0.75
"""Room above an integrator for its initial value."""


@dataclass(frozen=True, slots=True)
class Port:
    """One input: the cell that it comes from, or the source (None); the potentiometer in its row; its gain."""

    cell: int | None
    source: int | None
    pot: int | None
    gain: str

    @property
    def above(self) -> float:
        """How far up from its wire it reaches."""
        return RADIUS + WRITTEN if self.pot is not None else WRITTEN if self.gain else RADIUS / 2

    @property
    def below(self) -> float:
        """How far down from its wire it reaches."""
        return RADIUS + 0.05 if self.pot is not None else 0.15


@dataclass(frozen=True, slots=True)
class Cell:
    """An amplifier, a potentiometer or a source (numbers of elements) with its inputs."""

    element: int
    kind: str
    ports: tuple[Port, ...]
    starts: bool

    def offsets(self, order: tuple[int, ...]) -> tuple[float, ...]:
        """Return the heights of the inputs above the middle of the symbol, where they stand in an order from above."""
        ys = [0.0]
        for upper, lower in pairwise(order):
            ys.append(ys[-1] - max(0.45, self.ports[upper].below + self.ports[lower].above))
        middle = (ys[0] + ys[-1]) / 2
        found = dict(zip(order, (y - middle for y in ys), strict=False))
        return tuple(found[i] for i in range(len(self.ports)))

    def half_height(self, offsets: tuple[float, ...]) -> float:
        """Return half of the height of its back."""
        if self.kind not in AMPLIFIERS:
            return RADIUS
        return max(TALL / 2, max(map(abs, offsets), default=0.0) + BESIDE)


@dataclass(frozen=True)
class Net:
    """The wires from the output of a cell to inputs: (cell, number of its port)."""

    start: int
    ends: tuple[tuple[int, int], ...]


@dataclass(frozen=True)
class Cells:
    """The cells of a diagram, in the order of their elements."""

    figure: PatchDiagram

    @cached_property
    def destinations(self) -> dict[int, list[int]]:
        """The elements that each element feeds."""
        found: dict[int, list[int]] = {i: [] for i in range(len(self.figure.elements))}
        for i, each in enumerate(self.figure.elements):
            for number, _ in each.inputs:
                found[number].append(i)
        return found

    def in_a_row(self, number: int) -> bool:
        """Whether an element stands in the row of an input, not in a cell."""
        each, fed = self.figure.elements[number], self.destinations[number]
        if each.output or not fed:
            return False
        if each.kind == "source":
            return True
        return each.kind == "pot" and len(fed) == 1 and self.figure.elements[fed[0]].kind in AMPLIFIERS

    @cached_property
    def numbers(self) -> dict[int, int]:
        """The number of the cell of an element."""
        return {n: i for i, n in enumerate(n for n in range(len(self.figure.elements)) if not self.in_a_row(n))}

    @cached_property
    def cells(self) -> tuple[Cell, ...]:
        """The cells."""
        return tuple(self._cell(number, self.figure.elements[number]) for number in self.numbers)

    def _cell(self, number: int, element: PatchElement) -> Cell:
        ports = tuple(self._port(fed, gain, element) for fed, gain in element.inputs)
        return Cell(number, element.kind, ports, element.kind == "integrator" and bool(element.value))

    def _port(self, fed: int, gain: str, element: PatchElement) -> Port:
        gain = gain if element.kind in AMPLIFIERS else ""
        pot = None
        if self.figure.elements[fed].kind == "pot" and self.in_a_row(fed):
            pot, fed = fed, self.figure.elements[fed].inputs[0][0]
        if fed in self.numbers:
            return Port(self.numbers[fed], None, pot, gain)
        return Port(None, fed, pot, gain)

    @cached_property
    def nets(self) -> tuple[Net, ...]:
        """What leaves each cell, if it goes anywhere."""
        ends: dict[int, list[tuple[int, int]]] = {}
        for number, cell in enumerate(self.cells):
            for k, port in enumerate(cell.ports):
                if port.cell is not None:
                    ends.setdefault(port.cell, []).append((number, k))
        return tuple(Net(start, tuple(ends[start])) for start in sorted(ends))
