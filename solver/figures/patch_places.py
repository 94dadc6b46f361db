"""Where the cells of a patch diagram stand: a grid, chains from left to right, what is joined near to each other."""

from __future__ import annotations

from itertools import combinations, product

from solver.figures.patch_cells import Cells

Spot = tuple[int, int]
"""Row and column."""

ABREAST = 3, 4
"""So many cells stand in a row."""
READING = 2.0
"""How much it matters that chains are read from the left."""
MOST = 2
"""So many of the best are returned."""


class Grid:
    """The spots that there are, and what is to be near to what."""

    def __init__(self, cells: Cells, width: int) -> None:
        self.cells, self.width = cells, width
        count = len(cells.cells)
        self.spots = [divmod(i, width) for i in range(count + (-count) % width)]
        self.edges = sorted({(net.start, end) for net in cells.nets for end, _ in net.ends})
        self.chain = [(a, b) for a, b in self.edges if self._follows(a, b)]
        followers = {b for _, b in self.chain}
        self.heads = [i for i, each in enumerate(cells.cells) if each.kind == "integrator" and i not in followers]

    def _follows(self, first: int, second: int) -> bool:
        """Whether an integrator only integrates what another one gives."""
        one, other = self.cells.cells[first], self.cells.cells[second]
        return one.kind == other.kind == "integrator" and len(other.ports) == 1

    def reading(self, spots: tuple[Spot, ...]) -> float:
        """Return how far the chains are from standing in a row from the left, as they are read."""
        total = 0.0
        for (row, column), (down, across) in ((spots[a], spots[b]) for a, b in self.chain):
            wraps = down == row + 1 and across == 0
            total += 0.0 if (down, across) == (row, column + 1) else 0.8 if wraps else 1.5
        return total + sum(0.3 * column + 0.1 * row for row, column in (spots[i] for i in self.heads))

    def cost(self, place: list[int]) -> float:
        """Return about how long the wires are and how many turns they have, and how badly the diagram is read."""
        spots = tuple(self.spots[i] for i in place)
        total = READING * self.reading(spots)
        for (row, column), (down, across) in ((spots[a], spots[b]) for a, b in self.edges):
            beyond, apart = across - column - 1, abs(down - row)
            if beyond:
                total += 2.0 + 0.6 * abs(beyond) + 0.8 * apart
            elif apart:
                total += 1.0 + apart
        return total + sum(0.01 * row + 0.001 * column for row, column in spots)


def grids_of(cells: Cells) -> list[Grid]:
    """Return narrow and wide grids for the cells."""
    count = len(cells.cells)
    return [Grid(cells, width) for width in sorted({min(count, most) for most in ABREAST})]


def places_of(grid: Grid) -> list[tuple[Spot, ...]]:
    """Return rows and columns of the cells, the best first: what exchanging two of them leads to from some orders."""
    found = {tuple(place): cost for cost, place in (_exchanged(grid, each) for each in _beginnings(grid))}
    best = sorted(found, key=lambda place: (round(found[place], 6), place))[:MOST]
    return [tuple(grid.spots[i] for i in place) for place in best]


def _beginnings(grid: Grid) -> list[list[int]]:
    """Return beginnings: the cells as they are listed, and along the signal from each of the first."""
    count = len(grid.cells.cells)
    found = [list(range(count))]
    for start in range(min(count, ABREAST[-1])):
        order, waiting = [], [start]
        while waiting:
            number = waiting.pop()
            if number not in order:
                order.append(number)
                waiting += [b for a, b in reversed(grid.edges) if a == number]
        order += [i for i in range(count) if i not in order]
        found.append([order.index(i) for i in range(count)])
    return found


def _exchanged(grid: Grid, place: list[int]) -> tuple[float, list[int]]:
    """Exchange cells, or move them to free spots, as long as that is better."""
    cost, better = grid.cost(place), True
    while better:
        better = False
        free = sorted(set(range(len(grid.spots))) - set(place))
        swaps = [(i, j, -1) for i, j in combinations(range(len(place)), 2)]
        for i, j, spot in [*swaps, *((i, i, s) for i, s in product(range(len(place)), free))]:
            if spot in place:
                continue
            trial = list(place)
            trial[i], trial[j] = (place[j], place[i]) if spot < 0 else (spot, spot)
            now = grid.cost(trial)
            if now < cost - 1e-9:
                place, cost, better = trial, now, True
    return cost, place
