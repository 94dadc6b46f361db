"""The algebraic Riccati equation AᵀP + PA − PGP + Q = 0: all its real symmetric solutions, and the stabilizing one.

P solves it if and only if the graph of P, the columns of [I; P], is invariant under the Hamiltonian matrix
H = [[A, −G], [−Q, −Aᵀ]]. Its spectrum is symmetric to the imaginary axis; a real symmetric P corresponds to a real
polynomial p of degree n with p(s) p(−s) = (−1)ⁿ det(sI − H), and p(H) [I; P] = 0 is linear in P. The Hurwitz p gives
the stabilizing solution. There are finitely many solutions unless an eigenvalue that can be flipped has two independent
eigenvectors; eigenvalues that the input does not reach can't be flipped.
Sources: J. C. Willems, Least squares stationary optimal control and the algebraic Riccati equation, IEEE TAC 16 (1971);
P. Lancaster, L. Rodman, Algebraic Riccati Equations (1995), chapters 7 and 8.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache, reduce
from itertools import chain
from typing import Any, ClassVar

import mpmath
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import NotExact, domain_matrix, matrix_of
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.linear_algebra.spectrum import irreducible_factors
from solver.exact.optimal.decimal_matrices import Rows, combined, powers_of, rows_of, solution_of
from solver.exact.optimal.root_choices import DIGITS, WORKING_DIGITS, Choice, Coefficients
from solver.exact.optimal.spectral_factor import Group, combinations, decimal_polynomial, exact_polynomial, groups_of
from solver.exact.optimal.square_roots import RootTower
from solver.exact.optimal.tower_matrices import polynomial_at, shown, solved
from solver.exact.optimal.weighting import weighted_input, weighted_transpose
from solver.exact.structure.controllability import controllability_matrix
from solver.exact.structure.ranks import hidden_part

MOST_ENTRIES = 1024
"""Solutions are listed as long as they have no more entries together (n = 5: 40 solutions, n = 8: 16)."""
LARGEST_NUMBER = 10**5
LONGEST_ENTRY = 90
"""Characters of an entry with nested roots that still is readable; beyond, decimals say more."""

LONGEST_WITH_PARAMETERS = 1000
"""Characters of an entry with parameters, for which there are no decimals."""


class NotStabilizable(Exception):  # noqa: N818 - a finding
    """Modes that the input does not reach are not asymptotically stable; `modes` are their eigenvalues."""

    def __init__(self, modes: list[sp.Expr]) -> None:
        super().__init__(str(modes))
        self.modes = modes


@dataclass(frozen=True)
class RiccatiSolution:
    """A solution P with p = det(sI − A + GP) (coefficients, highest power first), and how many roots of p are unstable.

    `exact` is False where P is given in decimals. `radicand` must be positive for P to be real (None: it always is).
    """

    P: sp.ImmutableMatrix
    polynomial: tuple[sp.Expr, ...]
    flips: int
    exact: bool
    choices: tuple[Choice, ...]
    radicand: sp.Expr | None = None


@dataclass(frozen=True)
class Riccati:
    """The equation for A, G, Q (n×n) with its Hamiltonian matrix H, and the groups of the roots of its χ.

    `fixed` says of each group whether its roots can't be flipped, `endless` whether it makes the solutions a continuum.
    """

    A: sp.ImmutableMatrix
    G: sp.ImmutableMatrix
    Q: sp.ImmutableMatrix
    H: sp.ImmutableMatrix
    groups: tuple[Group, ...]
    fixed: tuple[bool, ...]
    endless: tuple[bool, ...]
    shortest: ClassVar[bool] = False

    @property
    def order(self) -> int:
        """The number n of states."""
        return int(self.A.rows)

    @cached_property
    def stabilizing(self) -> RiccatiSolution:
        """The solution for which A − GP is Hurwitz; there is one and only one."""
        return self._solution(tuple(group.choices[0] for group in self.groups))

    @property
    def count(self) -> int | None:
        """How many real symmetric solutions there are (with parameters: at most); None: endless."""
        if any(self.endless):
            return None
        options = (1 if keep else len(group.choices) for group, keep in zip(self.groups, self.fixed, strict=True))
        return int(sp.prod(options))

    @property
    def listable(self) -> bool:
        """Whether the solutions are so few that they can be listed."""
        return self.count is not None and self.count * self.order**2 <= MOST_ENTRIES

    @cached_property
    def solutions(self) -> tuple[RiccatiSolution, ...]:
        """All real symmetric solutions, the stabilizing one first; raises NotExact if they are endless or too many."""
        if not self.listable:
            raise NotExact("optimal/too_many_solutions")
        found = (self._solution(choices) for choices in combinations(self.groups, self.fixed))
        return (self.stabilizing, *list(found)[1:])

    @cached_property
    def eigenvalues(self) -> list[sp.Expr]:
        """The eigenvalues of the stabilizing solution's closed loop A − GP, by multiplicity."""
        return list(chain.from_iterable(map(spelled, (group.choices[0] for group in self.groups))))

    def gain(
        self, B: sp.ImmutableMatrix, R: sp.ImmutableMatrix, N: sp.ImmutableMatrix | None = None
    ) -> sp.ImmutableMatrix:
        """K = R⁻¹ (Bᵀ P + Nᵀ) (m×n) of the stabilizing solution, N n×m (None: zero)."""
        P, W = self.stabilizing.P, weighted_transpose(B, R)
        cross = weighted_transpose(N, R) if N is not None else sp.ImmutableMatrix(sp.zeros(*W.shape))
        found = self.factor_of(self.stabilizing) if P.free_symbols else None
        if found is None:
            return sp.ImmutableMatrix((W * P + cross).expand())
        tower, coefficients = found
        K = tower.K
        entries = solved(tower, polynomial_at(tower, coefficients, domain_matrix(self.H)))
        weights, constant = domain_matrix(W).unify(domain_matrix(cross))
        if weights.domain.unify(K) != K:
            return sp.ImmutableMatrix((W * P + cross).expand())
        rows = [
            [
                reduce(tower.add, (tower.scale(w, entries[k][j]) for k, w in enumerate(row)), tower.constant(added[j]))
                for j in range(self.order)
            ]
            for row, added in zip(weights.convert_to(K).to_list(), constant.convert_to(K).to_list(), strict=True)
        ]
        return sp.ImmutableMatrix([[shown(tower, entry) for entry in row] for row in rows])

    def polynomial_of_hamiltonian(self, solution: RiccatiSolution) -> sp.ImmutableMatrix | None:
        """p(H) (2n×2n), exact, or None where p is decimal."""
        found = self.factor_of(solution)
        if found is None:
            return None
        tower, coefficients = found
        E = polynomial_at(tower, coefficients, domain_matrix(self.H))
        return sp.ImmutableMatrix([[tower.expression(entry) for entry in row] for row in E])

    @cached_property
    def observable(self) -> bool:
        """Whether (A, Q) is observable (in general); then P has as many negative eigenvalues as p unstable roots."""
        seen = controllability_matrix(sp.ImmutableMatrix(self.A.T), self.Q)
        return bool(domain_matrix(seen).rank() == self.order)

    def family(self, tau: sp.Symbol) -> tuple[sp.ImmutableMatrix, sp.Expr] | None:
        """Return solutions with a parameter τ, and the eigenvalue λ of A − GP₊ that makes them; None if not simple.

        P₊ + 2λ wᵀw/(w G wᵀ) for a left eigenvector w = w₁ + τ w₂ of a real eigenvalue that has two independent ones.
        """
        n = self.order
        A, G = self.H[:n, :n], -self.H[:n, n:]
        loop = sp.ImmutableMatrix((A - G * self.stabilizing.P).expand())
        for group, endless in zip(self.groups, self.endless, strict=True):
            roots = group.choices[0].spelled
            if not endless or not roots or roots[0].has(sp.I) or not self.stabilizing.exact:
                continue
            pencil = domain_matrix(sp.ImmutableMatrix((loop.T - roots[0] * sp.eye(n)).expand()))
            rows = matrix_of(pencil.nullspace())
            if rows.rows > 1:
                w = rows[0, :] + tau * rows[1, :]
                weight = sp.expand((w * G * w.T)[0, 0])
                change = (w.T * w).applyfunc(lambda entry, at=roots[0], by=weight: sp.factor(2 * at * entry / by))
                return sp.ImmutableMatrix(self.stabilizing.P + change), roots[0]
        return None

    def _solution(self, choices: tuple[Choice, ...]) -> RiccatiSolution:
        flips = sum(choice.flips for choice in choices)
        radicand = next((choice.radicand for choice in choices if choice.radicand is not None), None)
        H = domain_matrix(self.H)
        found = exact_polynomial(H.domain, choices, shortest=self.shortest)
        if found is not None:
            tower, p = found
            entries = solved(tower, polynomial_at(tower, p, H))
            P = [[shown(tower, entry) for entry in row] for row in entries]
            longest = max(len(str(entry)) for entry in chain.from_iterable(P))
            if self.H.free_symbols and longest > LONGEST_WITH_PARAMETERS:
                raise NotExact("optimal/parameters")
            if self.H.free_symbols or all(map(readable, chain.from_iterable(P))):
                shown_p = tuple(shown(tower, c) for c in self._polynomial_of_the_loop(tower, p))
                return RiccatiSolution(sp.ImmutableMatrix(P), shown_p, flips, True, choices, radicand)
        if self.H.free_symbols:
            raise NotExact("optimal/parameters")
        return RiccatiSolution(*self._in_decimals(choices), flips, False, choices)

    def factor_of(self, solution: RiccatiSolution) -> tuple[RootTower, Coefficients] | None:
        """The factor of det(sI − H) that makes a solution, over a tower of roots; None where it is decimal."""
        return exact_polynomial(domain_matrix(self.H).domain, solution.choices, shortest=self.shortest)

    def _polynomial_of_the_loop(self, _tower: RootTower, p: Coefficients) -> Coefficients:
        """The characteristic polynomial of the loop from the factor p of that of H: the same."""
        return p

    def _decimals_of_the_loop(self, choices: tuple[Choice, ...]) -> list[Any]:
        return decimal_polynomial(choices)

    def _in_decimals(self, choices: tuple[Choice, ...]) -> tuple[sp.ImmutableMatrix, tuple[sp.Expr, ...]]:
        """P and p to many digits, by the same linear equations."""
        n, p = self.order, decimal_polynomial(choices)
        with mpmath.workdps(WORKING_DIGITS):
            E = combined(self._powers_in_decimals, p)
            X = solution_of([row[n:] for row in E], [[-entry for entry in row[:n]] for row in E])
            P = [[decimal_number((X[i][j] + X[j][i]) / 2) for j in range(n)] for i in range(n)]
            return sp.ImmutableMatrix(P), tuple(map(decimal_number, self._decimals_of_the_loop(choices)))

    @cached_property
    def _powers_in_decimals(self) -> list[Rows]:
        """I, H, …, Hⁿ, the same for all solutions."""
        with mpmath.workdps(WORKING_DIGITS):
            return powers_of(rows_of(self.H, WORKING_DIGITS), self.order)


