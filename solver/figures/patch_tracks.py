"""In which order wires run beside each other in a channel: so that they cross as little as may be."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

Costs = Mapping[tuple[int, int], float]
"""What it costs that one wire runs before another one."""


def ordered(wires: Sequence[int], costs: Costs) -> list[int]:
    """Return the wires in a cheap order: each in turn moves to where it costs least, until none moves."""
    order: list[int] = []
    for wire in wires:
        order.insert(_best(order, wire, costs), wire)
    moved = len(order) > 1
    while moved:
        moved = False
        for wire in list(order):
            rest = [each for each in order if each != wire]
            place = _best(rest, wire, costs)
            if _cost_at(rest, wire, place, costs) < _cost_at(rest, wire, order.index(wire), costs) - 1e-9:
                order, moved = [*rest[:place], wire, *rest[place:]], True
    return order


def _cost_at(rest: Sequence[int], wire: int, place: int, costs: Costs) -> float:
    return sum(costs[each, wire] for each in rest[:place]) + sum(costs[wire, each] for each in rest[place:])


def _best(rest: Sequence[int], wire: int, costs: Costs) -> int:
    """The first of the cheapest places."""
    before = sum(costs[wire, each] for each in rest)
    best, least = 0, before
    for place, each in enumerate(rest, 1):
        before += costs[each, wire] - costs[wire, each]
        if before < least - 1e-9:
            best, least = place, before
    return best


def tracks(order: Sequence[int], apart: Callable[[int, int], bool]) -> dict[int, int]:
    """Return the number of the track of each wire; wires that are apart may share one, others keep their order."""
    found: dict[int, int] = {}
    for wire in order:
        found[wire] = max((track + 1 for other, track in found.items() if not apart(other, wire)), default=0)
    return found
