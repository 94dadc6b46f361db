"""A block diagram as positions: what the SVG and the TikZ are both drawn from. Units are centimetres, y points up."""

from __future__ import annotations

from dataclasses import dataclass, field

HEIGHT = 0.9
"""Height of a block."""

RADIUS = 0.2
"""Radius of a summing point."""

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Block:
    """A box with a formula in it, centred at (x, y)."""

    x: float
    y: float
    text: str
    width: float = 1.6
    height: float = HEIGHT
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Sum:
    """A summing point at (x, y)."""

    x: float
    y: float


@dataclass(frozen=True, slots=True)
class Wire:
    """A line through some points, with an arrowhead at its end unless `arrow` is false."""

    points: tuple[Point, ...]
    arrow: bool = True


@dataclass(frozen=True, slots=True)
class Label:
    """A formula beside a wire: a signal, or the sign at a summing point. `anchor` is where the point is: "below",..."""

    x: float
    y: float
    text: str
    anchor: str = "above"


@dataclass(frozen=True, slots=True)
class Dot:
    """A point where a wire branches."""

    x: float
    y: float


Item = Block | Sum | Wire | Label | Dot


@dataclass
class Layout:
    """A whole diagram."""

    items: list[Item] = field(default_factory=list)

    def add(self, *items: Item) -> None:
        """Put items on the diagram."""
        self.items.extend(items)

    def wire(self, *points: Point, arrow: bool = True) -> None:
        """Draw a wire through points; one that comes twice is one."""
        self.add(Wire(tuple(dict.fromkeys(points)), arrow))

    def sign(self, x: float, y: float, text: str, anchor: str = "above left") -> None:
        """Write a sign at a summing point."""
        self.add(Label(x, y, text, anchor))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """x_min, x_max, y_min, y_max of what is drawn, with room for labels."""
        xs: list[float] = []
        ys: list[float] = []
        for item in self.items:
            if isinstance(item, Block):
                xs += [item.x - item.width / 2, item.x + item.width / 2]
                ys += [item.y - item.height / 2, item.y + item.height / 2]
            elif isinstance(item, Wire):
                xs += [x for x, _ in item.points]
                ys += [y for _, y in item.points]
            else:
                xs += [item.x - 0.3, item.x + 0.3]
                ys += [item.y - 0.4, item.y + 0.4]
        return min(xs) - 0.15, max(xs) + 0.15, min(ys) - 0.15, max(ys) + 0.15