def riccati(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix) -> Riccati:
    """Return the equation AᵀP + PA − P B R⁻¹ Bᵀ P + Q = 0 (A n×n, B n×m, Q n×n ≥ 0, R m×m > 0), ready to be solved.

    Raises NotStabilizable, OnTheAxis (H has eigenvalues on the imaginary axis), NotExact.
    """
    return _riccati(*map(sp.ImmutableMatrix, (A, B, Q, R)))


@lru_cache(maxsize=32)
def _riccati(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix) -> Riccati:
    G = weighted_input(B, R)
    H = sp.ImmutableMatrix(sp.Matrix(sp.BlockMatrix([[A, -G], [-Q, -A.T]])))
    hidden = hidden_part(A, B)
    unstable = [mode for mode in hidden.spectrum.eigenvalues if not is_stable(mode)] if hidden else []
    if unstable:
        raise NotStabilizable(unstable)
    groups = tuple(groups_of(irreducible_factors(H)))
    K = domain_matrix(H)
    shared = [shared_eigenvectors(group, K, hidden.H if hidden else None) for group in groups]
    fixed = tuple(reached == 0 for _, reached in shared)
    endless = tuple(own > 1 and reached > 0 for own, reached in shared)
    return Riccati(A, G, Q, H, groups, fixed, endless)


