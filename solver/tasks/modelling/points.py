"""Points, families of them among these, held to the equations they are solutions of."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from solver.derivation import Check
from solver.lazy import numeric
from solver.numeric.judges import modelling as judges
from solver.words import Phrase

EXACT = 1e-20
NEAR = 1e-9
"""What 30 digits leave of an equation at an exact point, and at one in decimals."""


def point_checks(
    equations: Sequence[Any],
    told: Sequence[Any],
    every: Sequence[Any],
    between: Mapping[Any, Any],
    points: Sequence[Mapping[Any, Any]],
    answer: str,
    leading: Any = None,
) -> Iterable[Check]:
    """Every point satisfies the equations; Newton's method, from many starting points, finds no other.

    With `leading`, the factors of the highest derivatives, points count only where these are determined.
    """
    hidden = [x for x in every if x not in told]
    named = [_by_symbol(point, told) for point in points]
    yield Check.that("each point names every unknown, and nothing else", "compared",
                     all(each is not None for each in named), answer=answer)  # fmt: skip
    whole = [each for each in named if each is not None]
    if len(whole) < len(named):
        return
    inside = sorted({s for e in equations for s in e.free_symbols} - set(every), key=str)
    for i, point in enumerate(whole, 1):
        near = NEAR if numeric.holds_decimals(dict(point)) else EXACT
        residual = judges.substitution_residual(equations, point, inside, hidden)
        label = Phrase("point {i} put into the equations", i=i)
        yield replace(Check.within(label, "sympy.N, 30 digits", residual, near, answer=answer), item=i)
        if leading is not None:
            determined = judges.is_regular_at(leading, point)
            label = Phrase("the equations determine the motion at point {i}", i=i)
            yield replace(Check.that(label, "numpy.linalg.svd", determined, answer=answer), item=i)
    lost = judges.missing(equations, told, whole, between, hidden, leading)
    yield Check.that("Newton's method from many starting points finds no other point", "numpy.linalg.pinv", not lost,
                     answer=answer)  # fmt: skip


def _by_symbol(point: Mapping[Any, Any], told: Sequence[Any]) -> dict[Any, Any] | None:
    """The values by the symbols of the unknowns, whatever kind of symbol names them.

    None where one is missing, or given in terms of itself.
    """
    by_name = {str(key): value for key, value in dict(point).items()}
    if set(by_name) != {str(x) for x in told}:
        return None
    own = {str(x): x for x in told}
    found = {x: _own(by_name[str(x)], own) for x in told}
    bound = {x: value for x, value in found.items() if value != x}
    for _ in bound:  # x = y, y = 2 is x = 2
        bound = {x: value.xreplace(bound) if value.has(*bound) else value for x, value in bound.items()}
    return {**found, **bound} if not any(value.has(*bound) for value in bound.values()) else None


def _own(value: Any, own: Mapping[str, Any]) -> Any:
    """A value with our symbols in place of others of the same names."""
    put = {s: own[str(s)] for s in value.free_symbols if str(s) in own and own[str(s)] != s}
    return value.xreplace(put) if put else value
