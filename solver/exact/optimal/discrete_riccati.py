"""The discrete Riccati equation P = Q + AᵀPA − AᵀPB (R + BᵀPB)⁻¹ BᵀPA: all its real symmetric solutions.

It has the solutions of a continuous equation. With ξ = x(k+1) + x(k) and η = x(k+1) − x(k), and so for the costate, the
equations of the optimal motion give η = H ξ with a Hamiltonian matrix H, whose blocks have the signs of the continuous
one. A pole z of the loop that P makes is the eigenvalue s = (z − 1)/(z + 1) of H: the unit disc is the left half plane.
So all that is known of H holds here too, but that s = −1, which is z = 0, can't be flipped: its mirror image is z = ∞.
Neither A nor R has to be invertible.
Sources: V. Mehrmann, A step toward a unified treatment of continuous and discrete time control problems, Linear Algebra
and its Applications 241–243 (1996); P. Lancaster, L. Rodman, Algebraic Riccati Equations (1995), chapters 12 and 13.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import chain
from typing import Any, ClassVar

import mpmath
import sympy as sp
from sympy.polys.matrices import DomainMatrix
from sympy.polys.matrices.exceptions import DMNonInvertibleMatrixError

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.linear_algebra.spectrum import irreducible_factors
from solver.exact.optimal.decimal_matrices import rows_of, solution_of
from solver.exact.optimal.in_the_disc import factor_in_z, in_the_disc, in_z, roots_in_z
from solver.exact.optimal.riccati import (
    NotStabilizable,
    Riccati,
    RiccatiSolution,
    decimal_number,
    is_stable,
    readable,
    shared_eigenvectors,
    spelled,
)
from solver.exact.optimal.root_choices import WORKING_DIGITS, Choice, Coefficients, OnTheAxis, coefficients_of
from solver.exact.optimal.spectral_factor import Group, decimal_polynomial, groups_of
from solver.exact.optimal.square_roots import Nested, RootTower
from solver.exact.optimal.tower_matrices import polynomial_at, product_of, quotient_of, shown, solved
from solver.exact.optimal.weighting import block_matrix, weighted_transpose
from solver.exact.structure.ranks import hidden_part


class Undetermined(Exception):  # noqa: N818 - a finding
    """R is singular, and the weights leave the control open."""


@dataclass(frozen=True)
class DiscreteRiccati(Riccati):
    """The equation for A, Q (n×n), B (n×m), R (m×m), with H of s = (z − 1)/(z + 1) and the groups of its eigenvalues.

    G is the block of H that stands for BR⁻¹Bᵀ. Polynomials of solutions and eigenvalues are those in z.
    """

    B: sp.ImmutableMatrix
    R: sp.ImmutableMatrix
    shortest: ClassVar[bool] = True

    @cached_property
    def eigenvalues(self) -> list[sp.Expr]:
        """The eigenvalues of the stabilizing solution's closed loop, by multiplicity."""
        return list(chain.from_iterable(map(_eigenvalues, self.groups)))

    def loop_gain(self, solution: RiccatiSolution) -> sp.ImmutableMatrix:
        """(R + BᵀPB)⁻¹ BᵀPA (m×n) for a solution."""
        return self._gain(solution, self.A)

    def current_gain(self, solution: RiccatiSolution) -> sp.ImmutableMatrix:
        """(R + BᵀPB)⁻¹ BᵀP (m×n) for a solution."""
        return self._gain(solution, sp.ImmutableMatrix(sp.eye(self.order)))

    def _gain(self, solution: RiccatiSolution, A: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
        """(R + BᵀPB)⁻¹ BᵀPA with any A."""
        found = self.factor_of(solution) if solution.exact else None
        if found is not None:
            tower, coefficients = found
            P = solved(tower, polynomial_at(tower, coefficients, domain_matrix(self.H)))
            return self._gain_over(tower, P, A)
        with mpmath.workdps(WORKING_DIGITS):
            a, b, r, p = (sp.Matrix(rows_of(M, WORKING_DIGITS)) for M in (A, self.B, self.R, solution.P))
            gain = solution_of(*(M.tolist() for M in (r + b.T * p * b, b.T * p * a)))
            return sp.ImmutableMatrix([[decimal_number(entry) for entry in row] for row in gain])

    def gain(
        self, _B: sp.ImmutableMatrix, R: sp.ImmutableMatrix, N: sp.ImmutableMatrix | None = None
    ) -> sp.ImmutableMatrix:
        """(R + BᵀPB)⁻¹ BᵀPA + R⁻¹Nᵀ (m×n) for the stabilizing solution, N n×m (None: zero)."""
        K = self.loop_gain(self.stabilizing)
        return K if N is None else sp.ImmutableMatrix((K + weighted_transpose(N, R)).expand())

    def _gain_over(self, tower: RootTower, P: list[list[Nested]], plant: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
        whole = domain_matrix(block_matrix([[plant, self.B], [sp.zeros(self.R.rows, plant.cols), self.R]]))
        if not whole.domain.is_QQ and whole.domain.unify(tower.K) != tower.K:
            return self._gain_of(sp.Matrix([[shown(tower, entry) for entry in row] for row in P]), plant)
        lifted = [[tower.constant(c) for c in row] for row in whole.convert_to(tower.K).to_list()]
        n, m = self.order, self.B.cols
        A, B, R = ([row[:n] for row in lifted[:n]], [row[n:] for row in lifted[:n]], [row[n:] for row in lifted[n:]])
        BtP = product_of(tower, [list(column) for column in zip(*B, strict=True)], P)
        seen = product_of(tower, BtP, B)
        weight = [[tower.add(R[i][j], seen[i][j]) for j in range(m)] for i in range(m)]
        gain = quotient_of(tower, weight, product_of(tower, BtP, A))
        return sp.ImmutableMatrix([[shown(tower, entry) for entry in row] for row in gain])

    def _gain_of(self, P: sp.Matrix, plant: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
        """The gain where B or R has roots that the equation does not have."""
        weight, right = (M.expand() for M in (self.R + self.B.T * P * self.B, self.B.T * P * plant))
        by = sp.radsimp(1 / sp.expand(weight.det()))
        return sp.ImmutableMatrix((weight.adjugate() * right * by).expand())

    @property
    def unreached(self) -> bool:
        """Whether the input leaves a mode other than zero where it is."""
        return any(keep and not _is_zero(group) for group, keep in zip(self.groups, self.fixed, strict=True))

    @cached_property
    def symplectic(self) -> sp.ImmutableMatrix | None:
        """S (2n×2n) with x(k+1), λ(k+1) from x(k), λ(k); its eigenvalues hold the poles. None if A is singular."""
        H = domain_matrix(self.H)
        one = DomainMatrix.eye(H.shape, H.domain).to_dense()
        try:
            return matrix_of((one - H).lu_solve(one + H))
        except DMNonInvertibleMatrixError:
            return None

    @cached_property
    def halves(self) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
        """X = (I + H)/2 and Y = (I − H)/2, with X [I; P] = Y [I; P] A_c for the matrix A_c of the loop, and XY = YX."""
        one = sp.eye(2 * self.order)
        return sp.ImmutableMatrix((one + self.H) / 2), sp.ImmutableMatrix((one - self.H) / 2)

    def _polynomial_of_the_loop(self, tower: RootTower, p: Coefficients) -> Coefficients:
        return in_z(tower, p)

    def _decimals_of_the_loop(self, choices: tuple[Choice, ...]) -> list[Any]:
        with mpmath.workdps(WORKING_DIGITS):
            return decimal_polynomial([replace(c, roots=tuple(map(in_the_disc, c.roots))) for c in choices])


def discrete_riccati(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix
) -> DiscreteRiccati:
    """Return the equation for A n×n, B n×m, Q n×n ≥ 0, R m×m ≥ 0, ready to be solved.

    Raises NotStabilizable, OnTheAxis (there are eigenvalues on the unit circle; its factor is one in z), Undetermined,
    NotExact.
    """
    return _discrete_riccati(*map(sp.ImmutableMatrix, (A, B, Q, R)))


@lru_cache(maxsize=32)
def _discrete_riccati(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix
) -> DiscreteRiccati:
    hidden = hidden_part(A, B)
    unstable = [mode for mode in hidden.spectrum.eigenvalues if not is_stable(mode, discrete=True)] if hidden else []
    if unstable:
        raise NotStabilizable(unstable)
    H = _hamiltonian(A, B, Q, R)
    try:
        groups = tuple(groups_of(irreducible_factors(H)))
    except OnTheAxis as finding:
        raise OnTheAxis(factor_in_z(finding.factor)) from finding
    K, moved = domain_matrix(H), _moved(hidden.H) if hidden else None
    shared = [shared_eigenvectors(group, K, moved) for group in groups]
    kept = [reached == 0 or _is_zero(group) for group, (_, reached) in zip(groups, shared, strict=True)]
    endless = tuple(own > 1 and not keep for (own, _), keep in zip(shared, kept, strict=True))
    n = A.rows
    return DiscreteRiccati(A, sp.ImmutableMatrix(-H[:n, n:]), Q, H, groups, tuple(kept), endless, B, R)


def _hamiltonian(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix
) -> sp.ImmutableMatrix:
    """H with η = H ξ: (I + A)η − 2Bu = (A − I)ξ, (I + Aᵀ)ν − Qη = (I − Aᵀ)μ − Qξ, Bᵀν + 2Ru = −Bᵀμ."""
    n, m = B.shape
    one, zero = sp.eye(n), sp.zeros(n)
    left = [[one + A, zero, -2 * B], [-Q, one + A.T, sp.zeros(n, m)], [sp.zeros(m, n), B.T, 2 * R]]
    right = [[A - one, zero], [-Q, one - A.T], [sp.zeros(m, n), -B.T]]
    wide = block_matrix([[block_matrix(left), block_matrix(right)]])
    both, size = domain_matrix(wide), 2 * n + m
    try:
        return matrix_of(both[:, :size].lu_solve(both[:, size:])[: 2 * n, :])
    except DMNonInvertibleMatrixError:
        pass
    if _at(A, B, Q, R, sp.Integer(2)) == 0 == _at(A, B, Q, R, sp.Integer(3)):
        raise Undetermined
    z = sp.Dummy("z")
    raise OnTheAxis(sp.Poly(z + 1, z))


def _at(A: Any, B: Any, Q: Any, R: Any, z: sp.Integer) -> Any:
    """The determinant of the equations of the optimal motion x(k) = zᵏ x, λ(k) = zᵏ λ, u(k) = zᵏ u."""
    n, m = B.shape
    one = sp.eye(n)
    blocks = [[z * one - A, sp.zeros(n), -B], [-Q, one - z * A.T, sp.zeros(n, m)], [sp.zeros(m, n), z * B.T, R]]
    whole = domain_matrix(block_matrix(blocks))
    return whole.domain.to_sympy(whole.det())


def _is_zero(group: Group) -> bool:
    """Whether the root is s = −1, which is z = 0."""
    q = group.factor
    return q.degree() == 1 and coefficients_of(q)[1] == q.domain.one


def _moved(M: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """(M + I)⁻¹ (M − I) for M with stable eigenvalues."""
    found = domain_matrix(M)
    one = DomainMatrix.eye(found.shape, found.domain).to_dense()
    return matrix_of((found + one).lu_solve(found - one))


def _eigenvalues(group: Group) -> tuple[sp.Expr, ...]:
    found, choice = roots_in_z(group), group.choices[0]
    if found and (not choice.roots or all(map(readable, found))):
        return found
    with mpmath.workdps(WORKING_DIGITS):
        return tuple(spelled(replace(choice, roots=tuple(map(in_the_disc, choice.roots)), spelled=())))