def is_stable(root: sp.Expr, *, discrete: bool = False) -> bool:
    """Whether the real part is negative (the modulus below one); raises NotExact where parameters leave it open."""
    if not root.free_symbols:
        return bool(sp.N(sp.Abs(root) - 1 if discrete else sp.re(root), DIGITS) < 0)
    signs = possible_signs(sp.expand(root**2 - 1) if discrete else root)
    if len(signs) == 1 or -1 not in signs:
        return signs == {-1}
    raise NotExact("optimal/unreached_mode", mode=root)


def shared_eigenvectors(group: Group, H: DomainMatrix, hidden: sp.ImmutableMatrix | None) -> tuple[int, int]:
    """Return how many independent eigenvectors an eigenvalue of the group has, and how many of these are reached."""
    own = 1 if group.multiplicity == 1 else _nullity(group.factor, H)
    lost = _nullity(group.factor, domain_matrix(hidden)) if hidden is not None and not group.even else 0
    return own, own - lost


def _nullity(q: sp.Poly, M: DomainMatrix) -> int:
    """Dim ker q(M) / deg q: the independent eigenvectors of M for one root of q."""
    K = M.domain.unify(q.domain)
    M = M.convert_to(K)
    value = DomainMatrix.zeros(M.shape, K).to_dense()
    identity = DomainMatrix.eye(M.shape[0], K).to_dense()
    for c in q.set_domain(K).rep.to_list():
        value = value * M + identity * K.convert(c)
    return int((M.shape[0] - value.rank()) // q.degree())


def readable(entry: sp.Expr) -> bool:
    """Whether a person would write the entry with its roots: it is not long, and has no large numbers."""
    if len(str(entry)) > LONGEST_ENTRY:
        return False
    numbers = [part for number in entry.atoms(sp.Rational) for part in (abs(number.p), number.q)]
    return entry.is_Rational or max(numbers, default=0) < LARGEST_NUMBER


def spelled(choice: Choice) -> Iterator[sp.Expr]:
    """The roots as expressions, in decimals where these are not readable."""
    if choice.spelled and (not choice.roots or all(map(readable, choice.spelled))):
        yield from choice.spelled
        return
    for z in choice.roots:
        real, imaginary = mpmath.re(z), mpmath.im(z)
        yield decimal_number(real) + sp.I * decimal_number(imaginary) if imaginary else decimal_number(real)


def decimal_number(x: Any) -> sp.Float:
    """A number of mpmath with the digits of results."""
    return sp.Float(x, DIGITS)
