"""Where everything in the drawing of a circuit stands: nodes in a row, the ground below, what leads past nodes above.

The order of the nodes is the one in which no wire crosses another and the fewest elements lie above the row; where
there is none, the circuit is not drawn. Units are those of a component's body; y points up.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise, permutations

from solver.derivation.figures import Component, Schematic
from solver.figures.laid_circuits import Amplifier, CircuitLayout, Placed, dots_of
from solver.figures.stage_layout import stages_layout

GROUND = "0"
CELL, COLUMN, HEIGHT, LANE = 2.6, 2.0, 2.6, 1.3
"""Widths of a gap with an element, and of a column; heights of the row and of a lane above it."""
AMPLIFIER, PINS, LOW, ROOM = 4.0, 1.0, 1.9, 1.0
"""Width of a gap with an amplifier, distance of its inputs, how far below the row a wire runs to the second one, and
what more is needed beside a column."""
BESIDE = 0.35
"""How far beside a column a wire from below comes to a node."""
MOST = 6
"""So many nodes are tried in every order, more in the order of the list only."""


@dataclass
class _Plan:
    """A circuit with its nodes in one order: what lies in the gaps, below the nodes and above the row."""

    order: Sequence[str]
    series: dict[int, Component] = field(default_factory=dict)
    amplifiers: dict[int, tuple[Component, bool]] = field(default_factory=dict)
    shunts: dict[int, list[Component]] = field(default_factory=dict)
    above: list[tuple[int, int, Component]] = field(default_factory=list)
    below: list[tuple[int, int]] = field(default_factory=list)

    def place(self, node: str) -> int:
        return self.order.index(node)

    def lanes(self) -> list[int]:
        """The lane of each element above the row: one more than those of all that it leads past."""
        found: list[int] = []
        for i, (a, b, _) in enumerate(self.above):
            inside = [found[j] for j, (c, d, _) in enumerate(self.above[:i]) if a <= c and d <= b]
            found.append(1 + max(inside, default=0))
        return found

    @property
    def crosses(self) -> bool:
        """Whether wires above the row cross, or wires below it a column."""
        spans = [(a, b) for a, b, _ in self.above]
        if any(a < c < b < d for a, b in spans for c, d in spans):
            return True
        if any(a < d and c < b for i, (a, b) in enumerate(self.below) for c, d in self.below[:i]):
            return True
        return any(self.shunts.get(k) for a, b in self.below for k in range(a + 1, b + (b in self.amplifiers)))

    @property
    def cost(self) -> float:
        """The fewer and shorter the ways above and below, the better; sources stand on the left."""
        long = sum(b - a for a, b, _ in self.above) + sum(self.lanes())
        sources = [k for k, below in self.shunts.items() for each in below if each.letter in "VI"]
        return 3.0 * long + 1.0 * sum(b - a for a, b in self.below) + 0.5 * sum(sources)


def layout_of(schematic: Schematic) -> CircuitLayout | None:
    """Return the layout of a circuit, None where it cannot be drawn well."""
    if (stages := stages_layout(schematic)) is not None:
        return stages
    components = schematic.components
    nodes = list(dict.fromkeys(n for each in components for n in each.nodes if n != GROUND))
    orders: Iterable[Sequence[str]] = permutations(nodes) if len(nodes) <= MOST else [nodes]
    plans = [plan for order in orders if (plan := _plan(order, components)) is not None and not plan.crosses]
    return _drawn(min(plans, key=lambda plan: plan.cost)) if plans else None


def _plan(order: Sequence[str], components: Sequence[Component]) -> _Plan | None:
    """Return what lies where if the nodes stand in this order; None where an amplifier has no place."""
    plan = _Plan(order)
    for each in components:
        if each.letter == "O" and not _amplifier(plan, each):
            return None
    long = []
    for each in components:
        if each.letter == "O":
            continue
        first, second = each.nodes
        if GROUND in each.nodes:
            plan.shunts.setdefault(plan.place(first if second == GROUND else second), []).append(each)
            continue
        a, b = sorted((plan.place(first), plan.place(second)))
        if b == a + 1 and a not in plan.series and a not in plan.amplifiers:
            plan.series[a] = each
        else:
            long.append((a, b, each))
    plan.above = sorted(long, key=lambda span: span[1] - span[0])
    return plan


def _amplifier(plan: _Plan, each: Component) -> bool:
    """Place an amplifier between one of its inputs and its output, which follows it; False where that cannot be."""
    plus, minus = each.inputs
    output = plan.place(each.nodes[0])
    if each.nodes[1] != GROUND or output - 1 in plan.amplifiers:
        return False
    above = next((n for n in (minus, plus) if n in plan.order and plan.place(n) == output - 1), None)
    if above is None:
        return False
    plan.amplifiers[output - 1] = (each, above == minus)
    other = plus if above == minus else minus
    if other not in (GROUND, each.nodes[0]):
        if other not in plan.order or other == above:
            return False
        place = plan.place(other)
        plan.below.append((output - 1, place) if place > output else (place, output - 1))
    return True


def _drawn(plan: _Plan) -> CircuitLayout:
    """Give everything its place."""
    layout, (left, right) = CircuitLayout(), _columns(plan)
    entry, leave = _ends(plan, left, right)
    for k, below in plan.shunts.items():
        for i, each in enumerate(below):
            top = (left[k] + i * COLUMN, HEIGHT)
            foot = (top[0], 0.0)
            layout.placed.append(Placed(each, *((top, foot) if each.nodes[1] == GROUND else (foot, top))))
    for k in range(len(plan.order)):
        columns = [left[k] + i * COLUMN for i in range(len(plan.shunts.get(k, [])))] or [left[k]]
        along = dict.fromkeys((entry[k], *columns, leave[k]))
        layout.wires += pairwise((x, HEIGHT) for x in along)
        layout.names.append(((left[k], HEIGHT), plan.order[k]))
    _series(layout, plan, entry, leave)
    _above(layout, plan, left, right)
    for k in plan.amplifiers:
        _place_amplifier(layout, plan, k, entry, leave)
    _rail(layout, plan, left)
    layout.dots = dots_of(layout)
    return layout


def _columns(plan: _Plan) -> tuple[list[float], list[float]]:
    """Where the first and the last column of each node stand."""
    left, right, x = [], [], 0.0
    for k in range(len(plan.order)):
        left.append(x)
        x += COLUMN * max(0, len(plan.shunts.get(k, [])) - 1)
        right.append(x)
        beside = ROOM * bool(plan.shunts.get(k))
        x += AMPLIFIER + beside if k in plan.amplifiers else CELL if k in plan.series or _spanned(plan, k) else COLUMN
    return left, right


def _ends(plan: _Plan, left: Sequence[float], right: Sequence[float]) -> tuple[list[float], list[float]]:
    """Where each node begins and ends: beside its columns where a wire from below comes to it."""
    entry, leave = list(left), list(right)
    for k, (each, minus_above) in plan.amplifiers.items():
        other = each.inputs[0 if minus_above else 1]
        if other not in (GROUND, each.nodes[0]):
            place = plan.place(other)
            if place > k:
                entry[place] = left[place] - BESIDE
            else:
                leave[place] = right[place] + BESIDE
    return entry, leave


def _spanned(plan: _Plan, k: int) -> bool:
    """Whether an element above the row needs the width of this gap."""
    return any(a == k and b == k + 1 for a, b, _ in plan.above)


def _series(layout: CircuitLayout, plan: _Plan, left: Sequence[float], right: Sequence[float]) -> None:
    """Place the elements in the row."""
    for k, each in plan.series.items():
        ends = (right[k], HEIGHT), (left[k + 1], HEIGHT)
        layout.placed.append(Placed(each, *(ends if plan.place(each.nodes[0]) == k else ends[::-1])))


def _above(layout: CircuitLayout, plan: _Plan, left: Sequence[float], right: Sequence[float]) -> None:
    """Place the elements above the row, with wires up to them."""
    for (a, b, each), lane in zip(plan.above, plan.lanes(), strict=True):
        y = HEIGHT + LANE * lane
        middle, half = (right[a] + left[b]) / 2, CELL / 2
        ends = (middle - half, y), (middle + half, y)
        layout.placed.append(Placed(each, *(ends if plan.place(each.nodes[0]) == a else ends[::-1])))
        layout.wires += [
            ((right[a], HEIGHT), (right[a], y), ends[0]),
            (ends[1], (left[b], y), (left[b], HEIGHT)),
        ]


def _place_amplifier(layout: CircuitLayout, plan: _Plan, k: int, left: Sequence[float], right: Sequence[float]) -> None:
    """Place an amplifier between two nodes, and lead its second input to where it belongs."""
    each, minus_above = plan.amplifiers[k]
    x, out = right[k] + 0.9 + ROOM * bool(plan.shunts.get(k)), left[k + 1]
    upper, lower, tip = (x, HEIGHT), (x, HEIGHT - PINS), (x + 1.9, HEIGHT - PINS / 2)
    layout.amplifiers.append(Amplifier(each, upper, lower, tip, minus_above))
    layout.wires += [((right[k], HEIGHT), upper), (tip, (out - 0.5, tip[1]), (out - 0.5, HEIGHT), (out, HEIGHT))]
    plus, minus = each.inputs
    other = plus if minus_above else minus
    pin, y = lower[0] - 0.35, HEIGHT - LOW
    if other == GROUND:
        layout.wires.append((lower, (pin, lower[1]), (pin, lower[1] - 0.35)))
        layout.grounds.append((pin, lower[1] - 0.35))
    elif other == each.nodes[0]:
        layout.wires.append((lower, (pin, lower[1]), (pin, y), (out - 0.5, y), (out - 0.5, tip[1])))
    else:
        place = plan.place(other)
        at = left[place] if place > k else right[place]
        layout.wires.append((lower, (pin, lower[1]), (pin, y), (at, y), (at, HEIGHT)))


def _rail(layout: CircuitLayout, plan: _Plan, left: Sequence[float]) -> None:
    """The ground below, and its sign."""
    feet = sorted(left[k] + i * COLUMN for k, below in plan.shunts.items() for i in range(len(below)))
    if len(feet) > 1:
        layout.wires += [((x, 0.0), (following, 0.0)) for x, following in pairwise(feet)]
    if feet:
        layout.grounds.append((feet[0], 0.0))
