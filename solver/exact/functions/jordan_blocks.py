"""Functions of a matrix in Jordan form: f(λ), f′(λ), f″(λ)/2!, … from the diagonal of each block outwards.

Source: F. R. Gantmacher, The Theory of Matrices I, V §1.
"""

from __future__ import annotations

from math import factorial

import sympy as sp

from solver.exact.functions.scalar_functions import ScalarFunction
from solver.exact.linear_algebra.eigen import Eigenstructure


def exponential_of_blocks(structure: Eigenstructure, t: sp.Symbol) -> sp.ImmutableMatrix:
    """e^{Jt} (n×n), with t^d/d! e^{λt} on the d-th diagonal of a block."""
    return structure.of_blocks(lambda value, d: t**d / factorial(d) * sp.exp(value * t))


def power_of_blocks(structure: Eigenstructure, k: sp.Symbol) -> sp.ImmutableMatrix:
    """Jᵏ (n×n), k = 0, 1, …, with C(k, d) λ^{k−d} on the d-th diagonal of a block; for λ = 0 a pulse at k = d."""
    return structure.of_blocks(
        lambda value, d: sp.KroneckerDelta(k, d) if value == 0 else sp.ff(k, d) / factorial(d) * value ** (k - d)
    )


def function_of_blocks(structure: Eigenstructure, f: ScalarFunction) -> sp.ImmutableMatrix:
    """f(J) (n×n), with f⁽ᵈ⁾(λ)/d! on the d-th diagonal of a block; raises NotExact where there is no derivative."""
    if f.power_exponent is not None:
        return power_of_blocks(structure, f.power_exponent)
    return structure.of_blocks(lambda value, d: f.at(value, d) / factorial(d))
