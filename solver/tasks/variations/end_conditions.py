"""Lemma: what holds at the ends of an extremal: given values, natural conditions, transversality."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, total
from solver.systems.ends import End

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.systems import Functional
    from solver.tasks.variations.euler_equations import Stationary


@dataclass(frozen=True)
class Condition:
    """`left` = `right` at a time, in the functions and their derivatives there; or an integral of `left` over all time.

    `kind` is "value", "natural", "curve", "time" or "integral".
    """

    kind: str
    left: Expr
    right: Expr
    time: Expr


@dataclass(frozen=True)
class Place:
    """A function or a derivative at one end: what is asked there, what stands beside its variation, its derivative."""

    name: str
    order: int
    time: Expr
    last: bool
    end: End
    momentum: Expr
    symbol: Symbol
    rate: Symbol


def places(found: Stationary) -> Iterator[Place]:
    """Yield what varies at the ends: of a function of order m its derivatives below m, at the first and last time."""
    system = found.system
    for name, derivative in found.by_name.items():
        for k, momentum in enumerate(derivative.momenta):
            pair = system.ends.get((name, k), (End(), End()))
            for last, (time, end) in enumerate(zip((system.start, system.end_time), pair, strict=True)):
                yield Place(
                    name, k, time, bool(last), end, momentum, system.symbol((name, k)), system.symbol((name, k + 1))
                )


def is_open(system: Functional) -> bool:
    """Whether nothing is said of the ends, so that the general solution is asked for."""
    return not (system.ends or system.terminal_cost != 0 or system.stop is None or system.integral_constraints)


@lemma("end_conditions")
def end_conditions_of(found: Stationary) -> Derivation[list[Condition]]:
    """The conditions that fix the constants: given values first, then what the variation of free ends asks."""
    system = found.system
    listed = list(places(found))
    conditions = [Condition("value", symbol, value, time) for symbol, time, value in system.fixed]
    for place in listed:
        if place.end.free:
            conditions.append((yield from _natural(system, place)))
    curves = [place for place in listed if place.end.curve is not None]
    conditions += [Condition("curve", place.symbol, _curve(place), place.time) for place in curves]
    if system.stop is None:
        conditions.append((yield from _transversality(found, listed)))
    conditions += [
        Condition("integral", each.integrand, each.value, system.end_time) for each in system.integral_constraints
    ]
    return conditions


def _curve(place: Place) -> Expr:
    assert place.end.curve is not None  # noqa: S101 - asked of those that end on one
    return place.end.curve


def _jets(system: Functional) -> list[Symbol]:
    """The derivatives that may stand in a condition, the highest first."""
    highest = 2 * max(system.orders.values())
    return [system.symbol((name, k)) for k in reversed(range(highest + 1)) for name in system.functions]


@lemma("end_conditions")
def _natural(system: Functional, place: Place) -> Derivation[Condition]:
    """What stands beside the variation of a free end vanishes."""
    cost = sp.diff(system.terminal_cost, place.symbol) if place.last else sp.S.Zero
    whole = sp.Add(place.momentum, cost)
    left = exact.cleared(whole, _jets(system)).left if whole != 0 else whole
    yield Step("natural", unclaimed="the variation there is arbitrary", symbol=place.symbol, time=place.time,
               momentum=place.momentum, cost=cost, with_cost=place.last and system.terminal_cost != 0, left=left,
               highest=place.order == system.orders[place.name] - 1,
               derivative=place.rate, stands=_with_cost(place.momentum, cost),
               adjoined=bool(system.multipliers))  # fmt: skip
    return Condition("natural", left, sp.S.Zero, place.time)


def _with_cost(momentum: Expr, cost: Expr) -> Any:
    return total(momentum, cost) if cost != 0 and momentum != 0 else sp.Add(momentum, cost)


@lemma("end_conditions")
def _transversality(found: Stationary, listed: list[Place]) -> Derivation[Condition]:
    """φ − Σ p x' + ∂h/∂t + Σ (p + ∂h/∂x) θ' = 0 at the free time."""
    system, t = found.system, found.system.t
    terms: list[Any] = [found.phi]
    for place in (place for place in listed if place.last and place.momentum != 0):
        slope = sp.S.Zero if place.end.curve is None else sp.diff(place.end.curve, t)
        terms.append(product(_stated_slope(slope, place.rate), place.momentum))
    cost = [sp.diff(system.terminal_cost, t)]
    for place in (place for place in listed if place.last and place.end.curve is not None):
        cost.append(sp.diff(system.terminal_cost, place.symbol) * sp.diff(place.end.curve, t))
    terms += [each for each in cost if each != 0]
    whole = _value(found, listed) + sp.Add(*cost)
    tidy = sp.factor(sp.together(whole))
    left = exact.cleared(tidy, _jets(system)).left if tidy != 0 else tidy
    curves = [
        (place.symbol, place.end.curve, sp.diff(place.end.curve, t)) for place in listed if place.end.curve is not None
    ]
    yield Step("transversality", claims={"time": Claim(_total(terms), tidy, "transversality at the free time")},
               left=left, curves=curves, time=system.end_time, with_cost=system.terminal_cost != 0,
               differs=left != tidy, several=len(system.functions) > 1, adjoined=bool(system.multipliers),
               order=max(system.orders.values()))  # fmt: skip
    return Condition("time", left, sp.S.Zero, system.end_time)


def _value(found: Stationary, listed: list[Place]) -> Expr:
    """The same without the terminal cost, as an expression."""
    whole: Expr = found.phi
    for place in (place for place in listed if place.last):
        slope = sp.S.Zero if place.end.curve is None else sp.diff(place.end.curve, found.system.t)
        whole += (slope - place.rate) * place.momentum
    return whole


def _stated_slope(slope: Expr, rate: Symbol) -> Any:
    return difference(slope, rate) if slope != 0 else product(-1, rate)


def _total(terms: list[Any]) -> Any:
    kept = [term for term in terms if not (isinstance(term, sp.Expr) and term == 0)]
    return total(*kept) if len(kept) > 1 else kept[0] if kept else sp.S.Zero
