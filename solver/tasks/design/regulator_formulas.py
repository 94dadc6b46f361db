"""How the answers about a linear quadratic regulator follow from each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import Given
from solver.lazy import sympy as sp
from solver.tasks.design.weights import cost_factor, weights_as_stated

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol

    from solver.tasks.design.lqr import LqrOptions
    from solver.tasks.needed import WithInput


def states_of(given: Given[WithInput, LqrOptions]) -> list[Symbol]:
    """The symbols of the states: their names, or x1, x2, …."""
    names = given.system.state_names or tuple(f"x{i + 1}" for i in range(given.system.order))
    return [sp.Symbol(name) for name in names]


def initial_state_of(given: Given[WithInput, LqrOptions]) -> ImmutableMatrix | None:
    """Where the motion starts: the option, or what the system says."""
    x0: ImmutableMatrix | None = (
        given.options.initial_state if given.options.initial_state is not None else given.system.x0
    )
    return x0


def gain_of_the_solution(given: Given[WithInput, LqrOptions], found: Mapping[str, Any]) -> Any:
    """K = R⁻¹(BᵀP + Nᵀ), in discrete time (R + BᵀPB)⁻¹(BᵀPA + Nᵀ)."""
    N, R = given.options.N, weights_as_stated(given)[1]
    return gain_of(given.system.A, given.system.B, R, found["P"], N, discrete=given.system.discrete)


def gain_of(
    A: ImmutableMatrix, B: ImmutableMatrix, R: ImmutableMatrix, P: Any, N: Any = None, *, discrete: bool
) -> ImmutableMatrix:
    """The gain (m×n) that a matrix P gives, whatever it solves."""
    cross = N.T if N is not None else sp.zeros(*B.T.shape)
    weight, seen = (R + B.T * P * B, B.T * P * A) if discrete else (R, B.T * P)
    return sp.ImmutableMatrix(sp.Matrix(weight).LUsolve(sp.Matrix(seen + cross)))


def gains_by_the_weight_alone(given: Given[WithInput, LqrOptions], P: Any) -> Iterator[Any]:
    """R⁻¹(BᵀPA + Nᵀ) of discrete time, where P is known and R has an inverse."""
    N, R, B = given.options.N, weights_as_stated(given)[1], given.system.B
    if given.system.discrete and P is not None and R.rank() == R.rows:
        cross = N.T if N is not None else sp.zeros(*B.T.shape)
        yield sp.ImmutableMatrix(sp.Matrix(R).LUsolve(sp.Matrix(B.T * P * given.system.A + cross)))


def gains_without_the_plant(given: Given[WithInput, LqrOptions], P: Any) -> Iterator[Any]:
    """(R + BᵀPB)⁻¹BᵀP of discrete time, where P is known."""
    if given.system.discrete and P is not None and given.options.N is None:
        one = sp.ImmutableMatrix(sp.eye(given.system.order))
        yield gain_of(one, given.system.B, weights_as_stated(given)[1], P, discrete=True)


def law_of_the_gain(given: Given[WithInput, LqrOptions], found: Mapping[str, Any]) -> Any:
    """u = −K x."""
    control = sp.ImmutableMatrix(-found["K"] * sp.Matrix(states_of(given)))
    return control[0, 0] if control.rows == 1 else control


def cost_of_the_solution(given: Given[WithInput, LqrOptions], found: Mapping[str, Any]) -> Any:
    """x(0)ᵀP x(0), times the factor before the integral."""
    x0 = initial_state_of(given)
    return None if x0 is None else sp.expand((x0.T * found["P"] * x0)[0, 0] * cost_factor(given.options))
