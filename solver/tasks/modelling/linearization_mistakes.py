"""Usual mistakes with linear models: another point, rules of differentiation forgotten."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.modelling.equation_mistakes import at_the_origin, half_a_turn_away, name_mistakes
from solver.tasks.modelling.first_order import first_order_of, result_of
from solver.tasks.modelling.operating_point import operating_point_of

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.derivation import Task
    from solver.systems import Equations
    from solver.tasks.modelling.linearization import LinearizationOptions

OTHER_POINT = Slip("other_point", "it is the linear model about another equilibrium, half a turn away")
ORIGIN = Slip("other_point", "it is the linear model about the origin")
PRODUCT = Slip("product_rule", "the product rule is forgotten: only one factor is differentiated")
QUOTIENT = Slip("quotient_rule", "the denominator is not differentiated")


def register(task: Task[Equations, LinearizationOptions]) -> None:
    """Register what goes wrong with linear models."""
    task.mistake(OTHER_POINT, "A", "B")(about_another_equilibrium)
    task.mistake(ORIGIN, "A", "B")(about_the_origin)
    task.mistake(PRODUCT, "A")(one_factor_differentiated)
    task.mistake(QUOTIENT, "A", "B")(denominator_kept)
    name_mistakes(task, at_a_point=True)


def about_another_equilibrium(attempt: Attempt[Equations, LinearizationOptions]) -> Iterable[Any]:
    """The Jacobians half a turn away."""
    changed = half_a_turn_away(attempt.given.system, attempt.given.options)
    if changed:
        yield from _jacobian(attempt, changed[1].at, sp.diff)


def about_the_origin(attempt: Attempt[Equations, LinearizationOptions]) -> Iterable[Any]:
    """The Jacobians where all that is given is zero."""
    changed = at_the_origin(attempt.given.system, attempt.given.options)
    if changed:
        yield from _jacobian(attempt, changed[1].at, sp.diff)


def one_factor_differentiated(attempt: Attempt[Equations, LinearizationOptions]) -> Iterable[Any]:
    """∂f/∂x with one factor of each product differentiated, the first or the last that x stands in."""
    yield from _jacobian(attempt, attempt.given.options.at or {}, _one_factor(0))
    yield from _jacobian(attempt, attempt.given.options.at or {}, _one_factor(-1))


def denominator_kept(attempt: Attempt[Equations, LinearizationOptions]) -> Iterable[Any]:
    """(∂N/∂x)/D for ∂f/∂x."""

    def of_numerator(f: Expr, x: Symbol) -> Expr:
        above, below = sp.fraction(f, exact=True)
        found: Expr = sp.diff(above, x) / below
        return found

    yield from _jacobian(attempt, attempt.given.options.at or {}, of_numerator)


def _one_factor(which: int) -> Callable[[Expr, Symbol], Expr]:
    def partial(f: Any, x: Symbol) -> Any:
        if f.is_Add:
            return sp.Add(*(partial(term, x) for term in f.args))
        inside = [factor for factor in f.args if factor.has(x)] if f.is_Mul else []
        return f / inside[which] * sp.diff(inside[which], x) if len(inside) > 1 else sp.diff(f, x)

    return partial


def _jacobian(
    attempt: Attempt[Equations, LinearizationOptions], at: Mapping[Any, Any], partial: Callable[[Expr, Symbol], Expr]
) -> Iterator[Any]:
    """The Jacobian at a point by a rule of differentiation; nothing where it has none."""
    with suppress(exact.NotDifferentiable, Unsolved):
        found = result_of(first_order_of(attempt.given.system))
        point = result_of(operating_point_of(found, at))
        variables = found.X if attempt.name == "A" else found.U
        rows = [[exact.put_in(partial(f, x), point.values) for x in variables] for f in found.f]
        yield sp.ImmutableMatrix(rows)
