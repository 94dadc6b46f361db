"""What the solution of a system of equations goes through: cases with what is left to solve, and the moves made."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

Point = dict[sp.Symbol, sp.Expr]
Box = Mapping[sp.Symbol, tuple[sp.Expr, sp.Expr]]


@dataclass(frozen=True)
class Move:
    """One move: its kind, the case in which it is made, and what it says, by name."""

    kind: str
    case: tuple[int, ...]
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Outcome:
    """What one equation leads to: unknowns with their values, or an equation in its place.

    `integer` is any whole number that came in, `needs` are conditions on parameters, `nonzero` what must not vanish;
    `known` are functions whose values are found, `shown` are both sides of what a page shows.
    """

    put: Point = field(default_factory=dict)
    equations: tuple[sp.Expr, ...] = ()
    integer: sp.Symbol | None = None
    needs: tuple[Any, ...] = ()
    nonzero: tuple[sp.Expr, ...] = ()
    known: Mapping[Any, Any] = field(default_factory=dict)
    shown: tuple[tuple[Any, Any], ...] = ()


def toward(argument: Any, value: sp.Expr, **facts: Any) -> Outcome:
    """Return the outcome argument = value: the value of an unknown where the argument is one."""
    shown = ((argument, value),)
    if argument.is_Symbol:
        return Outcome({argument: value}, shown=shown, **facts)
    return Outcome(equations=(argument - value,), shown=shown, **facts)


@dataclass(frozen=True)
class Branch:
    """A case: expressions that are still to be zero, what is found, whole numbers in it, and what must hold."""

    equations: tuple[sp.Expr, ...]
    found: Point = field(default_factory=dict)
    integers: tuple[sp.Symbol, ...] = ()
    needs: tuple[Any, ...] = ()
    nonzero: tuple[sp.Expr, ...] = ()
    case: tuple[int, ...] = ()
    eliminated: bool = False
    searched: bool = False


@dataclass(frozen=True)
class Roots:
    """All real solutions: `points` in their order, the `moves` that led to them, `needs` of each point.

    `searched` are the boxes in which solutions were searched by numbers; `certain` tells whether intervals prove that
    there are no others in them.
    """

    points: tuple[Point, ...]
    moves: tuple[Move, ...]
    needs: tuple[tuple[Any, ...], ...] = ()
    searched: tuple[Mapping[sp.Symbol, tuple[Any, Any]], ...] = ()
    certain: bool = True


def integer_names(taken: Iterable[str]) -> Iterable[sp.Symbol]:
    """Yield symbols of whole numbers: n, m, n1, n2, ..., none of them a name that is taken."""
    known = set(taken)
    names = ["n", "m", *(f"n{i}" for i in range(1, 40))]
    return (sp.Symbol(name, integer=True) for name in names if name not in known)
