"""A realization completed: A, B or C from the two others, by the Markov parameters of the transfer function."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import permutations
from typing import TYPE_CHECKING, Any

from solver.lazy import exact, systems
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Given, Task

Found = Mapping[str, Any]

MOST_STATES = 4
"""Orders of more states are not tried."""


def register(task: Task[Any, Any]) -> None:
    """Register the formulas for A, B and C of a task whose answers realize the system given."""
    task.consequence("C", of=("A", "B"), symbolic=False, completing=True)(output_matrix)
    task.consequence("B", of=("A", "C"), symbolic=False, completing=True)(input_matrix)
    task.consequence("A", of=("B", "C"), symbolic=False, completing=True)(system_matrix)


def output_matrix(given: Given[Any, Any], found: Found) -> Any:
    """C with C [B, AB, …] = [h₁, h₂, …]; None where (A, B) is complex or not controllable."""
    if found["A"].has(sp.I) or found["B"].has(sp.I):
        return None
    reached = exact.controllability_matrix(found["A"], found["B"])
    wanted = sp.Matrix.hstack(*markov_parameters(given.system, found["A"].rows))
    gram = sp.ImmutableMatrix(reached * reached.T)
    return None if exact.is_singular(gram) else sp.ImmutableMatrix(wanted * reached.T * exact.inverse(gram))


def input_matrix(given: Given[Any, Any], found: Found) -> Any:
    """B with [C; CA; …] B = [h₁; h₂; …]; None where (A, C) is complex or not observable."""
    if found["A"].has(sp.I) or found["C"].has(sp.I):
        return None
    seen = sp.ImmutableMatrix(exact.controllability_matrix(found["A"].T, found["C"].T).T)
    wanted = sp.Matrix.vstack(*markov_parameters(given.system, found["A"].rows))
    gram = sp.ImmutableMatrix(seen.T * seen)
    return None if exact.is_singular(gram) else sp.ImmutableMatrix(exact.inverse(gram) * seen.T * wanted)


def system_matrix(given: Given[Any, Any], found: Found) -> Any:
    """The A that is known, with its states in the order of B and C; None where there is no such order."""
    A, B, C = found["A"], found["B"], found["C"]
    n = A.rows
    wanted = markov_parameters(given.system, 2 * n)
    if n > MOST_STATES:
        return None
    for order in permutations(range(n)):
        M = A.extract(list(order), list(order))
        if all(
            (C * power * B - h).expand().is_zero_matrix for power, h in zip(exact.powers(M, 2 * n), wanted, strict=True)
        ):
            return sp.ImmutableMatrix(M)
    return None


def markov_parameters(system: Any, count: int) -> list[Any]:
    """h₁ … of G = D + h₁/x + h₂/x² + …: C A^{k−1} B, or by division of the fractions (p×m each)."""
    if not isinstance(system, systems.TransferFunction):
        powers = exact.powers(system.A, count)
        return [sp.ImmutableMatrix(system.C * power * system.B) for power in powers]
    series = [
        [_divided(p, q, system.variable, count) for p, q in zip(*row, strict=True)]
        for row in zip(system.numerators, system.denominators, strict=True)
    ]
    return [sp.ImmutableMatrix([[entry[k] for entry in row] for row in series]) for k in range(1, count + 1)]


def _divided(numerator: Any, denominator: Any, x: Any, count: int) -> list[Any]:
    """The coefficients of x⁰, x⁻¹, … x⁻ᶜᵒᵘⁿᵗ of a proper fraction."""
    bottom = sp.Poly(denominator, x).all_coeffs()
    top = sp.Poly(numerator, x).all_coeffs()
    rest = [sp.Integer(0)] * (len(bottom) - len(top)) + top + [sp.Integer(0)] * count
    found = []
    for k in range(count + 1):
        found.append(rest[k] / bottom[0])
        for i, c in enumerate(bottom):
            rest[k + i] -= found[-1] * c
    return found
