"""Usual mistakes with several points: some are missing, one turn in place of all, the wrong step of a family."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from typing import Any

from solver.derivation import Check, CheckStatus, Slip
from solver.lazy import sympy as sp
from solver.words import Reason

Points = Sequence[Mapping[Any, Any]]
MANY = 6
"""Of more points not every selection is tried."""

ONE_OF_SEVERAL = Slip("one_of_several", "What is listed is right, but it is not all: other points are missing.")
ONE_TURN = Slip("one_turn", "This is right for a single turn only; any integer number of turns may be added.")
WHOLE_TURNS = Slip("turns", "The step of the angle is not right: $n\\pi$ and $2n\\pi$ are exchanged.")


def parts_of(ours: Points) -> Iterator[list[Mapping[Any, Any]]]:
    """Yield selections of the points that are not all of them."""
    sizes = range(1, len(ours)) if len(ours) <= MANY else (1, len(ours) - 1)
    for size in sizes:
        yield from map(list, combinations(ours, size))


def single_turns(ours: Points) -> Iterator[list[dict[Any, Any]]]:
    """Yield the points for the integers 0, for 0 and 1, and for 0 and −1, as far as the angles are different."""
    for counts in ((0,), (0, 1), (0, -1), (0, 1, 2), (-1, 0, 1)):
        found: list[dict[Any, Any]] = []
        for point in ours:
            whole = _integers(point)
            values = [dict.fromkeys(whole, sp.Integer(i)) for i in counts] if whole else [{}]
            found += [{x: v.xreplace(put) for x, v in point.items()} for put in values]
        if any(_integers(point) for point in ours):
            yield found


def other_steps(ours: Points) -> Iterator[list[dict[Any, Any]]]:
    """Yield the families with twice and with half the step."""
    whole = {n for point in ours for n in _integers(point)}
    for by in (sp.Integer(2), sp.Rational(1, 2)) if whole else ():
        yield [{x: v.xreplace({n: by * n for n in whole}) for x, v in point.items()} for point in ours]


def _integers(point: Mapping[Any, Any]) -> list[Any]:
    return sorted({s for v in point.values() for s in v.free_symbols if s.is_integer} - set(point), key=str)


def meaning_of_points(checks: Sequence[Check], value: Any) -> Reason | None:
    """Return that each point listed is right by itself while others are missing; None otherwise."""
    judged = {check.item for check in checks if check.item}
    failed = [check for check in checks if check.status is CheckStatus.FAILED]
    if value and len(judged) == len(value) and failed and not any(check.item for check in failed):
        return Reason("solutions/some_missing")
    return None
