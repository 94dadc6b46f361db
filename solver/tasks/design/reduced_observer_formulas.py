"""How the matrices of an observer of reduced order follow from each other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.design.mapped_poles import exact_poles_in_z
from solver.tasks.design.plants import measuring

if TYPE_CHECKING:
    from solver.derivation import Given
    from solver.tasks.design.reduced_observer import ReducedObserverOptions
    from solver.tasks.needed import WithInput

    Asked = Given[WithInput, ReducedObserverOptions]

Found = Mapping[str, Any]


def block(name: str, given: Asked, found: Found) -> Any:
    """The block A11, …, B2 of T⁻¹AT or T⁻¹B."""
    plant, T = measuring(given.system, given.options.measured), found["T"]
    halves = {"1": slice(None, plant.p), "2": slice(plant.p, None)}
    if name[0] == "B":
        return sp.ImmutableMatrix((T.inv() * plant.B)[halves[name[1]], :])
    return sp.ImmutableMatrix((T.inv() * plant.A * T)[halves[name[1]], halves[name[2]]])


def gain_for_the_pair(given: Asked, found: Found) -> Any:
    """L for the poles of A22 − L A12, where there is one measured output and so only one gain."""
    A22, A12 = found["A22"], found["A12"]
    poles = exact_poles_in_z(given)
    if A12.rows != 1 or len(poles) != A22.rows:
        return None
    K = exact.ackermann(A22.T, A12.T, exact.monic(poles))
    return sp.ImmutableMatrix(K.T)


def error_matrix(_given: Asked, found: Found) -> Any:
    """J = A22 − L A12."""
    return sp.ImmutableMatrix(found["A22"] - found["L"] * found["A12"])


def gain_of_the_output(_given: Asked, found: Found) -> Any:
    """N = A21 − L A11 + J L."""
    return sp.ImmutableMatrix(found["A21"] - found["L"] * found["A11"] + found["J"] * found["L"])


def gain_of_the_input(given: Asked, found: Found) -> Any:
    """M = B2 − L B1 − N D."""
    D = measuring(given.system, given.options.measured).D
    return sp.ImmutableMatrix(found["B2"] - found["L"] * found["B1"] - found["N"] * D)


def combined_matrix(given: Asked, found: Found) -> Any:
    """[[A, 0], [N C, J]]."""
    plant, J = measuring(given.system, given.options.measured), found["J"]
    return sp.ImmutableMatrix(sp.Matrix([[plant.A, sp.zeros(plant.n, J.rows)], [found["N"] * plant.C, J]]))


def combined_input(given: Asked, found: Found) -> Any:
    """[B; M + N D]."""
    plant = measuring(given.system, given.options.measured)
    return sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(plant.B), sp.Matrix(found["M"] + found["N"] * plant.D)))
