"""The pencil zN − M of a discrete Riccati equation: its determinant, and the linear equations for a solution.

P solves the equation where M [I; P] = N [I; P] A_c with the matrix A_c of its loop. The determinant is reciprocal: with
z it has the root 1/z, and where A is singular z = 0 goes with z = ∞, so that its degree is less than 2n.
"""

from __future__ import annotations

from functools import lru_cache, reduce
from math import comb

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression, in_powers
from solver.exact.linear_algebra.spectrum import irreducible_factors
from solver.exact.optimal.discrete_riccati import DiscreteRiccati
from solver.exact.optimal.in_the_disc import factor_in_z, in_z
from solver.exact.optimal.riccati import RiccatiSolution
from solver.exact.optimal.root_choices import Coefficients, coefficients_of
from solver.exact.optimal.square_roots import RootTower
from solver.exact.optimal.tower_matrices import polynomial_at, shown
from solver.exact.optimal.weighting import block_matrix, weighted_input

Pair = tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]


def symplectic_pencil(equation: DiscreteRiccati) -> Pair:
    """M and N: [A, 0; −Q, I] and [I, G; 0, Aᵀ] with G = BR⁻¹Bᵀ; where R is singular with u beside x and λ.

    Then they are [A, 0, B; −Q, I, 0; 0, 0, R] and [I, 0, 0; 0, Aᵀ, 0; 0, −Bᵀ, 0].
    """
    A, B, Q, R, n, m = equation.A, equation.B, equation.Q, equation.R, equation.order, equation.B.cols
    one, zero, tall, wide = sp.eye(n), sp.zeros(n), sp.zeros(n, m), sp.zeros(m, n)
    if domain_matrix(R).rank() == m:
        return block_matrix([[A, zero], [-Q, one]]), block_matrix([[one, weighted_input(B, R)], [zero, A.T]])
    left = [[A, zero, B], [-Q, one, tall], [wide, wide, R]]
    return block_matrix(left), block_matrix([[one, zero, tall], [zero, A.T, tall], [wide, -B.T, sp.zeros(m)]])


@lru_cache(maxsize=32)
def pencil_polynomial(equation: DiscreteRiccati, z: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """det(zN − M), multiplied out and in its irreducible factors.

    zN − M is (M + N)((z − 1)I − (z + 1)H)/2 (without u), so the factors are those of H, taken from s to z.
    """
    M, N = symplectic_pencil(equation)
    at_minus_one = domain_matrix(sp.ImmutableMatrix(-N - M))
    K = domain_matrix(equation.H).domain.unify(at_minus_one.domain)
    scale, whole, factors = K.convert_from(at_minus_one.det(), at_minus_one.domain), sp.Poly(1, z, domain=K), []
    for q, m in irreducible_factors(equation.H):
        if q.degree() == 1 and coefficients_of(q)[1] == -q.domain.one:  # s = 1 is z = ∞
            continue
        moved = factor_in_z(q).set_domain(K)
        value = sum((c if i % 2 == 0 else -c for i, c in enumerate(reversed(coefficients_of(moved)))), K.zero)
        scale, whole = scale / value**m, whole * sp.Poly(coefficients_of(moved), z, domain=K) ** m
        factors.append(in_powers(coefficients_of(moved), K, z) ** m)
    number = expression(K, scale)
    return (
        in_powers([scale * c for c in coefficients_of(whole)], K, z),
        sp.Mul(number, *sorted(factors, key=sp.default_sort_key)),
    )


def reciprocal_factor(equation: DiscreteRiccati, solution: RiccatiSolution) -> sp.Expr:
    """The number c with det(zN − M) = c p(z) zⁿp(1/z) for the polynomial p of a solution: c = φ(1)/p(1)²."""
    z = sp.Symbol("z")
    value = pencil_polynomial(equation, z)[0].subs(z, 1)
    found = equation.factor_of(solution) if solution.exact else None
    if found is None:
        return value / sp.Add(*solution.polynomial) ** 2
    tower, coefficients = found
    K = domain_matrix(sp.ImmutableMatrix([[value]]))
    at_one = reduce(tower.add, in_z(tower, coefficients))
    number = tower.K.convert_from(K.to_list()[0][0], K.domain)
    return shown(tower, tower.scale(number, tower.inverse(tower.multiply(at_one, at_one))))


def annihilator(equation: DiscreteRiccati, solution: RiccatiSolution) -> sp.ImmutableMatrix | None:
    """E (2n×2n) with E [I; P] = 0: p(S) with S = N⁻¹M where A is regular, else Σ cᵢ Xⁿ⁻ⁱYⁱ, X and Y the `halves`.

    None where p is decimal.
    """
    found = equation.factor_of(solution) if solution.exact else None
    if found is None:
        return None
    tower, coefficients = found
    p, S = in_z(tower, coefficients), equation.symplectic
    if S is None:
        S, p = equation.halves[0], _with_the_rest(tower, p)
    E = polynomial_at(tower, p, domain_matrix(S))
    return sp.ImmutableMatrix([[tower.expression(entry) for entry in row] for row in E])


def _with_the_rest(tower: RootTower, p: Coefficients) -> Coefficients:
    """The coefficients of Σ cᵢ xⁿ⁻ⁱ(1 − x)ⁱ."""
    n = len(p) - 1
    found: Coefficients = [tower.constant(tower.K.zero)] * (n + 1)
    for i, c in enumerate(p):
        for j in range(i + 1):  # xⁿ⁻ⁱ (1 − x)ⁱ has (−1)ʲ (i over j) before xⁿ⁻ⁱ⁺ʲ
            number = tower.K((-1) ** j * comb(i, j))
            found[i - j] = tower.add(found[i - j], tower.scale(number, c))
    return found
