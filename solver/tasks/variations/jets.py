"""The functions of a functional with their derivatives and variations, as symbols."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.jets import jet_symbol
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional


def jets_of(system: Functional, name: str) -> list[Symbol]:
    """Return a function and its derivatives up to the highest that occurs, the function first."""
    return [system.symbol((name, k)) for k in range(system.orders.get(name, 0) + 1)]


def following(system: Functional) -> dict[Symbol, Expr]:
    """Return the derivative of everything that varies with time: of t, of functions, multipliers and derivatives."""
    highest = 2 * max([1, *system.orders.values()])
    names = (*system.functions, *system.multipliers[: len(system.constraints)])
    moving = {system.symbol((name, k)): system.symbol((name, k + 1)) for name in names for k in range(highest + 1)}
    return {system.t: sp.S.One, **moving}


def variations(system: Functional) -> dict[Symbol, Symbol]:
    """Return the variation of each function and derivative: dx of x, dx_dot of x_dot."""
    return {
        system.symbol((name, k)): jet_symbol((f"d{name}", k))
        for name in system.functions
        for k in range(system.orders[name] + 1)
    }
