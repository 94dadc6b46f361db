"""Energies to equations of motion, for every question about equations."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import Derivation
from solver.derivation.conversion import Provided, conversion
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.systems import Equations, Lagrangian
from solver.tasks.modelling.euler_lagrange import Motion, equations_of_motion_of

if TYPE_CHECKING:
    from sympy import Expr


def _gives(has: Provided) -> Iterable[str]:
    """Equations; inputs and initial values where the energies have them."""
    own = (each for each in ("inputs", "initial_state") if each in has)
    return ("equations", "rest", "machine", *own) if "lagrangian" in has else ()


@conversion(Lagrangian, Equations, gives=_gives)
def by_euler_lagrange(system: Lagrangian) -> Derivation[Equations]:
    """The equation of each coordinate and the constraints; multipliers, and coordinates these give, are algebraic."""
    motion = yield from equations_of_motion_of(system)
    return equations_of(system, motion)


def equations_of(system: Lagrangian, motion: Motion) -> Equations:
    """Return the equations, with their terms in the order of a book."""
    terms = [(each.terms, _terms(each.force)) for each in motion.equations]
    terms += [(_terms(each), ()) for each in system.constraints]
    sides = tuple((sp.Add(*left), sp.Add(*right)) for left, right in terms)
    unknowns = (*system.coordinates, *system.multipliers)
    inside = set().union(
        *(side.free_symbols for pair in sides for side in pair), *(y.free_symbols for y in system.outputs)
    )
    known = {jet_symbol((name, k)): (name, k) for name in (*unknowns, *system.inputs) for k in range(4)}
    return Equations(
        sides, unknowns, (*_given_by_constraints(system), *system.multipliers), system.inputs, system.states,
        system.outputs, system.initial, {symbol: jet for symbol, jet in known.items() if symbol in inside},
        written=tuple(terms),
    ).assuming(system.assumed)  # fmt: skip


def _terms(expression: Expr) -> tuple[Expr, ...]:
    return tuple(term for term in sp.Add.make_args(expression) if term != 0)


def _given_by_constraints(system: Lagrangian) -> tuple[str, ...]:
    """For each constraint a coordinate that it gives, linear in it; none where one of them gives none."""
    states = {name for name, _ in system.states} | {name for name, _ in system.initial}
    chosen: list[str] = []
    for constraint in system.constraints:
        free = [name for name in system.coordinates if name not in states and name not in chosen]
        linear = (name for name in free if _is_constant(sp.diff(constraint, jet_symbol((name, 0))), system))
        if (found := next(linear, None)) is None:
            return ()
        chosen.append(found)
    symbols = [jet_symbol((name, 0)) for name in chosen]
    return tuple(chosen) if exact.are_linear_in(list(system.constraints), symbols) else ()


def _is_constant(coefficient: Expr, system: Lagrangian) -> bool:
    return bool(coefficient != 0) and not coefficient.free_symbols & set(system.jets)
