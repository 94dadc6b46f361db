"""The products of a Riccati equation and of its gain worked out, for a regulator or a filter."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.design.regulator import Regulator

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.derivation import Step

LARGEST = 3
"""Products with larger matrices of unknowns fill the page."""


@where_exact
def products_of_the_equation(problem: Regulator, P: ImmutableMatrix) -> tuple[Step, ...]:
    """AᵀP, whose transpose is PA; BᵀP; P B R⁻¹ times BᵀP."""
    if P.rows > LARGEST:
        return ()
    names, At, Bt = problem.names, problem.A.T, problem.B.T
    seen = _expanded(Bt * P)
    if problem.discrete:
        applied = _expanded(P * problem.A)
        return (
            *_multiplied(P, problem.A, f"P{names['A']}"),
            *_multiplied(At, applied, f"{names['At']}P{names['A']}"),
            *_multiplied(Bt, P, f"{names['Bt']}P"),
            *_multiplied(seen, problem.B, f"{names['Bt']}P{names['B']}"),
            *_multiplied(seen, problem.A, f"{names['Bt']}P{names['A']}"),
        )
    weighted = _expanded(P * exact.weighted_transpose(problem.B, problem.R).T)
    return (
        *_multiplied(At, P, f"{names['At']}P"),
        *_multiplied(Bt, P, f"{names['Bt']}P"),
        *_multiplied(weighted, seen, f"P{names['B']}R^{{-1}}{names['Bt']}P"),
    )


@where_exact
def products_of_the_gain(problem: Regulator, P: ImmutableMatrix) -> tuple[Step, ...]:
    """BᵀP and R⁻¹ times it (with a cross weight times BᵀP + Nᵀ); for a filter PCᵀ and that times R⁻¹."""
    Bt = problem.Bt
    first = _expanded(Bt * P)
    if problem.discrete:
        return _products_of_the_discrete_gain(problem, P, first)
    R = exact.inverse(problem.R)
    if problem.dual:
        return (*_multiplied(P, problem.B, f"P{problem.names['B']}"), *_multiplied(first.T, R, ""))
    whole = first if problem.N is None else _expanded(first + problem.N.T)
    return (*_multiplied(Bt, P, f"{problem.names['Bt']}P"), *_multiplied(R, whole, ""))


def _products_of_the_discrete_gain(problem: Regulator, P: ImmutableMatrix, first: ImmutableMatrix) -> tuple[Step, ...]:
    """BᵀP, BᵀPB and BᵀPA."""
    names = problem.names
    return (
        *_multiplied(problem.Bt, P, f"{names['Bt']}P"),
        *_multiplied(first, problem.B, f"{names['Bt']}P{names['B']}"),
        *_multiplied(first, problem.A, f"{names['Bt']}P{names['A']}"),
    )


@where_exact
def products_of_a_form(x: ImmutableMatrix, P: ImmutableMatrix, names: tuple[str, str]) -> tuple[Step, ...]:
    """P x and xᵀ times it; `names` are those of the products."""
    return (*_multiplied(P, x, names[0]), *_multiplied(x.T, _expanded(P * x), names[1]))


def _multiplied(left: Any, right: Any, name: str) -> tuple[Step, ...]:
    return multiplied(sp.ImmutableMatrix(left), sp.ImmutableMatrix(right), _expanded(left * right), name)


def _expanded(M: Any) -> ImmutableMatrix:
    return sp.ImmutableMatrix(M.applyfunc(sp.expand))
