"""Usual mistakes with extremals: the equation of Euler and Lagrange, and what holds at ends that are not fixed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip, Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.systems import Functional
from solver.systems.ends import End
from solver.tasks.modelling.first_order import result_of
from solver.tasks.variations.constants import fitted_of
from solver.tasks.variations.end_conditions import Condition, end_conditions_of, is_open
from solver.tasks.variations.euler_equations import Stationary, adjoined_of, euler_equations_of
from solver.tasks.variations.first_integrals import general_solution_of
from solver.tasks.variations.jets import following

if TYPE_CHECKING:
    from sympy import Expr, Symbol

    from solver.derivation import Task
    from solver.systems import System
    from solver.tasks.variations.extremal import ExtremalOptions

    Tried = Attempt[Functional, ExtremalOptions]
    Rate = Callable[[Expr, Mapping[Symbol, Expr], Symbol], Expr]

SIGN = Slip(
    "euler_sign",
    "a sign is wrong in the equation of Euler and Lagrange: it is "
    r"$\frac{\partial\varphi}{\partial x} - \frac{d}{dt}\frac{\partial\varphi}{\partial\dot{x}} = 0$",
)
TOTAL = Slip(
    "total_derivative",
    r"$\frac{d}{dt}\frac{\partial\varphi}{\partial\dot{x}}$ is taken as a partial derivative: "
    "everything in it varies with time, by the chain rule",
)
COST = Slip("terminal_cost", "the terminal cost is forgotten in the condition at the end")
FREE = Slip("free_end", "the free end is given a value: nothing is asked there but the natural condition")
CURVE = Slip("transversality", "the natural condition of a free end is used in place of transversality")


def register(task: Task[Functional, ExtremalOptions]) -> None:
    """Register what goes wrong with extremals."""
    task.mistake(SIGN, "equations", "x")(with_the_other_sign)
    task.mistake(TOTAL, "equations", "x")(with_partial_derivatives)
    task.mistaken_question(COST)(without_terminal_cost)
    task.mistaken_question(FREE)(with_the_end_at_zero)
    task.mistake(CURVE, "x", "t_f")(with_the_natural_condition)


def with_the_other_sign(attempt: Tried) -> Iterable[Any]:
    """∂φ/∂x + d/dt ∂φ/∂x' = 0."""
    found = _stationary(attempt.given.system)
    wrong = [
        each.derivative.partials[0] - sum((-1) ** k * chain[-1] for k, chain in enumerate(each.derivative.rates) if k)
        for each in found.equations
    ]
    yield from _led_to(attempt, found, wrong)


def with_partial_derivatives(attempt: Tried) -> Iterable[Any]:
    """d/dt ∂φ/∂x' with t alone varying, or all but t, or the highest derivative alone."""
    found = _stationary(attempt.given.system)
    for rate in (_by_time, _without_time, _of_the_highest):
        moves, wrong = following(found.system), []
        for each in found.equations:
            terms = [each.derivative.partials[0]]
            for k, partial in enumerate(each.derivative.partials):
                taken = partial
                for _ in range(k):
                    taken = rate(taken, moves, found.system.t)
                terms += [(-1) ** k * taken] if k else []
            wrong.append(sp.Add(*terms))
        yield from _led_to(attempt, found, wrong)


def _by_time(value: Expr, _moves: Mapping[Symbol, Expr], t: Symbol) -> Expr:
    return sp.diff(value, t)


def _without_time(value: Expr, moves: Mapping[Symbol, Expr], t: Symbol) -> Expr:
    return exact.time_derivative(value, {q: rate for q, rate in moves.items() if q != t})


def _of_the_highest(value: Expr, moves: Mapping[Symbol, Expr], t: Symbol) -> Expr:
    inside = [q for q in moves if q != t and value.has(q)]
    return exact.time_derivative(value, {q: moves[q] for q in inside[-1:]})


def without_terminal_cost(system: System, options: ExtremalOptions) -> tuple[Functional, ExtremalOptions] | None:
    """The functional without what is added at the end."""
    if not isinstance(system, Functional) or system.terminal_cost == 0:
        return None
    return replace(system, terminal_cost=sp.S.Zero), options


def with_the_end_at_zero(system: System, options: ExtremalOptions) -> tuple[Functional, ExtremalOptions] | None:
    """Free last ends with the value zero, at a given time."""
    if not isinstance(system, Functional) or system.stop is None:
        return None
    ends = {
        jet: (first, End(sp.S.Zero) if last.free and jet[1] == 0 else last)
        for jet, (first, last) in system.ends.items()
    }
    return None if ends == dict(system.ends) else (replace(system, ends=ends), options)


def with_the_natural_condition(attempt: Tried) -> Iterable[Any]:
    """∂φ/∂x' = 0 at the free time, where the end is given or lies on a curve."""
    system = attempt.given.system
    if system.stop is not None or len(system.functions) > 1:
        return
    found = _stationary(system)
    conditions = [each for each in result_of(end_conditions_of(found)) if each.kind != "time"]
    (derivative,) = found.by_name.values()
    conditions.append(Condition("natural", derivative.momenta[0], sp.S.Zero, system.end_time))
    for x, t_f in _extremals(found, conditions):
        yield t_f if attempt.name == "t_f" else x


def _stationary(system: Functional) -> Stationary:
    found: Stationary = result_of(euler_equations_of(result_of(adjoined_of(system))))
    return found


def _led_to(attempt: Tried, found: Stationary, wrong: Sequence[Expr]) -> Iterator[Any]:
    """The wrong equations, cleared or not, with either sign; or the extremals that they have."""
    jets = [found.system.symbol((name, k)) for k in range(5, -1, -1) for name in found.functions]
    cleared = [exact.cleared(each, jets).left for each in wrong]
    if cleared == [each.left for each in found.equations]:
        return
    if attempt.name == "equations":
        rest = found.expressions[len(cleared) :]
        for each in (cleared, wrong):
            yield [*each, *rest]
            yield [*(-equation for equation in each), *rest]
        return
    equations = tuple(replace(each, left=left) for each, left in zip(found.equations, cleared, strict=True))
    changed = replace(found, equations=equations)
    conditions = [] if is_open(found.system) else result_of(end_conditions_of(found))
    yield from (x for x, _ in _extremals(changed, conditions))


def _extremals(found: Stationary, conditions: Sequence[Condition]) -> Iterator[tuple[Any, Expr]]:
    """The functions that satisfy equations and conditions, each with its end."""
    try:
        families = result_of(general_solution_of(found))
        if is_open(found.system):
            return
        fitted = result_of(fitted_of(found, families, conditions))
    except (Unsolved, exact.NotExact):
        return
    names = found.system.functions
    for each in fitted:
        several = {found.system.symbol((name, 0)): each.functions[name] for name in names}
        yield (each.functions[names[0]] if len(names) == 1 else several), each.t_f
