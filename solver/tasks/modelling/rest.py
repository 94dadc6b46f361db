"""Constant solutions of a system: what its equations are where nothing changes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.modelling.first_order import first_order_of, highest_in, result_of

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.systems import Equations
    from solver.tasks.modelling.first_order import FirstOrder


@dataclass(frozen=True, slots=True)
class Rest:
    """Sides of the equations at rest; `states` in their order, `zero` those that are derivatives.

    `hidden` are unknowns without a derivative, which are no states; of discrete time `same` are samples of states and
    what they are equal to. `leading` are the factors of the highest derivatives, a row for each equation, where they
    depend on the unknowns: what the equations tell of the motion, they tell where this matrix is regular.
    """

    sides: tuple[tuple[Expr, Expr], ...]
    states: tuple[Symbol, ...]
    inputs: tuple[Symbol, ...]
    zero: tuple[Symbol, ...]
    hidden: tuple[Symbol, ...]
    same: tuple[tuple[Symbol, Symbol], ...] = ()
    leading: ImmutableMatrix | None = None
    highest: tuple[Symbol, ...] = ()

    @property
    def equations(self) -> list[Expr]:
        """Expressions that are zero."""
        equal = [a - b for a, b in self.same]
        return [*self.zero, *equal, *(left - right for left, right in self.sides if left != right)]


def at_rest(model: Equations, inputs: Mapping[str, Any]) -> Rest:
    """Return the equations of a system in which nothing changes, with these values of inputs."""
    first = _first_order(model)
    states = first.states if first is not None else _usual(model)
    later = {s: (name, k) for s, (name, k) in model.jets.items() if k}
    if model.discrete:
        put: dict[Any, Any] = {s: model.symbol((name, 0)) for s, (name, _) in later.items()}
    else:
        put = dict.fromkeys(later, sp.Integer(0))
    values = {model.symbol((name, 0)): value for name, value in inputs.items()}
    sides = tuple((_put(left, put, values), _put(right, put, values)) for left, right in model.sides)
    symbols = tuple(model.symbol(jet) for jet in states)
    moving = [(model.symbol((name, k)), model.symbol((name, 0))) for name, k in states if k]
    same = tuple((x, own) for x, own in moving) if model.discrete else ()
    base = {name for name, _ in states}
    hidden = tuple(model.symbol((name, 0)) for name in model.unknowns if (name, 0) not in states)
    hidden = tuple(x for x in hidden if any(x in side.free_symbols for pair in sides for side in pair)
                   or str(x) in base)  # fmt: skip
    wanted = highest_in(first.model) if first is not None else ()
    return Rest(
        sides, symbols, tuple(model.symbol((name, 0)) for name in model.inputs),
        () if model.discrete else tuple(x for x, _ in moving), hidden, same,
        _leading(first, wanted, put, values) if first is not None else None, wanted,
    )  # fmt: skip


def _leading(
    first: FirstOrder, wanted: tuple[Symbol, ...], put: Mapping[Any, Any], values: Mapping[Any, Any]
) -> ImmutableMatrix | None:
    """The factors of the highest derivatives at rest; None where no unknown is in them."""
    factors, _ = exact.coefficients_of([left - right for left, right in first.model.sides], wanted)
    inside = {symbol for symbol, (name, _) in first.model.jets.items() if name in first.model.functions}
    if factors.free_symbols.isdisjoint(inside):
        return None
    later = {symbol: first.model.symbol((name, 0)) if first.model.discrete else sp.Integer(0)
             for symbol, (name, k) in first.model.jets.items() if k}  # fmt: skip
    found: ImmutableMatrix = factors.xreplace({**later, **put}).xreplace(dict(values))
    return found


def _put(side: Expr, put: Mapping[Any, Any], values: Mapping[Any, Any]) -> Expr:
    """A side with derivatives and inputs in place; derivatives first, so that those of inputs are zero."""
    found: Expr = side.xreplace(dict(put)).xreplace(dict(values))
    return found


def _first_order(model: Equations) -> FirstOrder | None:
    """The state equations, where there are any."""
    try:
        return result_of(first_order_of(model))
    except Unsolved:
        return None


def _usual(model: Equations) -> tuple[tuple[str, int], ...]:
    """The states by the derivatives that occur."""
    orders = {name: max(k for n, k in model.jets.values() if n == name) for name, _ in model.jets.values()}
    usual = tuple((name, k) for name in model.unknowns for k in range(max(orders.get(name, 0), 1)))
    return model.states or usual
