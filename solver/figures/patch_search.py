"""The plan of a patch diagram with the fewest crossings that small changes lead to."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import combinations

from solver.figures.patch_cells import Cells
from solver.figures.patch_places import Spot, grids_of, places_of
from solver.figures.patch_wires import Plan, Wiring

Change = Callable[[Plan], Plan]

MOST_TRIALS, TRIED = 150, 3
"""After so many changes no new round of them begins; so many places of the cells are tried."""
CROSSING, READING, COLUMN = 6.0, 10.0, 5.0
"""So many centimetres of wire are better than a crossing, than a chain that is broken, than one column more."""


def wiring_of(cells: Cells) -> Wiring:
    """Return the wires of a diagram: of some places of the cells those that are best after some changes."""
    found = []
    for grid in grids_of(cells):
        for spots in places_of(grid):
            read = READING * grid.reading(spots) + COLUMN * grid.width
            first = Wiring(_first(cells, spots))
            found.append((read + _cost(first), read, first))
    changed = [(read, _changed(wiring)) for _, read, wiring in sorted(found, key=lambda each: each[0])[:TRIED]]
    return min(changed, key=lambda each: each[0] + _cost(each[1]))[1]


def _changed(best: Wiring) -> Wiring:
    """Let inputs change places and wires change lanes, as long as that is better."""
    least, trials, better = _cost(best), 0, True
    while better and trials < MOST_TRIALS:
        better = False
        for change in _changes(best):
            trials += 1
            now = Wiring(change(best.plan))
            cost = _cost(now)
            if cost < least - 1e-9:
                best, least, better = now, cost, True
    return best


def _cost(wiring: Wiring) -> float:
    crossings, length = wiring.quality
    return CROSSING * crossings + length


def _first(cells: Cells, spots: tuple[Spot, ...]) -> Plan:
    """Inputs from above come first, then the neighbour's, terminals, those from below; wires run near their cells."""
    orders = []
    for number, cell in enumerate(cells.cells):
        row, column = spots[number]

        def height(k: int, row: int = row, column: int = column, ports: tuple = cell.ports) -> float:  # type: ignore[type-arg]
            if ports[k].cell is None:
                return 0.5
            down, across = spots[ports[k].cell]
            if (down, across) == (row, column - 1):
                return 0.0
            return -1.0 if down < row else 1.0

        orders.append(tuple(sorted(range(len(cell.ports)), key=height)))
    lanes = [spots[net.start][0] + 1 for net in cells.nets]
    return Plan(cells, spots, tuple(orders), tuple(lanes))


def _changes(wiring: Wiring) -> Iterator[Change]:
    """Yield changes of a plan: a wire goes to another lane, two inputs of a cell change places."""
    plan = wiring.plan
    for number in range(len(plan.lanes)):
        if wiring.in_lane(number):
            yield from (partial(_in_lane, number, lane) for lane in range(wiring.rows + 1))
    for cell, order in enumerate(plan.orders):
        ports = [plan.cells.cells[cell].ports[k] for k in order]
        alike = [(port.cell, port.pot is None) for port in ports]
        for i, j in combinations(range(len(order)), 2):
            if alike[i] != alike[j]:
                yield partial(_exchanged, cell, i, j)


def _in_lane(number: int, lane: int, plan: Plan) -> Plan:
    return replace(plan, lanes=(*plan.lanes[:number], lane, *plan.lanes[number + 1 :]))


def _exchanged(cell: int, i: int, j: int, plan: Plan) -> Plan:
    changed = list(plan.orders[cell])
    changed[i], changed[j] = changed[j], changed[i]
    return replace(plan, orders=(*plan.orders[:cell], tuple(changed), *plan.orders[cell + 1 :]))
