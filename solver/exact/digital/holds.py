"""A plant between a hold of order zero and a sampler: Φ = e^{AT} and Γ = ∫₀ᵀ e^{Aτ} dτ B, for any A.

Γ as a function of T has the transform (sI − A)⁻¹ B/s, so that both come from residues (Åström, Wittenmark,
Computer-Controlled Systems, §2.3).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.exact.functions.closed_forms import closed_form, exponential
from solver.exact.functions.rational import resolvent_matrix
from solver.exact.functions.residues import MatrixPolynomial, residues_at
from solver.exact.linear_algebra.fields import Modulus, side_by_side
from solver.exact.linear_algebra.spectrum import DIGITS, Factor, Root


@dataclass(frozen=True)
class Held:
    """The matrices of x((k + 1)T) = Φ x(kT) + Γ u(kT), the input held; Γ is None without B."""

    Phi: sp.ImmutableMatrix
    Gamma: sp.ImmutableMatrix | None


@lru_cache(maxsize=16)
def zero_order_hold(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix | None, T: sp.Expr) -> Held:
    """Φ (n×n) and Γ (n×m) for a period T; raises NotExact where the spectrum of A has no usable form."""
    t = sp.Symbol("t")
    Phi = at_period(exponential(A, t).matrix, t, T)
    return Held(Phi, None if B is None else at_period(integral_of_exponential(A, B, t), t, T))


@lru_cache(maxsize=16)
def integral_of_exponential(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, t: sp.Symbol) -> sp.ImmutableMatrix:
    """∫₀ᵗ e^{Aτ} dτ B (n×m), by the residues of (sI − A)⁻¹ B/s."""
    found = resolvent_matrix(A)
    M, right = side_by_side(A, B)
    K = M.domain
    own = found.factors[0].modulus.domain
    numerator = MatrixPolynomial([N.convert_to(K) * right for N in found.numerator])
    chi = [K.zero, *(K.convert(c, own) for c in found.chi)]
    residues = [residues_at(numerator, chi, factor) for factor in _with_zero(found.factors, K)]
    return closed_form((A.rows, B.cols), residues, t, discrete=False).matrix


def _with_zero(factors: tuple[Factor, ...], K: Any) -> list[Factor]:
    """The factors over K, and s once more."""
    lifted = [
        Factor(Modulus(tuple(K.convert(c, each.modulus.domain) for c in each.modulus.low), K), each.multiplicity,
               each.roots)
        for each in factors
    ]  # fmt: skip
    zero = Modulus((K.zero,), K)
    others = [each for each in lifted if each.modulus != zero]
    power = next((each.multiplicity for each in lifted if each.modulus == zero), 0) + 1
    root = Root(sp.S.Zero, power, "rational", sp.S.Zero, sp.S.Zero)
    return [Factor(zero, power, (root,)), *others]


def at_period(M: sp.ImmutableMatrix, t: sp.Symbol, T: sp.Expr) -> sp.ImmutableMatrix:
    """A matrix of functions of time at t = T; decimals where these cannot be avoided."""
    found = M.xreplace({t: T})
    if found.has(sp.Float) and not found.free_symbols:
        found = found.evalf(DIGITS)
    return sp.ImmutableMatrix(found)


def augmented(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """[[A, B], [0, 0]], whose exponential has Φ and Γ above."""
    n, m = B.shape
    below = sp.zeros(m, n + m)
    return sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix.hstack(A, B), below))


def held_blocks(held: Held) -> sp.ImmutableMatrix:
    """[[Φ, Γ], [0, I]]."""
    assert held.Gamma is not None  # noqa: S101 - asked of plants with inputs
    n, m = held.Gamma.shape
    above = sp.Matrix.hstack(held.Phi, held.Gamma)
    return sp.ImmutableMatrix(sp.Matrix.vstack(above, sp.Matrix.hstack(sp.zeros(m, n), sp.eye(m))))
