"""Where everything in a patch diagram stands, as strokes. Units are centimetres, y points up."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache

from solver.derivation.patch_figures import PatchDiagram
from solver.figures.layout import Dot, Label, Point
from solver.figures.patch_cells import BOX, RADIUS, SYMBOL, TALL, Cell, Cells, Port
from solver.figures.patch_search import wiring_of
from solver.figures.patch_wires import MARGIN, STEP, Segment
from solver.figures.strokes import Line, Ring, Shape, Stroke
from solver.formula.terminal import flat

TERMINAL, MOST_TALL = 0.07, 1.05
"""Radius of a terminal, and half of the height up to which triangles grow with their inputs."""


def text_width(text: str) -> float:
    """Return about how wide a label is."""
    return 0.12 + 0.17 * len(flat(text)) if text else 0.0


@lru_cache(maxsize=16)
def layout_of(figure: PatchDiagram) -> tuple[Stroke, ...]:
    """Return what is drawn, in its order: wires first."""
    drawing = PatchDrawing(figure)
    return (*drawing.wires(), *drawing.symbols())


class PatchDrawing:
    """A diagram while it is laid out: the wires, and the zones of each column from left to right."""

    def __init__(self, figure: PatchDiagram) -> None:
        self.elements = figure.elements
        self.cells = Cells(figure).cells
        self.wiring = wiring_of(Cells(figure))
        self.going = {self.cells[net.start].element for net in self.wiring.nets}
        self.channels: list[float] = []
        self.pots: list[float] = []
        self.backs: list[float] = []
        self.terminals: list[float] = []
        self._across()

    def _across(self) -> None:
        """Give each column its zones: terminals, potentiometers, gains, symbols, names of what leaves them."""
        x = 0.0
        for column in range(self.wiring.columns + 1):
            count = 1 + max((t for (c, _), t in self.wiring.tracks.items() if c == column), default=-1)
            self.channels.append(x + MARGIN)
            x += 2 * MARGIN + STEP * (count - 1) if count else 0.0
            if column == self.wiring.columns:
                break
            mine = [cell for n, cell in enumerate(self.cells) if self.wiring.column(n) == column]
            ports = [port for cell in mine for port in cell.ports]
            named = [self._source(port) for port in ports if port.source is not None]
            named += [self.elements[cell.element].value for cell in mine if cell.kind == "source"]
            x += max((text_width(name) + 0.15 for name in named), default=0.0)
            self.terminals.append(x)
            widths = [max(2 * RADIUS + 0.2, text_width(self.elements[p.pot].value)) for p in ports if p.pot is not None]
            self.pots.append(x + max(widths, default=0.0) / 2 + 0.1)
            x += max(widths, default=0.0) + 0.2 * bool(widths)
            x += max([0.2, *(text_width(port.gain) + 0.06 for port in ports)])
            self.backs.append(x)
            x += max(self._width(cell) for cell in mine)
            x += max([0.1, *(self._stub(cell) for cell in mine)])

    def _stub(self, cell: Cell) -> float:
        """How much wire there is in front of a symbol, for the name of what leaves it or for a terminal."""
        name = self.elements[cell.element].output
        return text_width(name) or (0.0 if cell.kind == "source" or cell.element in self.going else 0.25)

    def _source(self, port: Port) -> str:
        return self.elements[port.source].value if port.source is not None else ""

    def _width(self, cell: Cell) -> float:
        return {"integrator": BOX + SYMBOL, "pot": 2 * RADIUS, "source": 2 * TERMINAL}.get(cell.kind, SYMBOL)

    def x(self, channel: int, track: int) -> float:
        """Where a track of a channel is."""
        return self.channels[channel] + STEP * track

    def ends(self, number: int) -> tuple[float, float]:
        """Where the symbol of a cell begins and ends."""
        back = self.backs[self.wiring.column(number)]
        return back, back + self._width(self.cells[number])

    def wires(self) -> Iterator[Stroke]:
        """The wires between cells, with dots where they branch."""
        for number in range(len(self.wiring.nets)):
            pieces = self.wiring.segments(number, self.x, self.ends)
            yield from (Line(piece) for piece in pieces if piece[0] != piece[1])
            yield from (Dot(*point) for point in branches(pieces))

    def symbols(self) -> Iterator[Stroke]:
        """What stands in the columns, with what is written there."""
        for number, cell in enumerate(self.cells):
            yield from self._inputs(number, cell)
            yield from self._symbol(number, cell)
            output = self.elements[cell.element].output
            x, y = self.ends(number)[1], self.wiring.middle(number)
            if output:
                yield Label(x - 0.02, y, output, "above right")
            if cell.element not in self.going and (stub := self._stub(cell)):
                yield Line(((x, y), (x + stub, y)))
                yield Ring((x + stub, y), TERMINAL, joint=True)

    def _inputs(self, number: int, cell: Cell) -> Iterator[Stroke]:
        """The rows of inputs: terminals, potentiometers, gains."""
        column, (back, _) = self.wiring.column(number), self.ends(number)
        for k, port in enumerate(cell.ports):
            y = self.wiring.port(number, k)
            if port.source is not None:
                place = (self.terminals[column], y)
                yield Line((place, (back, y)))
                yield Ring(place, TERMINAL, joint=True)
                yield Label(place[0] - TERMINAL, y, self._source(port), "left")
            if port.pot is not None:
                yield from self._pot(port.pot, (self.pots[column], y))
            if port.gain:
                yield Label(back - 0.02, y - 0.04, port.gain, "above left")

    def _pot(self, element: int, place: Point) -> Iterator[Stroke]:
        yield Ring(place, RADIUS)
        yield Label(*place, self.elements[element].name, "")
        yield Label(place[0], place[1] + RADIUS - 0.02, self.elements[element].value, "above")

    def _symbol(self, number: int, cell: Cell) -> Iterator[Stroke]:
        (x, end), y = self.ends(number), self.wiring.middle(number)
        element = self.elements[cell.element]
        if cell.kind == "pot":
            yield from self._pot(cell.element, (x + RADIUS, y))
        elif cell.kind == "source":
            yield Ring((x + TERMINAL, y), TERMINAL, joint=True)
            yield Label(x, y, element.value, "left")
        else:
            half = cell.half_height(self.wiring.offsets[number])
            front = x + BOX if cell.kind == "integrator" else x
            tall = half if half < MOST_TALL else TALL / 2
            yield Shape(((front, y + tall), (end, y), (front, y - tall)))
            yield Label(front + 0.36 * SYMBOL, y, element.name, "")
            if cell.kind == "integrator":
                yield Shape(((x, y - half), (x, y + half), (front, y + half), (front, y - half)))
            elif half > tall:
                yield Line(((x, y - half), (x, y + half)))
            if cell.starts:
                yield from _start((x + BOX / 2, y + half), element.value)


def _start(place: Point, value: str) -> Iterator[Stroke]:
    """The terminal for the initial value, on top of an integrator."""
    x, y = place
    yield Line((place, (x, y + 0.25)))
    yield Ring((x, y + 0.25), TERMINAL, joint=True)
    yield Label(x, y + 0.25 + TERMINAL / 2, value, "above")


def branches(pieces: Sequence[Segment]) -> list[Point]:
    """Return the points at which three or four pieces of a wire meet."""
    found = []
    for point in dict.fromkeys(p for piece in pieces for p in piece if piece[0] != piece[1]):
        ways: set[tuple[int, int]] = set()
        for a, b in pieces:
            if a != b and _upon(point, a, b):
                ways |= {_toward(point, end) for end in (a, b) if _apart(point, end)}
        if len(ways) > 2:
            found.append(point)
    return found


def _apart(a: Point, b: Point) -> bool:
    return abs(a[0] - b[0]) + abs(a[1] - b[1]) > 1e-6


def _upon(point: Point, a: Point, b: Point) -> bool:
    return all(min(s, t) - 1e-6 <= p <= max(s, t) + 1e-6 for p, s, t in zip(point, a, b, strict=True))


def _toward(a: Point, b: Point) -> tuple[int, int]:
    return round((b[0] - a[0]) / (abs(b[0] - a[0]) + 1e-9)), round((b[1] - a[1]) / (abs(b[1] - a[1]) + 1e-9))
